// @ts-check
// What tables, plots and the page /bench make of a suite's rows; in Node as in pages.

/** @typedef {import('../suites/suite.js').SuiteRow} SuiteRow */

const OURS = 'three-cube-collider';
/** The one of ours that others are measured by, where it takes part. */
const REFERENCE = `${OURS}, WebGL2`;
/** From so many samples on, a spread leaves out a twentieth on each side and no longer a quarter. */
const MANY = 20;
/** What is nearer to nothing is rounding. */
const NOTHING = 5e-5;

/**
 * The number that the part `q` of all lies below; between two of them by their distance.
 *
 * @param {readonly number[]} samples
 * @param {number} q from 0 to 1
 */
export function quantile(samples, q) {
  const sorted = [...samples].sort((a, b) => a - b);
  const place = q * (sorted.length - 1);
  const below = Math.floor(place);
  const [low = NaN, high = low] = sorted.slice(below, below + 2);
  return low + (place - below) * (high - low);
}

/** @param {readonly number[]} samples */
export const median = (samples) => quantile(samples, 0.5);

/** Two ends that most samples lie between. @param {readonly number[]} samples */
export function spread(samples) {
  const out = samples.length < MANY ? 0.25 : 0.05;
  return /** @type {const} */ ([quantile(samples, out), quantile(samples, 1 - out)]);
}

/** @param {string} contestant */
export const isOurs = (contestant) => contestant.startsWith(OURS);

/** Whether a figure is good where it is high. @param {string} figure */
export const higherIsBetter = (figure) => /a second|progress|kept|saved|way,/.test(figure);

/** Whether one may tell how many times another a figure is: times and sizes. @param {string} figure */
const hasRatio = (figure) => /^(ms|bytes|kB|MB)\b/.test(figure.split(', ').at(-1) ?? '');

/**
 * One table for each figure, in the order of the rows, ours first.
 *
 * @param {readonly SuiteRow[]} rows
 */
export function figuresOf(rows) {
  return unique(rows.map(({ figure }) => figure)).map((figure) => {
    const own = rows.filter((row) => row.figure === figure);
    const names = unique(own.map(({ contestant }) => contestant));
    return {
      figure,
      cases: unique(own.map((row) => row.case)),
      contestants: [...names.filter(isOurs), ...names.filter((name) => !isOurs(name))],
      rows: own,
      /** @param {string} name @param {string} contestant */
      rowOf: (name, contestant) =>
        own.find((row) => row.case === name && row.contestant === contestant),
    };
  });
}

/**
 * Whom the others of a case are measured by: ours, or the best where ours cannot take part.
 *
 * @param {readonly SuiteRow[]} rows of one figure
 * @param {string} name of the case
 * @returns {SuiteRow | undefined}
 */
export function referenceOf(rows, name) {
  const able = rows.filter((row) => row.case === name && row.samples.length > 0);
  return (
    able.find(({ contestant }) => contestant === REFERENCE) ??
    able.find(({ contestant }) => isOurs(contestant)) ??
    able.sort((a, b) => median(a.samples) - median(b.samples))[0]
  );
}

/**
 * How many times the reference's median a row's is; undefined where that says nothing.
 *
 * @param {SuiteRow} row
 * @param {SuiteRow | undefined} reference
 */
export function ratioOf(row, reference) {
  if (!reference || row === reference || !hasRatio(row.figure)) return undefined;
  const [mine, its] = [median(row.samples), median(reference.samples)];
  return mine > 0 && its > 0 ? mine / its : undefined;
}

/**
 * A figure in words: median, spread, ratio, note.
 *
 * @param {SuiteRow | undefined} row
 * @param {SuiteRow | undefined} [reference]
 */
export function told(row, reference) {
  if (!row) return '-';
  if (row.samples.length === 0) return row.note ?? 'cannot';
  const middle = show(median(row.samples));
  const words = [middle];
  const ends = spread(row.samples).map(show);
  if (ends.some((end) => end !== middle)) words.push(`(${ends.join(' to ')})`);
  const ratio = ratioOf(row, reference);
  if (ratio !== undefined) words.push(`×${show(ratio)}`);
  return words.join(' ') + (row.note ? `, ${row.note}` : '');
}

/** Two or three digits that count. @param {number} value */
export function show(value) {
  const size = Math.abs(value);
  if (!Number.isFinite(value)) return '-';
  if (size < NOTHING) return '0';
  if (Number.isInteger(value)) return String(value);
  if (size >= 99.95) return value.toFixed(0);
  if (size >= 10) return value.toFixed(1);
  return size >= 1 ? value.toFixed(2) : String(Number(value.toPrecision(2)));
}

/** @template T @param {T[]} list */
const unique = (list) => [...new Set(list)];
