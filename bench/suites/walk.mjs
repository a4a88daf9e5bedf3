// @ts-check
import { walkAll } from '../walk/walkAll.mjs';

/** @typedef {import('./suite.js').SuiteRow} SuiteRow */

/** What every walker is called in all suites. @type {Record<string, string>} */
const NAMES = {
  cube: 'three-cube-collider, WebGL2',
  octree: 'Octree',
  'mesh-bvh': 'three-mesh-bvh',
  rapier: 'Rapier',
};

/** @type {Record<string, (walk: any) => number>} */
const FIGURES = {
  'penetration p50, mm': ({ penetration }) => 1000 * penetration.p50,
  'penetration p99, mm': ({ penetration }) => 1000 * penetration.p99,
  'penetration p99.9, mm': ({ penetration }) => 1000 * penetration.p999,
  'penetration max, mm': ({ penetration }) => 1000 * penetration.max,
  'surfaces crossed': ({ crossed }) => crossed,
  'falls through a surface': ({ fellThrough }) => fellThrough,
  'way, m': ({ distance }) => distance,
};

/** @type {import('./list.mjs').NodeSuite} */
export const walk = {
  name: 'walk',
  title: 'Walking levels',
  about: `One capsule, radius 0.35 m, 1.8 m high, wanting 5 m/s, walks by the same seeded inputs with each of them; after every
frame an exact judge measures how deep it is in the nearest triangle (negative: a gap, which ours and Rapier's keep on
purpose). 3000 frames a walk, ours read synchronously; [accuracy.md](accuracy.md) has longer walks, late read-backs and the
other renderers, and says how the judge works. _Way_ tells that nobody stood still to do well.`,
  plot: 'penetration max, mm',
  seen: 6,
  async run({ files, options: { quick } }) {
    const { levels } = await walkAll({
      levels: files,
      hz: quick ? [60] : [20, 30, 60, 144],
      steps: quick ? 300 : 3000,
      latency: [0],
      asyncSteps: 0,
      'real-async': false,
      seed: 1,
      leg: 4,
      rivals: true,
      backend: ['WebGL2'],
      collider: {},
      character: {},
      start: undefined,
      trace: undefined,
      json: undefined,
    });
    return { rows: levels.flatMap((level) => [...rowsOf(level)]) };
  },
};

/** @param {{ name: string, rows: any[] }} level @returns {Generator<SuiteRow>} */
function* rowsOf(level) {
  for (const result of level.rows) {
    const { mover, hz } = result;
    for (const [figure, value] of Object.entries(FIGURES)) {
      const of = `${level.name}, ${hz} Hz`;
      yield { case: of, contestant: NAMES[mover], figure, samples: [value(result)] };
    }
  }
}
