// @ts-check
import { existsSync } from 'node:fs';
import { basename } from 'node:path';
import { openPage } from '../page.mjs';
import { EXPECTED, serveLevels, urlOf } from '../walk/session.mjs';
import { bundle } from './bundle.mjs';
import { latency } from './latency.mjs';
import { PAGE_SUITES } from './pages.mjs';
import { profile } from './profile.mjs';
import { size } from './size.mjs';
import { walk } from './walk.mjs';

/** @typedef {import('./suite.js').SuiteRow} SuiteRow */
/**
 * @typedef {object} Context
 * @property {{ quick: boolean, repeats: number }} options
 * @property {string[]} files GLB files: the levels
 * @property {(line: string) => void} tell hears how far it is
 * @property {string} only parts of `size` with this in their names
 * @property {string} seconds that `size` streams
 */
/**
 * @typedef {object} NodeSuite
 * @property {string} name as the command has it
 * @property {string} title
 * @property {string} about what is measured and how each is driven: Markdown
 * @property {string} [plot] the figure whose bars are drawn; the first, if not given
 * @property {number} [seen] how many of its tables docs/benchmarks.md shows unfolded; 2, if not given
 * @property {boolean} [needsBrowser] false if all of it runs in Node
 * @property {(context: Context) => Promise<{ rows: SuiteRow[], text?: string }>} run gives its rows, and tables of its
 *   own if it has better ones for the terminal
 */

/** All suites, in the order in which they run and are told. @type {NodeSuite[]} */
export const SUITES = [];
for (const name of ['load', 'step', 'gpu']) SUITES.push(inPage(name));
SUITES.push(latency);
for (const name of ['moving', 'crowd']) SUITES.push(inPage(name));
SUITES.push(profile, walk, inPage('feel'), size, bundle);

/** A suite of a web page, in a fresh one. @param {string} name @returns {NodeSuite} */
function inPage(name) {
  const suite = PAGE_SUITES.find((each) => each.name === name);
  if (suite === undefined) throw new Error(`pages.mjs tells of no suite ${name}.`);
  return {
    ...suite,
    async run({ files, options, tell }) {
      const module = `bench/suites/${name}.ts`;
      if (!existsSync(module)) throw new Error(`There is no ${module}.`);
      const page = await openPage({
        plugins: [serveLevels(files)],
        onMessage(type, text) {
          if (type === 'info') tell(text);
          else if (['warning', 'error'].includes(type) && !EXPECTED.test(text)) {
            tell(`[page] ${text}`);
          }
        },
      });
      const levels = files.map((file, i) => ({ name: basename(file), url: urlOf(i) }));
      try {
        const argument = { suite: name, options: { ...options, levels } };
        return { rows: await page.run('/bench/suites/inPage.ts', argument) };
      } finally {
        await page.close();
      }
    },
  };
}
