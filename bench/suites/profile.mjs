// @ts-check
import { basename } from 'node:path';
import { openPage } from '../page.mjs';
import { serveLevels, urlOf } from '../walk/session.mjs';
import { selfTimes } from './selfTimes.mjs';

/** @typedef {import('./suite.js').SuiteRow} SuiteRow */
/** @typedef {{ name: string, backend: string, characters: number, inLevel?: boolean, frames: number }} Case */

const MODULE = '/bench/suites/profile.ts';
const [WHOLE, FUNCTIONS] = ['where the time goes, µs a step', 'the dearest functions, µs a step'];
/** Functions told of a case. */
const TOLD = 10;
/** Walks before the profiler looks on. */
const WARM = 3;

/** @type {Case[]} */
const CASES = [
  { name: 'one, WebGL2', backend: 'WebGL2', characters: 1, inLevel: true, frames: 300 },
  { name: 'one, WebGPU', backend: 'WebGPU', characters: 1, inLevel: true, frames: 300 },
  { name: 'each of 100, WebGL2', backend: 'WebGL2', characters: 100, frames: 30 },
];

/** @type {import('./list.mjs').NodeSuite} */
export const profile = {
  name: 'profile',
  title: 'Where a step goes',
  about: `What the browser's own sampling profiler saw of the main thread, ten thousand times a second, in walks as those of
[A step of a character](#a-step-of-a-character) on level.glb and of [Many characters](#many-characters): time in the functions
of each folder of \`src/\`, in three's, in calls of the GPU's interface, and in collecting garbage. A built-in function counts
for who called it. What the browser does besides is left out, as is the bench itself; being watched costs a little.`,
  async run({ files, options: { quick, repeats }, tell }) {
    /** @type {SuiteRow[]} */
    const rows = [];
    for (const each of quick ? CASES.slice(0, 1) : CASES) {
      tell(each.name);
      rows.push(...(await measure(each, files, repeats)));
    }
    return { rows };
  },
};

/**
 * @param {Case} of
 * @param {string[]} files
 * @param {number} repeats
 * @returns {Promise<SuiteRow[]>}
 */
async function measure({ name, backend, characters, inLevel, frames }, files, repeats) {
  const page = await openPage({ plugins: [serveLevels(files)] });
  try {
    const level = inLevel && files[0] ? { name: basename(files[0]), url: urlOf(0) } : undefined;
    const calls = await page.run(MODULE, { do: 'enter', backend, characters, level });
    if (!calls) {
      const note = 'not in this browser';
      return [{ case: name, contestant: 'all of it', figure: WHOLE, samples: [], note }];
    }
    for (let round = 0; round < WARM; round++) {
      await page.run(MODULE, { do: 'walk', round, frames });
    }
    const seen = [];
    for (let repeat = 0; repeat < repeats; repeat++) {
      const told = await page.profiled(MODULE, { do: 'walk', round: WARM + repeat, frames });
      seen.push(selfTimes(told, new Set(calls)));
    }
    const microseconds = 1000 / (frames * characters);
    const groups = sums(seen, ({ group }) => group, microseconds);
    const functions = sums(seen, ({ name: of }) => of, microseconds);
    /** @param {string} figure @returns {(entry: [string, number[]]) => SuiteRow} */
    const row =
      (figure) =>
      ([contestant, samples]) => ({ case: name, contestant, figure, samples });
    return [...groups.map(row(WHOLE)), ...functions.slice(0, TOLD).map(row(FUNCTIONS))];
  } finally {
    await page.close();
  }
}

/**
 * What each took in each walk, the dearest first.
 *
 * @param {import('./selfTimes.mjs').Spent[][]} walks
 * @param {(spent: import('./selfTimes.mjs').Spent) => string} keyOf
 * @param {number} unit
 */
function sums(walks, keyOf, unit) {
  /** @type {Map<string, number[]>} */
  const found = new Map();
  walks.forEach((walk, i) => {
    for (const spent of walk) {
      const key = keyOf(spent);
      if (!found.has(key)) found.set(key, walks.map(() => 0)); // prettier-ignore
      const samples = /** @type {number[]} */ (found.get(key));
      samples[i] = (samples[i] ?? 0) + spent.time * unit;
    }
  });
  /** @param {number[]} samples */
  const total = (samples) => samples.reduce((sum, each) => sum + each, 0);
  return [...found].sort(([, a], [, b]) => total(b) - total(a));
}
