import { directionTexel } from '../cube/texelDirections.js';

/**
 * Did a cubemap see the place to be free: is it nearer to the centre than the surface in its direction, by at least
 * `margin`? What is not may lie behind something. Constant time, one texel; allocates nothing.
 *
 * @param distance of every texel, metres; Infinity where nothing was seen
 * @param resolution texels per face edge
 * @param far how far the cubemap saw, metres
 * @param x @param y @param z from the centre to the place, world axes, metres
 * @param margin metres
 */
export function isKnownFree(
  distance: Float32Array,
  resolution: number,
  far: number,
  x: number,
  y: number,
  z: number,
  margin: number,
): boolean {
  const away = Math.sqrt(x * x + y * y + z * z);
  if (away === 0) return true;
  if (away + margin > far) return false;
  return away + margin < distance[directionTexel(x, y, z, resolution)]!;
}
