// @ts-check
import { figuresOf, referenceOf, told } from './figures.mjs';

/** @typedef {import('./results.mjs').Entry} Entry */
/** @typedef {import('../suites/suite.js').SuiteRow} SuiteRow */

/** Tables of a suite that are seen at once unless it says otherwise; the others are folded away. */
const SEEN = 2;
/** With more cases than these, cases are below each other and contestants side by side. */
const WIDE = 6;

/**
 * A table for each figure: contestants below each other, cases side by side.
 *
 * @param {readonly SuiteRow[]} rows
 */
export function tablesOf(rows) {
  return figuresOf(rows).map(({ figure, cases, contestants, rows: own, rowOf }) => {
    /** @type {Map<string, SuiteRow | undefined>} */
    const references = new Map(cases.map((name) => [name, referenceOf(own, name)]));
    /** @param {string} contestant @param {string} name */
    const cell = (contestant, name) => told(rowOf(name, contestant), references.get(name));
    return cases.length > WIDE
      ? table(
          [figure, ...contestants],
          cases.map((name) => [name, ...contestants.map((who) => cell(who, name))]),
        )
      : table(
          [figure, ...cases],
          contestants.map((who) => [who, ...cases.map((name) => cell(who, name))]),
        );
  });
}

/**
 * A table, its first column to the left and all others to the right.
 *
 * @param {string[]} head
 * @param {string[][]} rows
 */
export function table(head, rows) {
  return [head, head.map((_, i) => (i === 0 ? '---' : '--:')), ...rows]
    .map((cells) => `| ${cells.join(' | ')} |`)
    .join('\n');
}

/**
 * What docs/benchmarks.md says of a suite, between its marks.
 *
 * @param {{ name: string, title: string, about: string, seen?: number }} suite
 * @param {Entry | undefined} entry
 */
export function section({ name, title, about, seen = SEEN }, entry) {
  const parts = [`## ${title}`, about];
  if (!entry) return [...parts, '_Not measured yet._'].join('\n\n');
  const tables = tablesOf(entry.rows);
  parts.push(`![${title}](benchmarks/${name}.svg)`, ...tables.slice(0, seen));
  if (tables.length > seen) {
    parts.push('<details><summary>More of it</summary>', ...tables.slice(seen), '</details>');
  }
  return [...parts, ranOn(entry)].join('\n\n');
}

/** When, where and with what a suite ran. @param {Entry} entry */
function ranOn({ date, machine, browser, gpu, versions, options, rows }) {
  const made = Object.entries(versions).map(([name, version]) => `${name} ${version}`);
  const where = [machine, browser, gpu].filter(Boolean).join('; ');
  const repeated = options.repeats > 1 && rows.some(({ samples }) => samples.length > 1);
  const repeats = repeated ? ` ${options.repeats} repeats.` : '';
  return `<sub>${date}. ${where}. ${made.join(', ')}.${repeats}</sub>`;
}
