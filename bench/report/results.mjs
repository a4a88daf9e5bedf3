// @ts-check
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { format, resolveConfig } from 'prettier';
import { quantile } from './figures.mjs';

/** @typedef {import('../suites/suite.js').SuiteRow} SuiteRow */
/**
 * What one run of a suite gave.
 *
 * @typedef {object} Entry
 * @property {string} date of the run, year first
 * @property {string} machine
 * @property {string} [browser] if it took one
 * @property {string} [gpu]
 * @property {Record<string, string>} versions
 * @property {{ repeats: number, quick: boolean, levels: string[] }} options
 * @property {SuiteRow[]} rows
 */
/** @typedef {{ suites: Record<string, Entry> }} Results */

/** Where results are kept unless said otherwise. */
export const RESULTS = 'bench/results.json';
/** More samples than this are kept as as many of their quantiles, evenly from the least to the greatest. */
const MOST = 101;

/**
 * @param {string} file
 * @returns {Results} empty if there is no such file
 */
export function readResults(file) {
  return existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : { suites: {} };
}

/** @param {string} file @param {Results} results */
export async function writeResults(file, results) {
  const style = await resolveConfig(file);
  writeFileSync(file, await format(JSON.stringify(results), { ...style, parser: 'json' }));
}

/** A row as it is kept: four digits that count. @param {SuiteRow} row */
export function tidy(row) {
  const { samples } = row;
  const kept =
    samples.length <= MOST
      ? samples
      : Array.from({ length: MOST }, (_, i) => quantile(samples, i / (MOST - 1)));
  return { ...row, samples: kept.map((sample) => Number(sample.toPrecision(4))) };
}
