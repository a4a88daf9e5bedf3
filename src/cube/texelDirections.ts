import { texelIndex } from './atlas.js';
import { FACES } from './faces.js';

/**
 * Unit vectors from the centre through the middle of every texel, world axes: equations (14)-(16) with r = 1.
 *
 * The paper keeps θ and φ and takes sines each frame; the vectors themselves need neither (audit of (14)-(16): the
 * directions are right, the magnitude r is not a length; see `axisMaxima.ts`).
 *
 * @param resolution texels per face edge
 * @returns x, y, z for each of 6 · resolution² texels, in the order of `texelIndex`
 */
export function texelDirections(resolution: number): Float32Array {
  const directions = new Float32Array(6 * resolution * resolution * 3);
  for (let face = 0; face < 6; face++) {
    for (let y = 0; y < resolution; y++) {
      for (let x = 0; x < resolution; x++) {
        texelDirection(face, x, y, resolution, directions, 3 * texelIndex(face, x, y, resolution));
      }
    }
  }
  return directions;
}

/**
 * The unit vector through the middle of one texel, world axes.
 *
 * @param target written at `offset`, `offset + 1`, `offset + 2`
 */
export function texelDirection(
  face: number,
  x: number,
  y: number,
  resolution: number,
  target: Float32Array | number[],
  offset = 0,
): void {
  const { forward, right, up } = FACES[face]!;
  const u = (2 * x + 1) / resolution - 1;
  const v = (2 * y + 1) / resolution - 1;
  const inverse = 1 / Math.sqrt(1 + u * u + v * v);
  // Written out: a decoder asks thousands of times a field.
  target[offset] = (forward[0] + u * right[0] + v * up[0]) * inverse;
  target[offset + 1] = (forward[1] + u * right[1] + v * up[1]) * inverse;
  target[offset + 2] = (forward[2] + u * right[2] + v * up[2]) * inverse;
}

/**
 * The texel that a direction passes through.
 *
 * @param x @param y @param z a vector of any length but zero, world axes
 * @returns its number, in the order of `texelIndex`
 */
export function directionTexel(x: number, y: number, z: number, resolution: number): number {
  const ax = Math.abs(x);
  const ay = Math.abs(y);
  const az = Math.abs(z);
  const axis = ax >= ay && ax >= az ? 0 : ay >= az ? 1 : 2;
  const along = axis === 0 ? x : axis === 1 ? y : z;
  const face = 2 * axis + (along < 0 ? 1 : 0);
  const { right, up } = FACES[face]!;
  const depth = Math.abs(along);
  const u = (x * right[0] + y * right[1] + z * right[2]) / depth;
  const v = (x * up[0] + y * up[1] + z * up[2]) / depth;
  const column = Math.min(resolution - 1, Math.floor((u + 1) * 0.5 * resolution));
  const row = Math.min(resolution - 1, Math.floor((v + 1) * 0.5 * resolution));
  return texelIndex(face, column, row, resolution);
}
