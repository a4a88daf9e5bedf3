import type { SuiteRow } from './suite.js';

/** Figures as they come in: a row for each figure of a contestant in a case. */
export class Rows {
  readonly #rows = new Map<string, SuiteRow>();

  /** One more sample; without one, the row of somebody who cannot take part. */
  add(where: string, contestant: string, figure: string, sample?: number, note?: string): void {
    const key = [where, contestant, figure].join('\n');
    let row = this.#rows.get(key);
    if (row === undefined) {
      row = { case: where, contestant, figure, samples: [] };
      this.#rows.set(key, row);
    }
    if (sample !== undefined && Number.isFinite(sample)) row.samples.push(sample);
    if (note !== undefined) row.note = note;
  }

  /** In the order in which they were first heard of. */
  get all(): SuiteRow[] {
    return [...this.#rows.values()];
  }
}
