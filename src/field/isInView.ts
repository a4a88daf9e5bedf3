import { directionTexel } from '../cube/texelDirections.js';
import type { FieldMemory } from './FieldMemory.js';
import { PIECE } from './pieces.js';
import type { Surfels } from './Surfels.js';

/** A plane seen at a slant is taken to run from half as far as its texel saw it to so many times as far. */
const LONGEST = 2;

/** The place that `isInView` is about: x, y, z, body's frame, metres. Set it before; see `axis` in `pieces.ts`. */
export const place = /* @__PURE__ */ new Float64Array(3);

/**
 * Has any kept field looked through `place`: does it lie before what that field saw in its direction? Finer than
 * `isKnownFree`, for what is metres away: there one texel of a floor is half a metre long, and all of the air above its
 * plane is free, not only what is nearer than its nearest point. Constant time; allocates nothing.
 *
 * @param memory whose body's frame is the world's
 */
export function isInView(memory: FieldMemory): boolean {
  for (let k = 0; k < memory.kept.length; k++) {
    if (liesBefore(memory.kept[k]!.surfels)) return true;
  }
  return false;
}

function liesBefore(surfels: Surfels): boolean {
  const { blockOf, distance, far, ofTexel, origin, piece, resolution } = surfels;
  const x = place[0]! - origin.x;
  const y = place[1]! - origin.y;
  const z = place[2]! - origin.z;
  const away = Math.sqrt(x * x + y * y + z * z);
  if (away === 0) return true;
  if (away > far) return false;
  const texel = directionTexel(x, y, z, resolution);
  const seen = distance[texel]!;
  // At a slant the plane may be met sooner than its texel says, or later.
  if (LONGEST * away < seen) return true;
  if (away > LONGEST * seen) return false;
  const i = ofTexel[texel]!;
  if (i < 0) return away < seen;
  surfels.find(blockOf[i]!);
  const p = PIECE * i;
  const height =
    (x - piece[p]!) * piece[p + 4]! +
    (y - piece[p + 1]!) * piece[p + 5]! +
    (z - piece[p + 2]!) * piece[p + 6]!;
  return height > 0;
}
