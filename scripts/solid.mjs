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

const SPECS = [
  'e2e/kinds.spec.ts',
  'e2e/materials.spec.ts',
  'e2e/webgpu.spec.ts',
  'e2e/nodes.spec.ts',
];
/** Columns, each with what its tests measured. @type {NonNullable<Row['backend']>[]} */
const BACKENDS = ['WebGL2', 'WebGPU', 'fallback'];
const ROWS = join(root, 'test-results', 'solid');
const PAGE = join(root, 'docs', 'solid.md');

/** @type {Record<Row['group'], string>} */
const GROUPS = {
  geometry: 'Objects',
  material: 'Materials',
  node: 'Node materials',
  policy: 'What is solid',
};

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
  console.log(`docs/solid.md: ${kindsOf(rows).length} kinds`);
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
            line('kind', ...BACKENDS, 'draws', 'programs'),
            line('---', ...BACKENDS.map(() => '---:'), '---:', '---:'),
            ...kindsOf(own).map((rows) =>
              line(
                rows[0].kind,
                ...BACKENDS.map((backend) => error(rows.find((row) => on(row) === backend))),
                each(rows, ({ draws }) => draws),
                each(rows, ({ programs }) => programs),
              ),
            ),
          ];
    return [`### ${heading}`, table.join('\n')];
  });
}

/** @param {Row} row */
function on(row) {
  return row.backend ?? 'WebGL2';
}

/** @param {Row | undefined} row */
function error(row) {
  return row === undefined ? '' : (1000 * row.worst).toFixed(2);
}

/** One number if all backends say the same, else each its own. @param {Row[]} rows @param {(row: Row) => number | undefined} of */
function each(rows, of) {
  const sorted = BACKENDS.flatMap((backend) => rows.filter((row) => on(row) === backend));
  const all = sorted.map(of);
  return new Set(all).size === 1 ? (all[0] ?? '') : all.join(', ');
}

/** The rows of each kind. @param {Row[]} rows */
function kindsOf(rows) {
  const kinds = new Map();
  for (const row of rows) kinds.set(row.kind, [...(kinds.get(row.kind) ?? []), row]);
  return /** @type {Row[][]} */ ([...kinds.values()]);
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
