// @ts-check
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { headline } from '../headline.mjs';
import { writeBetweenMarks } from '../walk/table.mjs';
import { drawBars } from './bars.mjs';
import { section } from './markdown.mjs';

const PAGE = 'docs/benchmarks.md';
const PLOTS = 'docs/benchmarks';

/**
 * Writes every table and plot of docs/benchmarks.md, and README's headline.
 *
 * @param {readonly import('../suites/list.mjs').NodeSuite[]} suites
 * @param {import('./results.mjs').Results} results
 */
export async function writeDocs(suites, results) {
  if (!existsSync(PLOTS)) mkdirSync(PLOTS);
  for (const suite of suites) {
    const entry = results.suites[suite.name];
    if (entry) {
      const plot = await drawBars(suite.title, entry.rows, suite.plot);
      writeFileSync(`${PLOTS}/${suite.name}.svg`, plot);
    }
    await writeBetweenMarks(PAGE, suite.name, section(suite, entry));
  }
  await writeBetweenMarks('README.md', 'headline', headline(results));
}
