import { SIDES } from './neighbours.js';
import type { Texels } from './Texels.js';

/** A back this near to its neighbour's front, along the ray, is seen through their common edge, metres. */
const SEAM = 0.02;
/** Normals closer than this (2.6°) are of one plane. */
const SAME_NORMAL = 0.999;
/** Neighbours of one kind that no texel of a line has. */
const WIDE = 3;

/**
 * Is what the texel saw the back of a surface, shining through the edge that it shares with a front? By rounding a ray
 * may slip in between the two, and meet the inside of a wall's top where it meets the wall. Taken for a surface of its
 * own it would be a ceiling that juts out from the wall, as wide as a texel at a slant: centimetres to be caught on.
 *
 * Such texels lie in a line, one wide, along the edge: a back that can be seen goes on in three neighbours or all.
 *
 * @param table `neighbours(texels.resolution)`
 */
export function isSeam(texels: Texels, i: number, table: Int32Array): boolean {
  const { direction, distance, front, normal } = texels;
  if (front[i] === 1) return false;
  const k = 3 * i;
  let meetsFront = false;
  let alikes = 0;
  for (let side = 0; side < SIDES; side++) {
    const j = table[SIDES * i + side]!;
    if (distance[j] === Infinity) continue;
    const m = 3 * j;
    if (front[j] === 0) {
      const alike =
        normal[k]! * normal[m]! + normal[k + 1]! * normal[m + 1]! + normal[k + 2]! * normal[m + 2]!;
      if (alike > SAME_NORMAL && ++alikes === WIDE) return false;
      continue;
    }
    // The neighbour's plane along its own ray and along this one.
    const there =
      normal[m]! * direction[m]! +
      normal[m + 1]! * direction[m + 1]! +
      normal[m + 2]! * direction[m + 2]!;
    const here =
      normal[m]! * direction[k]! +
      normal[m + 1]! * direction[k + 1]! +
      normal[m + 2]! * direction[k + 2]!;
    if (Math.abs((distance[j]! * there) / here - distance[i]!) < SEAM) meetsFront = true;
  }
  return meetsFront;
}
