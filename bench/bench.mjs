// @ts-check
// Every claim of speed and accuracy, measured beside the rivals: `npm run bench -- --help`. Prints tables, keeps them in
// bench/results.json, and writes docs/benchmarks.md, its plots and README's headline from there.
import { basename } from 'node:path';
import { format } from 'prettier';
import { main } from '../scripts/run.mjs';
import { readOptions } from './options.mjs';
import { HOST, openPage } from './page.mjs';
import { compare } from './report/compare.mjs';
import { writeDocs } from './report/docs.mjs';
import { tablesOf } from './report/markdown.mjs';
import { readResults, tidy, writeResults } from './report/results.mjs';
import { SUITES } from './suites/list.mjs';
import { versions } from './walk/options.mjs';
import { writeBetweenMarks } from './walk/table.mjs';

/** @typedef {import('./report/results.mjs').Results} Results */

/** Columns of one width. @param {string} markdown */
const print = async (markdown) => console.log(await format(markdown, { parser: 'markdown' }));

/** Browser and GPU, as they name themselves. */
async function describe() {
  const { run, browser, close } = await openPage();
  const { webgl, webgpu } = await run('/bench/suites/machine.ts', null).finally(close);
  return { browser, gpu: `WebGL: ${webgl}; WebGPU: ${webgpu}` };
}

/**
 * Runs the suites, each whatever becomes of the others.
 *
 * @param {ReturnType<typeof readOptions>} options
 * @returns {Promise<Results>} of this run alone
 */
async function measure({ suites, files, quick, repeats, keep, only, seconds, markdown }) {
  /** @type {Results} */
  const results = { suites: {} };
  const chosen = SUITES.filter(({ name }) => suites.includes(name));
  const needed = chosen.some(({ needsBrowser = true }) => needsBrowser);
  const described = needed ? await describe() : {};
  for (const { name, needsBrowser = true, run } of chosen) {
    console.error(`== ${name}`);
    const tell = (/** @type {string} */ line) => console.error(`${name}: ${line}`);
    const begin = Date.now();
    try {
      const { rows, text } = await run({
        options: { quick, repeats },
        files,
        tell,
        only,
        seconds,
      });
      const entry = {
        date: new Date().toISOString().slice(0, 10),
        machine: HOST,
        ...(needsBrowser ? described : {}),
        versions: { ...versions(), node: process.versions.node },
        options: { quick, repeats, levels: files.map((file) => basename(file)) },
        rows: rows.map(tidy),
      };
      results.suites[name] = entry;
      await print(text ?? tablesOf(entry.rows).join('\n\n'));
      if (markdown && text) await writeBetweenMarks(markdown, name, text);
      // Read anew: a run of another suite may have ended meanwhile.
      if (keep) {
        const kept = readResults(keep);
        await writeResults(keep, { suites: { ...kept.suites, [name]: entry } });
      }
      tell(`done in ${Math.round((Date.now() - begin) / 1000)} s`);
    } catch (error) {
      tell(`FAILED: ${error instanceof Error ? error.message : error}`);
      process.exitCode = 1;
    }
  }
  return results;
}

/** @param {Results} results */
async function printAll({ suites }) {
  for (const [name, { rows }] of Object.entries(suites)) {
    await print([`## ${name}`, ...tablesOf(rows)].join('\n\n'));
  }
}

await main(async () => {
  const options = readOptions(SUITES.map(({ name }) => name));
  const { from, keep } = options;
  // Before a run that may replace it.
  const before = options.compare === undefined ? undefined : readResults(options.compare);
  const results = from === undefined ? await measure(options) : readResults(from);
  if (from !== undefined) await printAll(results);
  if (before) {
    const { text, worse } = compare(results, before);
    await print(text);
    console.log(`${worse} of them over 10 % worse.`);
  }
  if (options.write) await writeDocs(SUITES, readResults(from ?? keep ?? ''));
});
