import type { Object3D } from 'three';
import type { Capsule } from './Capsule.js';
import type { FieldMemory } from './FieldMemory.js';
import { axis, nearest, surfelDistance } from './surfelDistance.js';
import { STRIDE } from './Surfels.js';

/** A displacement, body's frame, metres. */
export interface Way {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** Steps of Newton's method for one surfel; it nears the root from before, so fewer are only more careful. */
const ROUNDS = 12;
/** As near as this to the wanted gap is there, metres. */
const CLOSE = 1e-5;
/** How far beside a plane's surfel, in its extents, a place must lie to be some neighbour's for sure. */
const ASIDE = 2.5;

/** The axis relative to the surfel in question (x, z, lower and upper y), the way (x, y, z), the distance wanted. */
const query = /* @__PURE__ */ new Float64Array(8);

/**
 * How much of a displacement the capsule can make until something is `gap` away from it: 0 to 1.
 *
 * What is already nearer than `near` is passed over: getting out of it is another question (`findContacts`). Each
 * surfel's distance is a convex function of the way made, so Newton's method from the start never passes the first
 * impact. Allocates nothing.
 *
 * @param gap metres, may be 0 or less
 * @param near metres, `gap` or more
 * @param only if given, nothing but this object counts
 */
export function timeOfImpact(
  memory: FieldMemory,
  capsule: Capsule,
  way: Way,
  gap: number,
  near = gap,
  only: Object3D | null = null,
): number {
  const { x, y, z } = way;
  const length = Math.sqrt(x * x + y * y + z * z);
  if (length === 0) return 1;
  memory.gather(capsule, length + Math.max(0, gap));
  const { radius } = capsule;
  const wanted = radius + gap;
  const passed = radius + near;
  query[4] = x;
  query[5] = y;
  query[6] = z;
  query[7] = wanted;
  let best = 1;
  for (let k = 0; k < memory.kept.length; k++) {
    const { surfels, near: numbers, nearCount } = memory.kept[k]!;
    const { data, extent, object, origin, whole } = surfels;
    const id = only === null ? 0 : surfels.objects.indexOf(only) + 1;
    if (only !== null && id === 0) continue;
    const cx = capsule.x - origin.x;
    const cz = capsule.z - origin.z;
    const low = capsule.y + radius - origin.y;
    const high = Math.max(low, capsule.y + capsule.height - radius - origin.y);
    for (let a = 0; a < nearCount; a++) {
      const i = numbers[a]!;
      if (id !== 0 && object[i] !== id) continue;
      const o = STRIDE * i;
      query[0] = cx - data[o]!;
      query[1] = cz - data[o + 2]!;
      query[2] = low - data[o + 1]!;
      query[3] = high - data[o + 1]!;
      if (neverNear(data, extent, i) || (whole[i] === 1 && metAside(data, extent, i))) continue;
      let t = 0;
      for (let round = 0; round < ROUNDS; round++) {
        axis[0] = cx + t * x;
        axis[1] = cz + t * z;
        axis[2] = low + t * y;
        axis[3] = high + t * y;
        surfelDistance(surfels, i);
        const d = nearest[4]!;
        if (round === 0 && d <= passed) {
          t = 1;
          break;
        }
        const room = d - wanted;
        const nx = axis[0] - nearest[0]!;
        const ny = nearest[3]! - nearest[1]!;
        const nz = axis[1] - nearest[2]!;
        const approach = -(nx * x + ny * y + nz * z) / d;
        if (approach <= 1e-9) {
          t = 1;
          break;
        }
        if (room < CLOSE) break;
        t += room / approach;
        if (t >= best) break;
      }
      if (t < best) best = t;
    }
  }
  return best;
}

/**
 * Does a surfel stay farther than wanted from the axis all the way, by what is cheap to tell: by the distance of the
 * axis' way from its point, level and upright, and from its plane?
 */
function neverNear(data: Float32Array, extent: Float32Array, i: number): boolean {
  const dx = query[0]!;
  const dz = query[1]!;
  const x = query[4]!;
  const y = query[5]!;
  const z = query[6]!;
  const wanted = query[7]!;
  const level = x * x + z * z;
  let t = level > 0 ? -(dx * x + dz * z) / level : 0;
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  const ex = dx + t * x;
  const ez = dz + t * z;
  const bottom = query[2]! + Math.min(0, y);
  const top = query[3]! + Math.max(0, y);
  const ey = bottom > 0 ? bottom : top < 0 ? top : 0;
  const within = wanted + extent[i]!;
  if (ex * ex + ey * ey + ez * ez >= within * within) return true;
  const o = STRIDE * i + 3;
  const nx = data[o]!;
  const ny = data[o + 1]!;
  const nz = data[o + 2]!;
  const base = nx * dx + nz * dz;
  const along = nx * x + ny * y + nz * z;
  const a = base + ny * query[2]!;
  const b = base + ny * query[3]!;
  const least = Math.min(a, b) + Math.min(0, along);
  const most = Math.max(a, b) + Math.max(0, along);
  return least >= wanted || most <= -wanted;
}

/**
 * Does the axis come as near as wanted to the plane of a surfel, in the midst of that plane, so far beside it that the
 * impact is some neighbour's? Only where it begins farther away than that.
 */
function metAside(data: Float32Array, extent: Float32Array, i: number): boolean {
  const o = STRIDE * i + 3;
  const nx = data[o]!;
  const ny = data[o + 1]!;
  const nz = data[o + 2]!;
  const base = nx * query[0]! + nz * query[1]!;
  const atLow = base + ny * query[2]!;
  const atHigh = base + ny * query[3]!;
  // Which end is nearer to the plane, if both are on one side?
  if (atLow * atHigh <= 0) return false;
  const lowFirst = Math.abs(atLow) <= Math.abs(atHigh);
  const start = lowFirst ? atLow : atHigh;
  const side = start > 0 ? 1 : -1;
  const room = side * start - query[7]!;
  const approach = -side * (nx * query[4]! + ny * query[5]! + nz * query[6]!);
  if (room <= 0 || approach <= 0) return false;
  const t = Math.min(1, room / approach);
  const ex = query[0]! + t * query[4]!;
  const ez = query[1]! + t * query[6]!;
  const bottom = query[2]! + t * query[5]!;
  const top = query[3]! + t * query[5]!;
  // Upright walls are met at all heights at once.
  const upright = Math.abs(ny) < 0.05;
  const ey = upright ? (bottom > 0 ? bottom : top < 0 ? top : 0) : lowFirst ? bottom : top;
  const height = nx * ex + ny * ey + nz * ez;
  const aside = ex * ex + ey * ey + ez * ez - height * height;
  const e = ASIDE * extent[i]!;
  return aside > e * e;
}
