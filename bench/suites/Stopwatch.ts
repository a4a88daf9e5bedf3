type Method = (...args: unknown[]) => unknown;

/** Adds up the milliseconds spent in methods that it is put around; one within another counts once. */
export class Stopwatch {
  #total = 0;
  #depth = 0;
  #start = 0;

  /** Replaces methods of an object by clocked ones; those it does not have are passed over. */
  around(owner: object, ...names: string[]): this {
    const methods = owner as Record<string, Method | undefined>;
    for (const name of names) {
      const method = methods[name]?.bind(owner);
      if (method !== undefined) methods[name] = (...args) => this.time(() => method(...args));
    }
    return this;
  }

  time<T>(call: () => T): T {
    if (this.#depth++ === 0) this.#start = performance.now();
    try {
      return call();
    } finally {
      if (--this.#depth === 0) this.#total += performance.now() - this.#start;
    }
  }

  /** What it has come to since it was taken last. */
  take(): number {
    const total = this.#total;
    this.#total = 0;
    return total;
  }
}
