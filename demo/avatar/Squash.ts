import type { Object3D } from 'three';

/** A spring: 1/s², 1/s. */
const STIFFNESS = 420;
const DAMPING = 26;
/** Most that a figure gives, as a part of its height. */
const MOST = 0.1;
/** Longest step that the spring bears, seconds. */
const STEP = 1 / 60;

/** Lets a figure grow longer and thinner, shorter and wider for a moment; its feet stay where they are. */
export class Squash {
  #enabled = true;
  #figure: Object3D;
  /** Part of its height that it is taller, and 1/s. */
  #stretch = 0;
  #speed = 0;

  constructor(figure: Object3D) {
    this.#figure = figure;
  }

  /** False for who asked for less motion. */
  get enabled(): boolean {
    return this.#enabled;
  }

  set enabled(enabled: boolean) {
    this.#enabled = enabled;
    this.#stretch = this.#speed = 0;
  }

  /** @param speed 1/s, up positive */
  push(speed: number): void {
    if (this.#enabled) this.#speed += speed;
  }

  update(delta: number): void {
    for (let left = Math.min(delta, 0.1); left > 0; left -= STEP) {
      const step = Math.min(left, STEP);
      this.#speed -= (STIFFNESS * this.#stretch + DAMPING * this.#speed) * step;
      this.#stretch += this.#speed * step;
    }
    this.#stretch = Math.max(-MOST, Math.min(MOST, this.#stretch));
    const wide = 1 / Math.sqrt(1 + this.#stretch);
    this.#figure.scale.set(wide, 1 + this.#stretch, wide);
  }
}
