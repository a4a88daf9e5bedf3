import { Vector3 } from 'three';
import { mulberry32 } from './Inputs.js';
import type { Judge } from '../rivals/Judge.js';

/** How far from the first, over ground, and how far above it, metres. */
const RADIUS = 30;
const ABOVE = 4;
/** Everyone stands on this: a slope of 40°. */
const FLATTEST = Math.cos((40 * Math.PI) / 180);
/** From anything when it begins, metres. */
const CLEARANCE = 0.01;

/** Free places under the open sky around a first one, in an order given by a seed; the same for every walker. */
export class Places {
  readonly #found: Vector3[];
  readonly #judge: Judge;
  readonly #top: number;
  readonly #random: () => number;

  /** @param top height above everything, from where it looks down: so none is inside something solid */
  constructor(judge: Judge, first: Vector3, top: number, seed: number) {
    this.#judge = judge;
    this.#top = top;
    this.#found = [first];
    this.#random = mulberry32(seed ^ 0x9e3779b9);
  }

  /** The foot of the `i`th; number 0 is the first. Where there are no more, they begin anew. */
  at(i: number): Vector3 {
    while (this.#found.length <= i) {
      const next = this.#find();
      if (next === null) break;
      this.#found.push(next);
    }
    return this.#found[i % this.#found.length]!;
  }

  #find(): Vector3 | null {
    const first = this.#found[0]!;
    for (let tries = 0; tries < 1000; tries++) {
      const turn = 2 * Math.PI * this.#random();
      const distance = RADIUS * Math.sqrt(this.#random());
      const x = first.x + distance * Math.cos(turn);
      const z = first.z + distance * Math.sin(turn);
      const foot = standBelow(this.#judge, new Vector3(x, this.#top, z), Infinity);
      if (foot !== null && foot.y < first.y + ABOVE) return foot;
    }
    return null;
  }
}

/** A free foot on the first floor below `eye`, or null if that is too steep or has no room. */
export function standBelow(judge: Judge, eye: Vector3, reach: number): Vector3 | null {
  const floor = judge.floorBelow(eye, reach);
  if (floor === null || floor.up < FLATTEST) return null;
  const foot = eye.clone();
  // On a slope the capsule's lowest point is not where it touches.
  for (let lift = 0.02; lift < 0.15; lift += 0.01) {
    foot.y = floor.height + lift;
    if (judge.penetration(foot) < -CLEARANCE) return foot;
  }
  return null;
}
