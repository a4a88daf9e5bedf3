/** As near to the wanted length it is there, metres. */
const CLOSE = 1e-3;

/**
 * The length of a camera boom: cut at once to what is free, and let out again slowly, by a critically damped spring. It
 * is never longer than what is free, alike at every frame rate, and starts out from rest, so that a limit that flickers
 * does not shake the camera. Allocates nothing.
 */
export class BoomSpring {
  /** What obstacles leave of the boom, metres; Infinity while nothing does. */
  #limit = Infinity;
  /** How fast it is let out, m/s. */
  #speed = 0;

  /** Nothing is in the way, and the next length is taken at once. */
  reset(): void {
    this.#limit = Infinity;
    this.#speed = 0;
  }

  /**
   * @param wanted length, metres
   * @param free how much of it is free now, metres
   * @param rate of the spring, 1/s: 5 is out in a second; Infinity at once
   * @param delta seconds since the last call
   * @returns length, metres: at most `wanted`, at most `free`
   */
  update(wanted: number, free: number, rate: number, delta: number): number {
    const target = Math.min(wanted, free);
    if (target < this.#limit) {
      if (target === wanted) return wanted;
      this.#limit = target;
      this.#speed = 0;
      return target;
    }
    this.#letOut(target, rate, delta);
    if (target === wanted && wanted - this.#limit < CLOSE) this.reset();
    return Math.min(wanted, this.#limit);
  }

  /** Exact for any `delta`: y is what is left to go. */
  #letOut(target: number, rate: number, delta: number): void {
    const y = this.#limit - target;
    const fall = rate === Infinity ? 0 : Math.exp(-rate * delta);
    const push = rate === Infinity ? 0 : (this.#speed + rate * y) * delta;
    this.#limit = Math.min(target, target + (y + push) * fall);
    this.#speed = rate === Infinity ? 0 : (this.#speed - rate * push) * fall;
  }
}
