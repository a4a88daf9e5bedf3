/** How long is looked back, milliseconds. */
const SPAN = 2000;
/** Frames kept at most: two seconds at 240 Hz. */
const MOST = 480;

/** What the frames of the last two seconds took. */
export class FrameTimes {
  readonly #ends = new Float64Array(MOST);
  readonly #times = new Float64Array(MOST);
  #next = 0;
  #last = 0;

  /** @param end when it was over, by `performance.now()`, as `time` in milliseconds */
  add(end: number, time: number): void {
    this.#ends[this.#next] = end;
    this.#times[this.#next] = time;
    this.#next = (this.#next + 1) % MOST;
    this.#last = end;
  }

  /** Milliseconds, of the two seconds up to the last frame; null where there is none. */
  summary(): { median: number; worst: number } | null {
    const times = this.#times.filter((_, i) => {
      const end = this.#ends[i]!;
      return end > 0 && end > this.#last - SPAN;
    });
    if (times.length === 0) return null;
    times.sort();
    return { median: times[times.length >> 1]!, worst: times[times.length - 1]! };
  }
}
