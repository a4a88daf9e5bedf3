import { Box3, Quaternion, Vector3 } from 'three';
import { STRIDE } from './triangles.js';

/** The axis of a file that points to the sky. */
export type Up = '+Y' | '+Z' | '-Y' | '-Z' | '+X' | '-X';

export const UPS: readonly Up[] = ['+Y', '+Z', '-Z', '-Y', '+X', '-X'];

const AXES = { X: new Vector3(1, 0, 0), Y: new Vector3(0, 1, 0), Z: new Vector3(0, 0, 1) };

/** Sums that leave the file as glTF has it, Y up, unless they speak for Z this much louder. */
const LOUDER = 1.6;
/** The same of files without open ground, whose boxes speak less clearly. */
const CLOSED = 1.9;
/** Part of all area that open ground must have for its side to count. */
const OPEN = 0.05;

/** The turn that brings `up` to +Y. */
export function turnOf(up: Up): Quaternion {
  const axis = AXES[up[1] as keyof typeof AXES].clone();
  if (up.startsWith('-')) axis.negate();
  // Half a turn about X, not about whatever axis: what was to the right stays there.
  if (up === '-Y') return new Quaternion().setFromAxisAngle(AXES.X, Math.PI);
  return new Quaternion().setFromUnitVectors(axis, AXES.Y);
}

/**
 * Which way is up in a file. glTF says +Y; files of Z-up tools that were never converted are told by their ground: a level
 * has most of its area lying flat, and open ground, a terrain or a floor without underside, faces up.
 *
 * @param soup triangles, nine coordinates each
 */
export function guessUp(soup: Float32Array): Up {
  const { open, flat, total } = areas(soup);
  if (total === 0) return '+Y';
  const [x, y, z] = open.map(Math.abs) as [number, number, number];
  const strongest = Math.max(x, y, z);
  if (strongest > OPEN * total) {
    // Backdrops and façades without a back count too, so the flat parts must agree.
    return z === strongest && z > LOUDER * y && flat[2] > flat[1] ? '+Z' : '+Y';
  }
  // All is closed. A tower that stands has walls to two sides; one that lies has its ground to one.
  const size = boundsOf(soup).getSize(new Vector3());
  const lies = size.z < 0.7 * size.y && size.z < 0.7 * size.x;
  return lies && flat[2] > CLOSED * Math.max(flat[0], flat[1]) ? '+Z' : '+Y';
}

/** Areas by axis: `open`, what no opposite side makes up for; `flat`, of all that faces along it; of everything. */
function areas(soup: Float32Array) {
  const open: [number, number, number] = [0, 0, 0];
  const flat: [number, number, number] = [0, 0, 0];
  let total = 0;
  for (let i = 0; i + STRIDE <= soup.length; i += STRIDE) {
    const ux = soup[i + 3]! - soup[i]!;
    const uy = soup[i + 4]! - soup[i + 1]!;
    const uz = soup[i + 5]! - soup[i + 2]!;
    const vx = soup[i + 6]! - soup[i]!;
    const vy = soup[i + 7]! - soup[i + 1]!;
    const vz = soup[i + 8]! - soup[i + 2]!;
    const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx] as const;
    const area = Math.hypot(...n);
    if (!(area > 0)) continue;
    total += area;
    for (let k = 0; k < 3; k++) {
      open[k]! += n[k]!;
      if (Math.abs(n[k]!) > 0.8 * area) flat[k]! += area;
    }
  }
  return { open, flat, total };
}

/** The box around triangles. */
export function boundsOf(soup: Float32Array): Box3 {
  return new Box3().setFromArray(soup as unknown as number[]);
}
