import type { Vector3 } from 'three';
import type { AxisMaxima } from '../cube/AxisMaxima.js';
import { penetrationAt } from './AxisResponse.js';

/** How deep a wall that is walked against may be entered, as a part of rMax: 3.5 mm of 0.35 m, five steps of red. */
const TOUCH_RATIO = 0.01;

/**
 * Takes out of a wanted travel what leads into a wall that the last cubemap already shows: along x and z, each toward
 * its own face, down to what keeps touch with the wall.
 *
 * Mend of the drawing loop (§2.1), which adds the user's displacement anew each frame and has c_xz of the penetration
 * taken back: walking at a wall then ends at t/c_xz - t inside it (50 mm at 3 m/s and 60 Hz), the more the slower the
 * frames, and a kerb's edge met that deep slips under the sphere: one of 0.85 rMax was climbed. Touch is kept, not
 * left, or wall and wish would take turns.
 *
 * @param maxima newest cubemap
 * @param center where the sphere is now, world space, metres
 * @param wish wanted travel, metres, changed in place; y is let be
 */
export function clipWish(maxima: AxisMaxima, center: Vector3, wish: Vector3): Vector3 {
  wish.x = clip(maxima, center, 0, wish.x);
  wish.z = clip(maxima, center, 2, wish.z);
  return wish;
}

function clip(maxima: AxisMaxima, center: Vector3, axis: number, wish: number): number {
  const face = 2 * axis + (wish < 0 ? 1 : 0);
  const depth = penetrationAt(maxima, face, center);
  if (depth === 0) return wish;
  const room = Math.max(0, TOUCH_RATIO * maxima.rMax - depth);
  return Math.sign(wish) * Math.min(Math.abs(wish), room);
}
