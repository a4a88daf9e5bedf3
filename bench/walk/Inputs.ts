import type { Vector3 } from 'three';
import { SHAPE } from '../rivals/shape.js';

/** Ticks a second of the script; a frame of any rate samples it. */
const CLOCK = 60;
/** Chance in a tick that the heading changes, and by how much at most in all, radians. */
const TURN_CHANCE = 0.02;
const TURN_RANGE = 3;
/** Chance in a tick that the jump key is struck. */
const JUMP_CHANCE = 0.01;

/**
 * What a player's hands do: headings and jumps on a clock of their own, from a seed. Two walkers with one seed get the
 * same inputs at the same times, whatever their frame rates and wherever they are.
 */
export class Inputs {
  /** Wanted velocity, m/s, horizontal. */
  readonly velocity: Vector3;
  /** Whether the jump key was struck since the last frame. */
  jump = false;
  readonly #random: () => number;
  #tick = 0;
  #yaw = 0;

  /** @param velocity is filled from now on */
  constructor(seed: number, velocity: Vector3) {
    this.#random = mulberry32(seed);
    this.velocity = velocity;
    this.advanceTo(0);
  }

  /** Plays the script up to `time`, seconds since its begin; never back. */
  advanceTo(time: number): this {
    this.jump = false;
    // A time that should fall on a tick may come out a rounding below it.
    for (const end = Math.floor(time * CLOCK + 1e-6); this.#tick < end; this.#tick++) {
      if (this.#random() < TURN_CHANCE) this.#yaw += (this.#random() - 0.5) * TURN_RANGE;
      if (this.#random() < JUMP_CHANCE) this.jump = true;
    }
    this.velocity.set(Math.sin(this.#yaw), 0, Math.cos(this.#yaw)).multiplyScalar(SHAPE.speed);
    return this;
  }
}

/** A small, well-mixed generator of numbers in [0, 1) (Tommy Ettinger's mulberry32). */
export function mulberry32(seed: number): () => number {
  let state = seed | 0;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
