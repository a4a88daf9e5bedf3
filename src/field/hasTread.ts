import type { Capsule } from './Capsule.js';
import { type FieldMemory, NONE } from './FieldMemory.js';
import { axis, MIXED, PIECE } from './pieces.js';

/** x, z and radius of an upright cylinder, its lower and upper end's y, and the least Y of the normals of interest. */
const query = /* @__PURE__ */ new Float64Array(6);

/**
 * Is there anything to step onto: a surfel no steeper than `slope`, higher above the foot than `low` and no higher than
 * `high`, within `reach` of the capsule's side? A quick look that spares a longer one. Allocates nothing.
 *
 * @param slope least Y of its normal
 */
export function hasTread(
  memory: FieldMemory,
  capsule: Capsule,
  low: number,
  high: number,
  reach: number,
  slope: number,
): boolean {
  axis[0] = capsule.x;
  axis[1] = capsule.z;
  axis[2] = capsule.y + low;
  axis[3] = capsule.y + high;
  axis[4] = capsule.radius + reach;
  memory.gather();
  for (let k = 0; k < memory.kept.length; k++) {
    const { surfels, again, blocks, near, nears } = memory.kept[k]!;
    const { block, first, origin, piece } = surfels;
    query[0] = capsule.x - origin.x;
    query[1] = capsule.z - origin.z;
    query[2] = capsule.radius + reach;
    query[3] = capsule.y + low - origin.y;
    query[4] = capsule.y + high - origin.y;
    query[5] = slope;
    for (let a = 0; a < nears; a++) {
      const b = near[a]!;
      let may = blocks[b] !== NONE && mayBeTread(block, PIECE * b);
      while (may && surfels.refine(b)) may = mayBeTread(block, PIECE * b);
      if (!may || !memory.hasOwn(k, b)) continue;
      for (let i = first[b]!; i < first[b + 1]!; i++) {
        if (again[i] === 0 && mayBeTread(piece, PIECE * i)) return true;
      }
    }
  }
  return false;
}

function mayBeTread(piece: Float32Array, p: number): boolean {
  const extent = piece[p + 3]!;
  let rise = extent;
  if (piece[p + 7] !== MIXED) {
    const up = piece[p + 5]!;
    if (up < query[5]!) return false;
    rise *= Math.sqrt(Math.max(0, 1 - up * up));
  }
  const y = piece[p + 1]!;
  if (y < query[3]! - rise || y > query[4]! + rise) return false;
  const dx = piece[p]! - query[0]!;
  const dz = piece[p + 2]! - query[1]!;
  const within = query[2]! + extent;
  return dx * dx + dz * dz < within * within;
}
