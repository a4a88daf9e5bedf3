import type { Quaternion } from 'three';

/** A vector of the body's frame, to be turned; and what it is in world axes. Arrays: numbers handed over would be boxed. */
export const own = /* @__PURE__ */ new Float64Array(3);
export const world = /* @__PURE__ */ new Float64Array(3);

/**
 * Turns `own` to world axes, into `world`.
 *
 * @param toBody turns world axes into the body's; its conjugate is what is applied
 */
export function toWorldAxes({ x: qx, y: qy, z: qz, w }: Quaternion): void {
  const x = own[0]!;
  const y = own[1]!;
  const z = own[2]!;
  const tx = 2 * (-qy * z + qz * y);
  const ty = 2 * (-qz * x + qx * z);
  const tz = 2 * (-qx * y + qy * x);
  world[0] = x + w * tx - (qy * tz - qz * ty);
  world[1] = y + w * ty - (qz * tx - qx * tz);
  world[2] = z + w * tz - (qx * ty - qy * tx);
}
