import type { Object3D } from 'three';
import type { Capsule } from './Capsule.js';
import { type FieldMemory, NONE } from './FieldMemory.js';
import { axis, GOES_ON, MIXED, PIECE } from './pieces.js';
import { nearest, surfelDistance } from './surfelDistance.js';
import type { Surfels } from './Surfels.js';

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
/** How far beside a piece of a plane, in its extents, a place must lie to be some neighbour's for sure. */
const ASIDE = 1.5;

/** What is approached by less than this part of the way is grazed: 6° from along it. */
const GRAZING = 0.1;

/**
 * The axis before the way (x, z, lower and upper y), the way (x, y, z), the distance wanted, what is passed over, the
 * distance wanted of what is grazed, how much of an approach that is, metres, and the part of the way that can be made, as
 * far as is known. (Numbers handed over or back would be wrapped in objects.)
 */
const query = /* @__PURE__ */ new Float64Array(12);

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
 * @param graze gap to what is passed nearly along its surface, metres, `gap` or less
 */
export function timeOfImpact(
  memory: FieldMemory,
  capsule: Capsule,
  way: Way,
  gap: number,
  near = gap,
  only: Object3D | null = null,
  graze = gap,
): number {
  const { x, y, z } = way;
  const length = Math.sqrt(x * x + y * y + z * z);
  if (length === 0) return 1;
  const { radius } = capsule;
  query[4] = x;
  query[5] = y;
  query[6] = z;
  query[7] = radius + gap;
  query[8] = radius + near;
  query[9] = radius + graze;
  query[10] = graze < gap ? GRAZING * length : 0;
  query[11] = 1;
  // What the axis sweeps lies around the middle of its way.
  axis[0] = capsule.x + x / 2;
  axis[1] = capsule.z + z / 2;
  axis[2] = capsule.y + radius + Math.min(0, y);
  axis[3] = Math.max(capsule.y + radius, capsule.y + capsule.height - radius) + Math.max(0, y);
  axis[4] = radius + gap + Math.sqrt(x * x + z * z) / 2;
  memory.gather();
  for (let k = 0; k < memory.kept.length; k++) {
    const { surfels, again, blocks, near, nears } = memory.kept[k]!;
    const { block, first, object, origin, piece } = surfels;
    const id = only === null ? 0 : surfels.objects.indexOf(only) + 1;
    if (only !== null && id === 0) continue;
    query[0] = capsule.x - origin.x;
    query[1] = capsule.z - origin.z;
    query[2] = capsule.y + radius - origin.y;
    query[3] = Math.max(query[2]!, capsule.y + capsule.height - radius - origin.y);
    for (let a = 0; a < nears; a++) {
      const b = near[a]!;
      let away = blocks[b] === NONE || passesBy(block, PIECE * b);
      while (!away && surfels.refine(b)) away = passesBy(block, PIECE * b);
      if (away || !memory.hasOwn(k, b)) continue;
      for (let i = first[b]!; i < first[b + 1]!; i++) {
        if (again[i] === 1 || passesBy(piece, PIECE * i)) continue;
        if (id !== 0 && object[i] !== id) continue;
        impact(surfels, i);
      }
    }
  }
  return query[11]!;
}

/** Shortens the part of the way that can be made if surfel `i` is met on it. */
function impact(surfels: Surfels, i: number): void {
  const x = query[4]!;
  const y = query[5]!;
  const z = query[6]!;
  const along = isGrazed(surfels.piece, PIECE * i);
  let t = 0;
  for (let round = 0; round < ROUNDS; round++) {
    axis[0] = query[0]! + t * x;
    axis[1] = query[1]! + t * z;
    axis[2] = query[2]! + t * y;
    axis[3] = query[3]! + t * y;
    surfelDistance(surfels, i);
    const d = nearest[4]!;
    if (round === 0 && d <= query[8]!) return;
    let room = d - query[7]!;
    const nx = axis[0] - nearest[0]!;
    const ny = nearest[3]! - nearest[1]!;
    const nz = axis[1] - nearest[2]!;
    const approach = -(nx * x + ny * y + nz * z) / d;
    if (approach <= 1e-9) return;
    // The farther on the way, the less it is approached.
    if (along || approach < query[10]!) room = d - query[9]!;
    if (room < CLOSE) break;
    t += room / approach;
    if (t >= query[11]!) return;
  }
  query[11] = t;
}

