import { Vector3 } from 'three';
import type { Capsule } from '../field/Capsule.js';
import type { SurfaceField } from '../field/SurfaceField.js';

/** Inside, backs of surfaces are seen in more than this part of all directions that point no lower than that cosine. */
const MOST = 0.55;
const LOWEST = -0.2;
/** Fields in a row that must say so. */
const AGREED = 2;
/** Free places remembered, and how far apart, metres: what closed in on the last may have on the one before. */
const REMEMBERED = 32;
const APART = 0.3;

/**
 * Finds out whether the body is inside a solid, or of what shows one side only: all around, fields then see backs of
 * surfaces. (A wall's back alone is no sign: one may have walked around it. Nor is a cave so large that they see nothing.) One field's word is not taken for it: things move while it is drawn.
 */
export class InsideWatch {
  /** Whether it is. */
  inside = false;
  /** The body's foot where fields saw it outside, body's frame: a ring, the newest at `#last`. */
  readonly #free = Array.from({ length: REMEMBERED }, () => new Vector3());
  #last = 0;
  #count = 0;
  #agreed = 0;

  /** Whether another field is wanted soon: to be sure, or to see whether it is free now. */
  get unsure(): boolean {
    return this.#agreed > 0 && (!this.inside || this.#count > 0);
  }

  reset(): void {
    this.inside = false;
    this.#agreed = 0;
    this.#count = 0;
  }

  /**
   * Takes a new field into account.
   *
   * @param up the character's, world axes
   * @returns whether `inside` has changed
   */
  take(field: SurfaceField, up: Vector3, body: Capsule): boolean {
    const before = this.inside;
    if (seesBacks(field, up)) {
      this.#agreed = Math.min(AGREED, this.#agreed + 1);
      this.inside = this.#agreed === AGREED;
    } else {
      this.#agreed = 0;
      this.inside = false;
      this.#remember(body);
    }
    return this.inside !== before;
  }

  /** Puts the body back to where it was free before, farther back each time; returns whether there is such a place. */
  rescue(body: Capsule): boolean {
    if (this.#count === 0) return false;
    const { x, y, z } = this.#free[this.#last]!;
    this.#last = (this.#last + REMEMBERED - 1) % REMEMBERED;
    this.#count--;
    body.x = x;
    body.y = y;
    body.z = z;
    return true;
  }

  #remember({ x, y, z }: Capsule): void {
    const last = this.#free[this.#last]!;
    if (this.#count > 0 && Math.hypot(x - last.x, y - last.y, z - last.z) < APART) return;
    this.#last = (this.#last + 1) % REMEMBERED;
    this.#count = Math.min(REMEMBERED, this.#count + 1);
    this.#free[this.#last]!.set(x, y, z);
  }
}

/** Below, the ground may show its front inside a rock that stands on it. */
function seesBacks(field: SurfaceField, up: Vector3): boolean {
  const { count, direction, distance, front } = field;
  let backs = 0;
  let all = 0;
  for (let i = 0, k = 0; i < count; i++, k += 3) {
    const rise = direction[k]! * up.x + direction[k + 1]! * up.y + direction[k + 2]! * up.z;
    if (rise < LOWEST) continue;
    all++;
    if (front[i] === 0 && distance[i]! < Infinity) backs++;
  }
  return backs > MOST * all;
}
