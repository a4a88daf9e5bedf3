import type { Vector3 } from 'three';

/**
 * Writes the matrix that puts what points along +Y at `point`, along `normal`, `size` times as large.
 *
 * @param target 16 numbers, column by column, from `offset` on
 * @param point world space, metres
 * @param origin of the matrix's frame, world space, metres
 * @param normal unit vector, world axes
 */
export function placeAlong(
  target: Float32Array | { [index: number]: number },
  offset: number,
  point: Readonly<Vector3>,
  origin: Readonly<Vector3>,
  normal: Readonly<Vector3>,
  size: number,
): void {
  const { x, y, z } = normal;
  // Duff et al. 2017, Building an Orthonormal Basis, Revisited: no direction is singular.
  const sign = z < 0 ? -1 : 1;
  const a = -1 / (sign + z);
  const b = x * y * a;
  // Right-handed: first × normal = second.
  target[offset] = size * b;
  target[offset + 1] = size * (sign + y * y * a);
  target[offset + 2] = size * -y;
  target[offset + 3] = 0;
  target[offset + 4] = size * x;
  target[offset + 5] = size * y;
  target[offset + 6] = size * z;
  target[offset + 7] = 0;
  target[offset + 8] = size * (1 + sign * x * x * a);
  target[offset + 9] = size * sign * b;
  target[offset + 10] = size * -sign * x;
  target[offset + 11] = 0;
  target[offset + 12] = point.x - origin.x;
  target[offset + 13] = point.y - origin.y;
  target[offset + 14] = point.z - origin.z;
  target[offset + 15] = 1;
}
