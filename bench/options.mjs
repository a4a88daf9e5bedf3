// @ts-check
import { existsSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { RESULTS } from './report/results.mjs';
import { findLevels } from './walk/options.mjs';

/** @param {readonly string[]} suites */
const help = (suites) => `npm run bench -- [suite …] [options]

  suites: ${suites.join(', ')}; all of them by default

  --level file.glb     a level, may be repeated (default: as npm run walk)
  --repeats 5          how often each figure is taken
  --quick              fewer and smaller cases, once, to see that all runs; keeps nothing unless --json says where
  --json file          where results are kept, suite by suite (default: ${RESULTS})
  --from file          tells the results of an earlier run instead of measuring
  --compare old.json   medians beside those of an earlier run; marks what got over 10 % worse
  --no-write           leaves docs/benchmarks.md and README as they are; so do --quick, and --json with another file
  --only part          of size: many, huge or stream
  --seconds 60         of size: how long it streams
  --markdown file      of size: writes its own tables between its marks, as in docs/size.md`;

/**
 * The command line of `npm run bench`.
 *
 * @param {readonly string[]} suites all there are
 */
export function readOptions(suites) {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    allowNegative: true,
    options: {
      help: { type: 'boolean' },
      level: { type: 'string', multiple: true },
      repeats: { type: 'string' },
      quick: { type: 'boolean', default: false },
      json: { type: 'string' },
      from: { type: 'string' },
      compare: { type: 'string' },
      write: { type: 'boolean', default: true },
      only: { type: 'string', default: '' },
      seconds: { type: 'string', default: '60' },
      markdown: { type: 'string' },
    },
  });
  if (values.help) {
    console.log(help(suites));
    process.exit();
  }
  const unknown = positionals.find((name) => !suites.includes(name));
  if (unknown) throw new Error(`There is no suite ${unknown}, but ${suites.join(', ')}.`);
  if (values.markdown && positionals.join() !== 'size') {
    throw new Error('--markdown is for the suite size alone; docs/benchmarks.md needs no option.');
  }
  const { quick, json, from, only, seconds } = values;
  for (const file of [from, values.compare]) {
    if (file !== undefined && !existsSync(file)) throw new Error(`There is no file "${file}".`);
  }
  const repeats = Number(values.repeats ?? (quick ? 1 : 5));
  if (!(Number.isInteger(repeats) && repeats > 0)) {
    throw new Error(`--repeats: "${values.repeats}" is no number of 1 or more.`);
  }
  return {
    ...values,
    suites: positionals.length > 0 ? positionals : suites,
    files: from === undefined ? findLevels(values.level) : [],
    repeats,
    // Half a suite is no result to keep.
    keep: json ?? (quick || only !== '' ? undefined : RESULTS),
    write: values.write && !quick && only === '' && (json === undefined || json === RESULTS),
    only,
    seconds,
  };
}
