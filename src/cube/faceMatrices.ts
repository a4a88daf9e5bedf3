import type { Matrix4 } from 'three';
import { FACES } from './faces.js';

/**
 * One face's P_side, equations (1)-(8): world axes relative to the centre, to WebGL clip space (z from -1 to 1).
 *
 * P_side = P_persp90 · R_sideᵀ. Row by row: x' along the face's `right`, y' along `up`, z' = -A·depth + B, w = depth,
 * with depth measured along `forward`.
 *
 * Mend of (3) and (5): the printed matrix for the front lacks its fourth row, (0, 0, -1, 0), and the one for the bottom
 * has a five-entry third row that must read (0, A, 0, B); both follow from the four that are whole. WebGPU clips z
 * to 0..1 and wants another A and B: let three's cameras make them there.
 *
 * @param face index in `FACES`
 * @param near z_min, metres, > 0 (see `clipPlanes`)
 * @param far z_max, metres, > near
 * @returns `target`
 */
export function faceProjection(face: number, near: number, far: number, target: Matrix4): Matrix4 {
  const { forward: f, right: r, up: u } = FACES[face]!;
  const a = -(far + near) / (far - near); // (1)
  const b = (-2 * far * near) / (far - near); // (2)
  // `+ 0` turns -0 into 0.
  // prettier-ignore
  return target.set(
    r[0], r[1], r[2], 0,
    u[0], u[1], u[2], 0,
    -a * f[0] + 0, -a * f[1] + 0, -a * f[2] + 0, b,
    f[0], f[1], f[2], 0,
  );
}

/**
 * R_side: the rotation from a face's camera axes to world axes, entries exactly 0, 1 or -1. Columns are `right`, `up`
 * and -`forward`, as a three camera (which looks along its -Z) wants them in its world matrix.
 *
 * @param face index in `FACES`
 * @returns `target`
 */
export function faceRotation(face: number, target: Matrix4): Matrix4 {
  const { forward: f, right: r, up: u } = FACES[face]!;
  // prettier-ignore
  return target.set(
    r[0], u[0], 0 - f[0], 0,
    r[1], u[1], 0 - f[1], 0,
    r[2], u[2], 0 - f[2], 0,
    0, 0, 0, 1,
  );
}

/** Near plane as a part of rMax: 24 bits of depth still order what the colour measures. */
const NEAR_RATIO = 0.01;

/**
 * z_min and z_max of a face's camera from the shell's radii, equations (12) and (13), metres.
 *
 * Mend of (12): depth is distance · cos α and a face's corner lies at cos α = 1/√3, so z_min may be at most rMin/√3
 * (rMin/√2 loses an eighth of all directions at rMin). It is set lower still, 0.01·rMax: a wall met head-on has one
 * depth, and all of it would vanish at once where contact is deepest. Nearer distances clamp to red = 1 instead.
 *
 * Mend of (13): depth never exceeds distance, so z_max = rMax is enough; √2·rMax only draws what red then clamps to 0.
 */
export function clipPlanes(rMin: number, rMax: number): { near: number; far: number } {
  return { near: Math.min(rMin / Math.sqrt(3), NEAR_RATIO * rMax), far: rMax };
}
