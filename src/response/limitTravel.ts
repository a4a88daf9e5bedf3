import type { Vector3 } from 'three';
import type { AxisMaxima } from '../cube/AxisMaxima.js';

/** Part of the shell that travel may use up: beyond the whole of it, red can grow no more and walls are lost. */
const ROOM = 0.9;
/** Part of the shell that is always free to move in, so that a squeezed sphere can still get out. */
const LEAST = 0.1;
/** Halvings in search of the longest travel: to 1/256 of it. */
const HALVINGS = 8;

/**
 * The part of a travel that a sphere may make before the next cubemap, 0 to 1: so far that nothing can have come
 * nearer than rMin, where red saturates and a push no longer grows with penetration.
 *
 * Mend of the paper's silent speed limit: without it a sphere that moves more than rMax - rMin between two cubemaps
 * passes through walls, and one that keeps walking at a wall by more than c_xz times that ends up behind it. Every
 * surface a face saw lies at its maximum or farther out, so the bound holds for all of them, not for the winner alone:
 * penetration + the most that any direction of the face is approached <= 0.9·(rMax - rMin).
 *
 * @param maxima newest cubemap
 * @param center where the sphere is now, world space, metres
 * @param travel where it wants to go from there, metres
 */
export function limitTravel(maxima: AxisMaxima, center: Vector3, travel: Vector3): number {
  if (known(maxima, center, travel, 1)) return 1;
  if (!known(maxima, center, travel, 0)) return 0;
  let low = 0;
  let high = 1;
  for (let i = 0; i < HALVINGS; i++) {
    const middle = (low + high) / 2;
    if (known(maxima, center, travel, middle)) low = middle;
    else high = middle;
  }
  return low;
}

/** Is the sphere at center + part · travel still where `maxima` can vouch that nothing is nearer than rMin? */
function known(maxima: AxisMaxima, center: Vector3, travel: Vector3, part: number): boolean {
  const shell = maxima.rMax - maxima.rMin;
  const x = center.x + part * travel.x - maxima.center.x;
  const y = center.y + part * travel.y - maxima.center.y;
  const z = center.z + part * travel.z - maxima.center.z;
  const least = LEAST * shell;
  if (x * x + y * y + z * z <= least * least) return true;
  for (let face = 0; face < 6; face++) {
    if (maxima.penetration(face) + approach(face, x, y, z) > ROOM * shell) return false;
  }
  return true;
}

/**
 * How much nearer a move can bring the sphere to anything that a face sees: the largest dot product of the move with a
 * unit direction of that face, metres; negative if it leads away from all of them.
 */
export function approach(face: number, x: number, y: number, z: number): number {
  const axis = face >> 1;
  const along = axis === 0 ? x : axis === 1 ? y : z;
  const forward = (face & 1) === 0 ? along : -along;
  const first = Math.abs(axis === 0 ? y : x);
  const second = Math.abs(axis === 2 ? y : z);
  const more = Math.max(first, second);
  const less = Math.min(first, second);
  // The move points into the face: its own direction is the nearest.
  if (forward >= more) return Math.sqrt(x * x + y * y + z * z);
  // Else the nearest lies on the edge toward the larger of the other two, (1, 1, w)/√(2 + w²), or at its corner, w = 1.
  const sum = forward + more;
  return sum > 0 && 2 * less <= sum
    ? Math.sqrt((sum * sum) / 2 + less * less)
    : (sum + less) / Math.sqrt(3);
}
