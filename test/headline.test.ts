import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { headline } from '../bench/headline.mjs';
import { readResults, RESULTS } from '../bench/report/results.mjs';

const [BEGIN, END] = ['<!-- headline:begin -->', '<!-- headline:end -->'];

describe('README’s headline', () => {
  it('should be what the results give: npm run bench -- --from bench/results.json', () => {
    const readme = readFileSync('README.md', 'utf8');
    expect(readme).toContain(BEGIN);
    const block = readme.split(BEGIN)[1]!.split(END)[0]!.trim();
    expect(block).toBe(headline(readResults(RESULTS)));
  });

  it('should leave out what was not measured', () => {
    expect(headline({ suites: {} })).toBe('');
  });

  it('should tell medians, and how many times ours the others are', () => {
    const row = { case: '1M triangles', figure: 'blocking, ms' };
    const text = headline({
      suites: {
        load: {
          date: '',
          machine: '',
          versions: {},
          options: { repeats: 3, quick: false, levels: [] },
          rows: [
            { ...row, contestant: 'three-cube-collider, WebGL2', samples: [9, 4, 5] },
            { ...row, contestant: 'three-mesh-bvh', samples: [400, 500, 600] },
            { ...row, contestant: 'Octree', samples: [4000], note: 'extrapolated from 100k' },
          ],
        },
      },
    });
    expect(text).toBe(
      '- Loading 1M triangles blocks the page for **5 ms**; three-mesh-bvh 500 (×100); ' +
        'Octree 4000 (×800, extrapolated from 100k).',
    );
  });
});
