// @ts-check
import { openPage } from '../page.mjs';
import { median, quantile } from '../report/figures.mjs';

/** @typedef {import('./suite.js').SuiteRow} SuiteRow */

/** GPU milliseconds of the page's own frame. */
const LOADS = { light: 3, 'just GPU-bound': 9, 'badly GPU-bound': 40 };
const [WEBGL, NODES] = ['/bench/readback.ts', '/bench/readbackNodes.ts'];
/** Who keeps the frame rate of its own renderer's page alone. */
const ALONE = {
  WebGL2: 'the page alone, WebGLRenderer',
  WebGPU: 'the page alone, WebGPU',
  fallback: 'the page alone, fallback',
};
/** @type {Record<string, { module: string, argument: object, alone?: string }>} */
const CONTESTANTS = {
  'three-cube-collider, WebGL2': {
    module: WEBGL,
    argument: { mode: 'async' },
    alone: ALONE.WebGL2,
  },
  'three-cube-collider, WebGL2, sync': {
    module: WEBGL,
    argument: { mode: 'sync' },
    alone: ALONE.WebGL2,
  },
  'three-cube-collider, WebGPU': {
    module: NODES,
    argument: { mode: 'WebGPU' },
    alone: ALONE.WebGPU,
  },
  'three-cube-collider, fallback': {
    module: NODES,
    argument: { mode: 'fallback' },
    alone: ALONE.fallback,
  },
  'a fenced buffer, copied at the next frame': {
    module: WEBGL,
    argument: { mode: 'fenced' },
    alone: ALONE.WebGL2,
  },
  [ALONE.WebGL2]: { module: WEBGL, argument: { mode: 'none' } },
  [ALONE.WebGPU]: { module: NODES, argument: { mode: 'WebGPU', bare: true } },
  [ALONE.fallback]: { module: NODES, argument: { mode: 'fallback', bare: true } },
};

/** @param {readonly number[]} list */
const sum = (list) => list.reduce((total, each) => total + each, 0);
/** @param {any} result */
const framesASecond = ({ frame }) => (1000 * frame.length) / sum(frame);

/** @type {Record<string, (result: any) => number>} what one run tells, NaN where it read nothing */
const FIGURES = {
  'blocked a read, median, ms': ({ blocked }) => median(blocked),
  'blocked a read, p95, ms': ({ blocked }) => quantile(blocked, 0.95),
  'blocked a frame, mean, ms': ({ blocked, frame }) =>
    blocked.length > 0 ? sum(blocked) / frame.length : NaN,
  'from draw to field, ms': ({ latency }) => median(latency),
  'from draw to field, frames': ({ latencyFrames }) => median(latencyFrames),
  'reads a frame': ({ blocked, frame }) =>
    blocked.length > 0 ? blocked.length / frame.length : NaN,
  'frames a second': framesASecond,
};
const KEPT = 'frame rate kept, %';

/** @type {import('./list.mjs').NodeSuite} */
export const latency = {
  name: 'latency',
  title: 'Reading back',
  about: `A page that draws a frame of a given cost (3, 9 and 40 ms of the GPU, on a screen of 60 Hz) and, in every frame, a
cubemap of 32² faces that is read back: 96 KiB. The reach and the age that would force a read are out of the way. Beside
ours on each renderer, and ours read synchronously: a pixel-pack buffer whose fence is awaited, which is what most do; and
the page without any of it, by which _frame rate kept_ is told, from runs one after the other.`,
  plot: 'blocked a frame, mean, ms',
  async run({ options: { quick, repeats }, tell }) {
    const frames = quick ? 20 : 60;
    /** @type {Map<string, SuiteRow>} */
    const rows = new Map();
    for (let repeat = 0; repeat < repeats; repeat++) {
      // A page each, which calibrates anew: contexts are not let go of at once, and a browser has few.
      const page = await openPage();
      try {
        for (const [name, load] of Object.entries(LOADS)) {
          tell(`repeat ${repeat + 1} of ${repeats}, ${name}`);
          const results = await runAll(page.run, repeat, { load, frames });
          for (const row of rowsOf(`${name} (${load} ms)`, results)) add(rows, row);
        }
      } finally {
        await page.close();
      }
    }
    for (const row of rows.values()) if (row.samples.length === 0) row.note = 'no read came';
    return { rows: [...rows.values()] };
  },
};

/**
 * All contestants once, each time another first.
 *
 * @param {(module: string, argument: unknown) => Promise<any>} run
 * @param {number} repeat
 * @param {{ load: number, frames: number }} settings
 */
async function runAll(run, repeat, settings) {
  const names = Object.keys(CONTESTANTS);
  /** @type {Record<string, any>} */
  const results = {};
  for (let i = 0; i < names.length; i++) {
    const name = names[(i + repeat) % names.length];
    const { module, argument } = CONTESTANTS[name];
    results[name] = await run(module, { ...argument, ...settings });
  }
  return results;
}

/**
 * @param {string} of the case
 * @param {Record<string, any>} results
 * @returns {Generator<SuiteRow>} of one repeat
 */
function* rowsOf(of, results) {
  for (const [contestant, { alone }] of Object.entries(CONTESTANTS)) {
    const result = results[contestant];
    /** @param {string} figure @param {number} value */
    const row = (figure, value) => ({ case: of, contestant, figure, samples: [value] });
    for (const [figure, value] of Object.entries(FIGURES)) {
      const sample = value(result);
      // The page alone has nothing to read; others may have had no time for it.
      if (Number.isFinite(sample)) yield row(figure, sample);
      else if (alone) yield { ...row(figure, 0), samples: [] };
    }
    if (alone === undefined) continue;
    yield row(KEPT, (100 * framesASecond(result)) / framesASecond(results[alone]));
  }
}

/** @param {Map<string, SuiteRow>} rows @param {SuiteRow} row */
function add(rows, row) {
  const key = [row.case, row.contestant, row.figure].join();
  const known = rows.get(key);
  if (known) known.samples.push(...row.samples);
  else rows.set(key, row);
}
