import { describe, expect, it } from 'vitest';
import { compare } from '../bench/report/compare.mjs';
import { median, quantile, spread } from '../bench/report/figures.mjs';
import { tablesOf } from '../bench/report/markdown.mjs';
import { tidy, type Results } from '../bench/report/results.mjs';
import type { SuiteRow } from '../bench/suites/suite.js';

const row = (contestant: string, samples: number[], more: Partial<SuiteRow> = {}): SuiteRow => ({
  case: '10k',
  contestant,
  figure: 'a step, ms',
  samples,
  ...more,
});

const results = (...rows: SuiteRow[]): Results => ({
  suites: {
    step: {
      date: '',
      machine: '',
      versions: {},
      options: { repeats: 5, quick: false, levels: [] },
      rows,
    },
  },
});

describe('what the benchmarks tell', () => {
  it('should take medians and quantiles between samples', () => {
    expect(median([3, 1, 2])).toBe(2);
    expect(median([4, 1, 2, 3])).toBe(2.5);
    expect(quantile([0, 10], 0.95)).toBeCloseTo(9.5, 12);
    expect(spread([1, 2, 3, 4, 5])).toEqual([2, 4]);
    expect(quantile([], 0.5)).toBeNaN();
  });

  it('should put ours first, and say how many times ours the others are, and who cannot', () => {
    const [text] = tablesOf([
      row('Octree', [40, 50, 60]),
      row('three-cube-collider, WebGL2', [5]),
      row('Rapier', [], { note: 'cannot' }),
      row('three-mesh-bvh', [1], { case: '10M' }),
    ]);
    expect(text!.split('\n')).toEqual([
      '| a step, ms | 10k | 10M |',
      '| --- | --: | --: |',
      '| three-cube-collider, WebGL2 | 5 | - |',
      '| Octree | 50 (45 to 55) ×10 | - |',
      '| Rapier | cannot | - |',
      '| three-mesh-bvh | - | 1 |',
    ]);
  });

  it('should turn a table of many cases, and tell nothing of rounding', () => {
    const cases = [1, 2, 3, 4, 5, 6, 7].map((hz) =>
      row('Octree', [1e-13, -1e-13], { case: `${hz} Hz`, figure: 'jerk, m/s³' }),
    );
    const [text] = tablesOf(cases);
    expect(text!.split('\n').slice(0, 3)).toEqual([
      '| jerk, m/s³ | Octree |',
      '| --- | --: |',
      '| 1 Hz | 0 |',
    ]);
  });

  it('should mark what got over a tenth worse, whichever way is worse', () => {
    const fps = { figure: 'frames a second' };
    const before = results(row('a', [100]), row('b', [60], fps), row('c', [100]), row('d', [1]));
    const now = results(row('a', [111]), row('b', [53], fps), row('c', [109]), row('d', []));
    const { text, worse } = compare(now, before);
    expect(worse).toBe(3);
    expect(text.split('\n').filter((line) => line.includes('WORSE')).length).toBe(3);
    expect(compare(results(row('new', [1])), before).worse).toBe(0);
  });

  it('should keep few of many samples, with the same quantiles', () => {
    const samples = Array.from({ length: 5000 }, (_, i) => (i * 7919) % 5000);
    const kept = tidy(row('a', samples)).samples;
    expect(kept.length).toBeLessThan(200);
    for (const q of [0, 0.05, 0.5, 0.95, 1]) {
      expect(Math.abs(quantile(kept, q) - quantile(samples, q))).toBeLessThan(2);
    }
    expect(tidy(row('a', [1.23456])).samples).toEqual([1.235]);
  });
});
