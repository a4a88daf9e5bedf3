import type { Vector3 } from 'three';
import type { AxisMaxima } from '../cube/AxisMaxima.js';
import { DEFAULTS } from '../defaults.js';
import type { CollisionResponse } from './CollisionResponse.js';

/** How strongly `AxisResponse` answers. */
export interface AxisResponseOptions {
  /** c_xz: part of a horizontal penetration undone at once. 0 < cXZ < cY. Default 0.5. */
  cXZ?: number;
  /** c_y: part of a vertical penetration undone at once. cXZ < cY <= 1. Default 1. */
  cY?: number;
  /** h_max: horizontal pushes shorter than this are dropped, metres, >= 0. Default 0, off: see the class. */
  hMax?: number;
}

/**
 * The paper's response (§1.2.3) in a Y-up world: each pair of opposite faces pushes along its own axis.
 *
 * Mends of (23)-(25): printed, the signs of x and z disagree with y's (and with the loop's ground test). With maxima
 * positive and minima negative, as (17)-(22) say, a push away from both is d = -c·(max + min) on every axis. The r of
 * (14)-(16) is taken as a length, (rMax - rMin)·red, so that c_xz and c_y are pure numbers.
 *
 * What to know of it:
 * - c of 1/2 centres a sphere in a corridor in one go; c of 1 would throw it from wall to wall for ever, so cXZ < cY <= 1.
 * - a wall walked into at a travel of t a cubemap is entered by t/cXZ - t, at rest, and left when the walking stops
 *   (`CharacterController` clips the walk there: see `clipWish`).
 * - only one component a face is kept, so a slope of 45° is pushed back by half, and needs a few cubemaps.
 * - kerbs lower than about 0.29 rMax are seen by the bottom face alone and climbed with no threshold. `hMax`, the
 *   paper's threshold for that, compares a sideways push with a height: at 0.1 m walls are entered by 0.2 m, then jump
 *   back. It is there to be faithful, and off.
 */
export class AxisResponse implements CollisionResponse {
  /** Part of a sideways push that is taken. @default 0.5 */
  readonly cXZ: number;
  /** Part of an upward or downward push that is taken. @default 1 */
  readonly cY: number;
  /** Pushes shorter than this are dropped, metres. @default 0 */
  readonly hMax: number;

  /** @throws RangeError unless 0 < cXZ < cY <= 1 and hMax >= 0 */
  constructor({
    cXZ = DEFAULTS.axis.cXZ,
    cY = DEFAULTS.axis.cY,
    hMax = DEFAULTS.axis.hMax,
  }: AxisResponseOptions = {}) {
    if (!(cY > 0 && cY <= 1)) {
      throw new RangeError(`AxisResponse: "cY" must be above 0 and at most 1 (got ${cY}).`);
    }
    if (!(cXZ > 0 && cXZ < cY)) {
      throw new RangeError(
        `AxisResponse: "cXZ" must be above 0 and below "cY" (got ${cXZ}, ${cY}).`,
      );
    }
    if (!(hMax >= 0 && hMax < Infinity)) {
      throw new RangeError(
        `AxisResponse: "hMax" must be a length in metres, 0 or more (got ${hMax}).`,
      );
    }
    this.cXZ = cXZ;
    this.cY = cY;
    this.hMax = hMax;
  }

  /**
   * Equations (23)-(25) and h_max.
   *
   * If the sphere has moved since the cubemap was drawn, each winning texel stands for the plane through its point that
   * faces the old centre: exact for a plane met head-on, a fair guess elsewhere. A face with red 0 saw nothing inside
   * rMax and says nothing, however far the sphere has moved toward it: the caller must not move far (see
   * `limitTravel`).
   */
  respond(maxima: AxisMaxima, center: Vector3, target: Vector3): Vector3 {
    target.set(
      -this.cXZ * (component(maxima, 0, 0, center) + component(maxima, 1, 0, center)), // (23)
      -this.cY * (component(maxima, 2, 1, center) + component(maxima, 3, 1, center)), // (24)
      -this.cXZ * (component(maxima, 4, 2, center) + component(maxima, 5, 2, center)), // (25)
    );
    // Not `<=`: with h_max = 0 nothing is dropped.
    if (Math.abs(target.x) < this.hMax) target.x = 0;
    if (Math.abs(target.z) < this.hMax) target.z = 0;
    return target;
  }
}

/**
 * x_max, x_min … of (17)-(22): the coordinate of a face's winner along its own axis, signed, metres of penetration.
 */
function component(maxima: AxisMaxima, face: number, axis: number, center: Vector3): number {
  return penetrationAt(maxima, face, center) * maxima.direction[3 * face + axis]!;
}

/**
 * How deep a face's winner reaches into the sphere around `center`, metres, 0 to rMax - rMin; 0 where it saw nothing.
 */
export function penetrationAt(maxima: AxisMaxima, face: number, center: Vector3): number {
  if (maxima.red[face] === 0) return 0;
  const { direction, center: drawn } = maxima;
  const nearer =
    (center.x - drawn.x) * direction[3 * face]! +
    (center.y - drawn.y) * direction[3 * face + 1]! +
    (center.z - drawn.z) * direction[3 * face + 2]!;
  const shell = maxima.rMax - maxima.rMin;
  return Math.min(shell, Math.max(0, maxima.penetration(face) + nearer));
}