/**
 * Does the way lead along a plane, in the midst of which the piece lies? Its neighbours go on where that ends; of another
 * the edge may be met otherwise than the plane.
 */
function isGrazed(piece: Float32Array, p: number): boolean {
  if (query[10] === 0 || piece[p + 7] !== GOES_ON) return false;
  const along = piece[p + 4]! * query[4]! + piece[p + 5]! * query[5]! + piece[p + 6]! * query[6]!;
  return along < query[10]! && along > -query[10]!;
}

/**
 * Is it cheap to tell that a piece stays farther than wanted from the axis all the way, by the distance of the axis' way
 * from its point, level and upright, or from its plane; or that a neighbour of it is met before?
 */
function passesBy(piece: Float32Array, p: number): boolean {
  const dx = query[0]! - piece[p]!;
  const dz = query[1]! - piece[p + 2]!;
  const py = piece[p + 1]!;
  const low = query[2]! - py;
  const high = query[3]! - py;
  const x = query[4]!;
  const y = query[5]!;
  const z = query[6]!;
  let wanted = query[7]!;
  const level = x * x + z * z;
  let t = level > 0 ? -(dx * x + dz * z) / level : 0;
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  const ex = dx + t * x;
  const ez = dz + t * z;
  const bottom = y < 0 ? low + y : low;
  const top = y > 0 ? high + y : high;
  const ey = bottom > 0 ? bottom : top < 0 ? top : 0;
  const extent = piece[p + 3]!;
  const within = wanted + extent;
  if (ex * ex + ey * ey + ez * ez >= within * within) return true;
  const kind = piece[p + 7]!;
  if (kind === MIXED) return false;
  const nx = piece[p + 4]!;
  const ny = piece[p + 5]!;
  const nz = piece[p + 6]!;
  const base = nx * dx + nz * dz;
  const along = nx * x + ny * y + nz * z;
  if (isGrazed(piece, p)) wanted = query[9]!;
  const atLow = base + ny * low;
  const atHigh = base + ny * high;
  const lowFirst = Math.abs(atLow) <= Math.abs(atHigh);
  const start = lowFirst ? atLow : atHigh;
  const less = along < 0 ? along : 0;
  const more = along > 0 ? along : 0;
  if (
    atLow < atHigh
      ? atLow + less >= wanted || atHigh + more <= -wanted
      : atHigh + less >= wanted || atLow + more <= -wanted
  )
    return true;
  // In the midst of a plane only what lies where the axis first comes as near as wanted counts, unless both ends lie on
  // either side of it or it begins nearer.
  if (kind !== GOES_ON || atLow * atHigh <= 0) return false;
  const side = start > 0 ? 1 : -1;
  const room = side * start - wanted;
  const approach = -side * along;
  if (room <= 0 || approach <= 0) return false;
  const part = room < approach ? room / approach : 1;
  const fx = dx + part * x;
  const fz = dz + part * z;
  const lowThen = low + part * y;
  const highThen = high + part * y;
  // Upright walls are met at all heights at once.
  const upright = ny < 0.05 && ny > -0.05;
  const inside = lowThen > 0 ? lowThen : highThen < 0 ? highThen : 0;
  const fy = upright ? inside : lowFirst ? lowThen : highThen;
  const height = nx * fx + ny * fy + nz * fz;
  const aside = fx * fx + fy * fy + fz * fz - height * height;
  const border = ASIDE * extent;
  return aside > border * border;
}
