import { texelIndex } from './atlas.js';
import { FACE_AXES } from './faces.js';

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

const known = new Map<number, Float32Array>();

/** The same, made once a resolution and shared: only to be read. */
export function sharedDirections(resolution: number): Float32Array {
  let directions = known.get(resolution);
  if (directions === undefined) known.set(resolution, (directions = texelDirections(resolution)));
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
  const step = 1 / resolution;
  const u = (2 * x + 1) * step - 1;
  const v = (2 * y + 1) * step - 1;
  const inverse = 1 / Math.sqrt(1 + u * u + v * v);
  // Without FACES: a decoder asks thousands of times a field.
  const a = 6 * face;
  target[offset + FACE_AXES[a]!] = FACE_AXES[a + 3]! * inverse;
  target[offset + FACE_AXES[a + 1]!] = FACE_AXES[a + 4]! * u * inverse;
  target[offset + FACE_AXES[a + 2]!] = FACE_AXES[a + 5]! * v * inverse;
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
  // What `right` and `up` of FACES tell, written out.
  let face: number;
  let u: number;
  let v: number;
  if (ax >= ay && ax >= az) {
    face = x < 0 ? 1 : 0;
    u = (x < 0 ? -z : z) / ax;
    v = y / ax;
  } else if (ay >= az) {
    face = y < 0 ? 3 : 2;
    u = x / ay;
    v = (y < 0 ? -z : z) / ay;
  } else {
    face = z < 0 ? 5 : 4;
    u = (z < 0 ? x : -x) / az;
    v = y / az;
  }
  const column = Math.min(resolution - 1, Math.floor((u + 1) * 0.5 * resolution));
  const row = Math.min(resolution - 1, Math.floor((v + 1) * 0.5 * resolution));
  return texelIndex(face, column, row, resolution);
}
