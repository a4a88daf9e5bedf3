/** Parts of the tail at which a distribution is told: eight a decade. */
const PER_DECADE = 8;

export interface DistributionSummary {
  count: number;
  mean: number;
  p50: number;
  p99: number;
  p999: number;
  max: number;
  /** Pairs [value, part of all that is greater or equal], the part falling from 1 to 1 / count. */
  tail: [number, number][];
}

/** Numbers, one after the other, of which quantiles are asked at the end. */
export class Distribution {
  readonly #values: Float64Array;
  #count = 0;

  /** @param capacity most numbers it will get */
  constructor(capacity: number) {
    this.#values = new Float64Array(capacity);
  }

  add(value: number): void {
    this.#values[this.#count++] = value;
  }

  summary(): DistributionSummary {
    const sorted = this.#values.slice(0, this.#count).sort();
    const count = sorted.length;
    const at = (q: number) => sorted[Math.min(count - 1, Math.floor(q * count))] ?? NaN;
    const tail: [number, number][] = [];
    if (count > 0) {
      // Evenly through the bulk, then ever finer to the single worst.
      for (let q = 0; q < 0.9; q += 0.05) tail.push([at(q), 1 - q]);
      for (let part = 0.1; part > 1 / count; part *= 10 ** (-1 / PER_DECADE)) {
        tail.push([at(1 - part), part]);
      }
      tail.push([sorted[count - 1]!, 1 / count]);
    }
    const mean = sorted.reduce((sum, value) => sum + value, 0) / count;
    const max = sorted[count - 1] ?? NaN;
    return { count, mean, p50: at(0.5), p99: at(0.99), p999: at(0.999), max, tail };
  }
}
