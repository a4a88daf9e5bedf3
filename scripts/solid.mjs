// @ts-check
// `npm run build:solid`: the table in docs/solid.md, from what the browser tests of kinds and materials measure.
// `-- --rows` takes the figures of their last run instead of running them.

import { existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { arch, cpus, platform } from 'node:os';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { format, resolveConfig } from 'prettier';
import { ADVICE, findBrowser } from './browser.mjs';
import { main, root, run } from './run.mjs';

/** @typedef {import('../e2e/support/solidRows.js').SolidRow} Row */

const SPECS = ['e2e/kinds.spec.ts', 'e2e/materials.spec.ts'];
const ROWS = join(root, 'test-results', 'solid');
const PAGE = join(root, 'docs', 'solid.md');

/** @type {Record<Row['group'], string>} */
const GROUPS = { geometry: 'Objects', material: 'Materials', policy: 'What is solid' };

await main(async () => {
  if (!process.argv.includes('--rows')) {
    rmSync(ROWS, { recursive: true, force: true });
    const specs = SPECS.filter((spec) => existsSync(join(root, spec)));
    const playwright = join(root, 'node_modules', '@playwright', 'test', 'cli.js');
    if (!(await run([process.execPath, playwright, 'test', ...specs]))) {
      throw new Error('A test failed: docs/solid.md stays as it is.');
    }
  }
  const rows = readRows();
  const text = [await machineLine(), ...tablesOf(rows)].join('\n\n');
  const old = readFileSync(PAGE, 'utf8');
  const marks = /(<!-- solid:begin -->)[^]*(<!-- solid:end -->)/;
  if (!marks.test(old)) throw new Error('docs/solid.md has lost its marks.');
  const made = old.replace(marks, (_, begin, end) => `${begin}\n\n${text}\n\n${end}`);
  const options = await resolveConfig(PAGE);
  writeFileSync(PAGE, await format(made, { ...options, parser: 'markdown' }));
  console.log(`docs/solid.md: ${rows.length} kinds`);
});

/** @returns {Row[]} by name */
function readRows() {
  const files = existsSync(ROWS) ? readdirSync(ROWS).filter((name) => name.endsWith('.json')) : [];
  if (files.length === 0) throw new Error('No figures: run without --rows first.');
  return files
    .map((name) => JSON.parse(readFileSync(join(ROWS, name), 'utf8')))
    .sort((a, b) => a.kind.localeCompare(b.kind, 'en'));
}

/** A heading and a table for each group. @param {Row[]} rows */
function tablesOf(rows) {
  return Object.entries(GROUPS).flatMap(([group, heading]) => {
    const own = rows.filter((row) => row.group === group);
    if (own.length === 0) return [];
    /** @param {(string | number)[]} cells */
    const line = (...cells) => `| ${cells.join(' | ')} |`;
    // Rules are kept or not: there is nothing to measure.
    const table =
      group === 'policy'
        ? [
            line('what', 'is it an obstacle?'),
            line('---', '---'),
            ...own.map(({ kind, note }) => line(kind.replace('policy: ', ''), note ?? '')),
          ]
        : [
            line('kind', 'WebGL2', 'worst error, mm', 'draws', 'programs'),
            line('---', '---', '---:', '---:', '---:'),
            ...own.map(({ kind, worst, draws, programs }) =>
              line(kind, 'as drawn', (1000 * worst).toFixed(2), draws, programs),
            ),
          ];
    return [`### ${heading}`, table.join('\n')];
  });
}

async function machineLine() {
  const found = await findBrowser();
  if (!found) throw new Error(ADVICE);
  const browser = await chromium.launch({ executablePath: found.path });
  const version = browser.version();
  await browser.close();
  const three = JSON.parse(readFileSync(join(root, 'node_modules/three/package.json'), 'utf8'));
  const cpu = `${cpus().length} cores (${cpus()[0]?.model})`;
  return `Chromium ${version}, ${platform()} ${arch()}, ${cpu}, software GPU; three ${three.version}.`;
}
