import type { Object3D, Quaternion } from 'three';
import { directionTexel } from '../cube/texelDirections.js';
import { CORNERS, STRIDE } from './layout.js';
import { plane, type Surfels } from './Surfels.js';
import { own, toWorldAxes, world } from './toWorldAxes.js';

/** Planes no farther apart than this are one, metres. */
const SAME_PLANE = 0.001;
/** Normals closer than this (2.6°) are of one plane. */
const SAME_NORMAL = 0.999;

/**
 * Does a newer field show all of surfel `i` of an older one again: do its middle and its corners lie in the midst of
 * what the newer has in their direction, in the same plane of the same object? Then the older adds nothing. At most nine
 * texels are looked at; allocates nothing.
 *
 * @param toBody turns world axes into the body's
 */
export function isSeenAgain(
  newer: Surfels,
  older: Surfels,
  i: number,
  toBody: Quaternion,
): boolean {
  const { data } = older;
  const o = STRIDE * i;
  const ox = older.origin.x - newer.origin.x + data[o]!;
  const oy = older.origin.y - newer.origin.y + data[o + 1]!;
  const oz = older.origin.z - newer.origin.z + data[o + 2]!;
  const object = objectOf(older, i);
  const corners = data[o + CORNERS]!;
  for (let c = -1; c < corners; c++) {
    own[0] = ox;
    own[1] = oy;
    own[2] = oz;
    if (c >= 0) {
      const along = data[o + CORNERS + 1 + 2 * c]!;
      const across = data[o + CORNERS + 2 + 2 * c]!;
      for (let v = 0; v < 3; v++) {
        own[v] = own[v]! + along * data[o + 6 + v]! + across * data[o + 9 + v]!;
      }
    }
    toWorldAxes(toBody);
    const texel = directionTexel(world[0]!, world[1]!, world[2]!, newer.resolution);
    const j = newer.ofTexel[texel]!;
    if (j < 0 || objectOf(newer, j) !== object) return false;
    newer.planeOf(texel, j);
    let alike = 0;
    let off = 0;
    for (let v = 0; v < 3; v++) {
      const n = plane[v]!;
      alike += n * data[o + 3 + v]!;
      off += n * (own[v]! - plane[3 + v]!);
    }
    if (alike < SAME_NORMAL || Math.abs(off) > SAME_PLANE || !newer.goesOn(texel, j)) return false;
  }
  return true;
}

/** What surfel `i` belongs to. */
const objectOf = ({ object, objects }: Surfels, i: number): Object3D | undefined =>
  objects[object[i]! - 1];
