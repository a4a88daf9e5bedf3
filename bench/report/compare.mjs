// @ts-check
import { higherIsBetter, median, show } from './figures.mjs';
import { table } from './markdown.mjs';

/** @typedef {import('./results.mjs').Results} Results */
/** @typedef {import('../suites/suite.js').SuiteRow} SuiteRow */

/** By what part of the old figure one has to be worse to be marked. */
const WORSE = 0.1;

/**
 * Every median beside that of an earlier run, marked if it got worse; none asserts anything, since machines differ.
 *
 * @param {Results} now
 * @param {Results} before
 * @returns {{ text: string, worse: number }} a table, and how many figures in it are marked
 */
export function compare(now, before) {
  const lines = Object.entries(now.suites).flatMap(([suite, { rows }]) =>
    rows.flatMap((row) => {
      const old = before.suites[suite]?.rows.find((each) => isSame(each, row));
      return old === undefined ? [] : [lineOf(suite, row, old)];
    }),
  );
  const worse = lines.filter((cells) => cells.at(-1) !== '').length;
  if (lines.length === 0) return { text: 'Nothing in common to compare.', worse };
  const head = ['suite', 'case', 'contestant', 'figure', 'before', 'now', 'now / before', ''];
  return { text: table(head, lines), worse };
}

/** @param {string} suite @param {SuiteRow} row @param {SuiteRow} old */
function lineOf(suite, row, old) {
  const [now, before] = [median(row.samples), median(old.samples)];
  const loss = higherIsBetter(row.figure) ? before - now : now - before;
  const lost = row.samples.length === 0 && old.samples.length > 0;
  return [
    suite,
    row.case,
    row.contestant,
    row.figure,
    show(before),
    show(now),
    now > 0 && before > 0 ? show(now / before) : '-',
    lost || loss > WORSE * Math.abs(before) ? 'WORSE' : '',
  ];
}

/** @param {SuiteRow} a @param {SuiteRow} b */
const isSame = (a, b) =>
  a.case === b.case && a.contestant === b.contestant && a.figure === b.figure;
