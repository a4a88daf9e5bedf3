import type { Object3D, Quaternion } from 'three';
import { directionTexel } from '../cube/texelDirections.js';
import { GOES_ON, PIECE } from './pieces.js';
import { CORNERS, STRIDE } from './layout.js';
import type { Surfels } from './Surfels.js';

/** Planes no farther apart than this are one, metres. */
const SAME_PLANE = 0.001;
/** Normals closer than this (2.6°) are of one plane. */
const SAME_NORMAL = 0.999;

/** A vector, world axes. */
const turned = /* @__PURE__ */ new Float64Array(3);
/** A place, body's frame, relative to the newer field's centre. */
const place = /* @__PURE__ */ new Float64Array(3);

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
    place[0] = ox;
    place[1] = oy;
    place[2] = oz;
    if (c >= 0) {
      const along = data[o + CORNERS + 1 + 2 * c]!;
      const across = data[o + CORNERS + 2 + 2 * c]!;
      for (let v = 0; v < 3; v++) {
        place[v] = place[v]! + along * data[o + 6 + v]! + across * data[o + 9 + v]!;
      }
    }
    turnPlace(toBody);
    const texel = directionTexel(turned[0]!, turned[1]!, turned[2]!, newer.resolution);
    const j = newer.ofTexel[texel]!;
    if (j < 0 || newer.piece[PIECE * j + 7] !== GOES_ON || objectOf(newer, j) !== object) {
      return false;
    }
    let alike = 0;
    let off = 0;
    for (let v = 0; v < 3; v++) {
      const n = newer.piece[PIECE * j + 4 + v]!;
      alike += n * data[o + 3 + v]!;
      off += n * (place[v]! - newer.piece[PIECE * j + v]!);
    }
    if (alike < SAME_NORMAL || Math.abs(off) > SAME_PLANE) return false;
  }
  return true;
}

/** What surfel `i` belongs to. */
const objectOf = ({ object, objects }: Surfels, i: number): Object3D | undefined =>
  objects[object[i]! - 1];

/** Turns `place` to world axes, into `turned`: by the conjugate of `q`. */
function turnPlace({ x: qx, y: qy, z: qz, w }: Quaternion): void {
  const x = place[0]!;
  const y = place[1]!;
  const z = place[2]!;
  const tx = 2 * (-qy * z + qz * y);
  const ty = 2 * (-qz * x + qx * z);
  const tz = 2 * (-qx * y + qy * x);
  turned[0] = x + w * tx - (qy * tz - qz * ty);
  turned[1] = y + w * ty - (qz * tx - qx * tz);
  turned[2] = z + w * tz - (qx * ty - qy * tx);
}
