// @ts-check
import measure from '../size/suite.mjs';

/** @typedef {import('./suite.js').SuiteRow} SuiteRow */

const [FIND, DRAW, BYTES, WORK] = [
  'to find what is near, ms',
  'a draw and its read, ms',
  'heap, bytes a triangle',
  'our own work a frame, ms',
];

/** @type {import('./list.mjs').NodeSuite} */
export const size = {
  name: 'size',
  title: 'Many objects, huge meshes, streamed tiles',
  about: `Ours alone, beside the plain way to do the same: all objects walked over, all triangles drawn. What is measured, and
all of it, is in [size.md](size.md).`,
  plot: FIND,
  async run({ only, seconds, options: { quick } }) {
    const { text, results } = await measure({ only, seconds: quick ? '2' : seconds });
    return { rows: [...rowsOf(results)], text };
  },
};

/** @param {Record<string, any>} results @returns {Generator<SuiteRow>} */
function* rowsOf({ many = [], huge = [], stream = [] }) {
  const ours = 'three-cube-collider';
  for (const { objects, survey, select, walk } of many) {
    const of = { case: `${short(objects)} meshes`, figure: FIND };
    yield { ...of, contestant: `${ours}, a survey`, samples: survey };
    yield { ...of, contestant: `${ours}, a selection`, samples: select };
    yield { ...of, contestant: 'a walk over all objects', samples: walk };
  }
  for (const { triangles, shuffled, draw, whole, bytes } of huge) {
    const of = { case: `${short(triangles)} triangles${shuffled ? ', shuffled' : ''}` };
    yield { ...of, contestant: ours, figure: DRAW, samples: draw };
    if (whole.length > 0) {
      yield { ...of, contestant: 'all triangles drawn', figure: DRAW, samples: whole };
    }
    if (bytes > 0) yield { ...of, contestant: ours, figure: BYTES, samples: [bytes] };
  }
  for (const { tiles, own } of stream) {
    yield {
      case: `${tiles} tiles come and go a frame`,
      contestant: ours,
      figure: WORK,
      samples: own,
    };
  }
}

/** As the other suites name sizes: 100k, 5M. @param {number} count */
function short(count) {
  if (count < 1000) return String(count);
  const [unit, letter] = count < 950_000 ? [1000, 'k'] : [1e6, 'M'];
  return `${Math.round(count / unit)}${letter}`;
}
