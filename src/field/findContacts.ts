import type { Capsule } from './Capsule.js';
import { ContactSet } from './ContactSet.js';
import { type FieldMemory, type KeptField, NONE } from './FieldMemory.js';
import { SIDES } from './neighbours.js';
import { axis, isOutOfReach, PIECE } from './pieces.js';
import { nearest, surfelDistance } from './surfelDistance.js';
import { STRIDE } from './layout.js';

/** Normals closer than this (1.8°) count as one. */
const SAME_NORMAL = 0.9995;
/** Contacts of one normal whose gaps differ by less than this lie in one surface, metres. */
const SAME_GAP = 0.002;
/** A neighbour is nearer if it is so by more than this, metres: rounding must not drop both. */
const NEARER = 1e-4;

/** Nearest points found in the first pass: x, y, z and whether on the border each. */
let found = new Float64Array(4 * 512);
let foundSurfel = new Int32Array(512);
/** Surfels whose distance is noted. */
let noted = new Int32Array(512);
let notes = 0;

/**
 * The contacts of a capsule with whatever lies within `reach` of it.
 *
 * Only places where the surface is nearest among what is around them count: of a flat floor the one under the foot,
 * however many surfels it is made of. A surfel that is met at a side where the surface goes on leaves the word to its
 * neighbour. Like normals are merged, the nearest stays. Allocates nothing in the steady state.
 *
 * @param reach metres
 * @returns `target`
 */
export function findContacts(
  memory: FieldMemory,
  capsule: Capsule,
  reach: number,
  target: ContactSet,
): ContactSet {
  target.count = 0;
  axis[0] = capsule.x;
  axis[1] = capsule.z;
  axis[2] = capsule.y + capsule.radius;
  axis[3] = Math.max(axis[2]!, capsule.y + capsule.height - capsule.radius);
  axis[4] = capsule.radius + reach;
  memory.gather();
  for (let k = 0; k < memory.kept.length; k++) {
    findIn(memory, k, capsule, reach, target);
  }
  return target;
}

function findIn(
  memory: FieldMemory,
  kept: number,
  capsule: Capsule,
  reach: number,
  target: ContactSet,
): void {
  const field = memory.kept[kept]!;
  const { surfels, again, blocks, distance, near, nears } = field;
  const { block, data, first, origin, piece } = surfels;
  const x = capsule.x - origin.x;
  const z = capsule.z - origin.z;
  const low = capsule.y + capsule.radius - origin.y;
  const high = Math.max(low, capsule.y + capsule.height - capsule.radius - origin.y);
  const reached = capsule.radius + reach;
  axis[0] = x;
  axis[1] = z;
  axis[2] = low;
  axis[3] = high;
  axis[4] = reached;
  if (foundSurfel.length < surfels.count) {
    found = new Float64Array(4 * surfels.count);
    foundSurfel = new Int32Array(surfels.count);
    noted = new Int32Array(surfels.count);
  }
  notes = 0;
  let n = 0;
  for (let a = 0; a < nears; a++) {
    const b = near[a]!;
    let away = blocks[b] === NONE || isOutOfReach(block, PIECE * b);
    while (!away && surfels.refine(b)) away = isOutOfReach(block, PIECE * b);
    if (away || !memory.hasOwn(kept, b)) continue;
    for (let i = first[b]!; i < first[b + 1]!; i++) {
      if (again[i] === 1 || isOutOfReach(piece, PIECE * i)) continue;
      note(field, i);
      if (nearest[4]! >= reached) continue;
      foundSurfel[n] = i;
      found[4 * n] = nearest[0]!;
      found[4 * n + 1] = nearest[1]!;
      found[4 * n + 2] = nearest[2]!;
      found[4 * n + 3] = nearest[5]!;
      n++;
    }
  }

  for (let a = 0; a < n; a++) {
    const i = foundSurfel[a]!;
    const onBorder = found[4 * a + 3] === 1;
    const d = distance[i]!;
    if (onBorder && goesOnNearer(field, i)) continue;
    const px = found[4 * a]!;
    const py = found[4 * a + 1]!;
    const pz = found[4 * a + 2]!;
    const o = STRIDE * i;
    const up = data[o + 4]!;
    let nx = x - px;
    let ny = (py < low ? low : py > high ? high : py) - py;
    let nz = z - pz;
    if (d > 1e-4) {
      nx /= d;
      ny /= d;
      nz /= d;
    } else {
      // The axis itself touches it: the side it was seen from is the best guess.
      nx = data[o + 3]!;
      ny = up;
      nz = data[o + 5]!;
    }
    one[0] = px + origin.x;
    one[1] = py + origin.y;
    one[2] = pz + origin.z;
    one[3] = nx;
    one[4] = ny;
    one[5] = nz;
    one[6] = d - capsule.radius;
    one[7] = up;
    add(target, kept, i);
  }
  for (let a = 0; a < notes; a++) distance[noted[a]!] = Infinity;
}

/** Finds a surfel's distance and keeps it. */
function note({ surfels, distance }: KeptField, i: number): void {
  surfelDistance(surfels, i);
  distance[i] = nearest[4]!;
  noted[notes++] = i;
}

/** Does the surface come nearer to the body in a neighbour of surfel `i` that goes on where it ends? */
function goesOnNearer(field: KeptField, i: number): boolean {
  const { surfels, distance } = field;
  const { link, moved, object } = surfels;
  for (let side = 0; side < SIDES; side++) {
    const j = link[SIDES * i + side]!;
    if (j < 0) continue;
    // It may not have been of interest itself.
    if (distance[j] === Infinity) {
      surfels.find(surfels.blockOf[j]!);
      note(field, j);
    }
    if (!(distance[j]! < distance[i]! - NEARER)) continue;
    // Moved apart, they are neighbours no more.
    const a = object[i]!;
    const b = object[j]!;
    if (a === b || (moved[a] === 0 && moved[b] === 0)) return true;
  }
  return false;
}

/** A contact to be added: point, normal (3 each), gap, upward part of the surface's own normal. */
const one = /* @__PURE__ */ new Float64Array(8);

function add(target: ContactSet, kept: number, surfel: number): void {
  const { normal, point } = target;
  const nx = one[3]!;
  const ny = one[4]!;
  const nz = one[5]!;
  const gap = one[6]!;
  let up = one[7]!;
  let slot = -1;
  for (let c = 0; c < target.count; c++) {
    const alike = nx * normal[3 * c]! + ny * normal[3 * c + 1]! + nz * normal[3 * c + 2]!;
    if (alike < SAME_NORMAL) continue;
    const other = target.gap[c]!;
    if (Math.abs(gap - other) < SAME_GAP) {
      up = Math.max(up, target.surfaceUp[c]!);
      target.surfaceUp[c] = up;
    }
    if (gap >= other) return;
    slot = c;
    break;
  }
  if (slot < 0) {
    if (target.count < ContactSet.CAPACITY) {
      slot = target.count++;
    } else {
      // Full: the farthest gives way.
      slot = 0;
      for (let c = 1; c < target.count; c++) if (target.gap[c]! > target.gap[slot]!) slot = c;
      if (target.gap[slot]! <= gap) return;
    }
  }
  for (let v = 0; v < 3; v++) {
    point[3 * slot + v] = one[v]!;
    normal[3 * slot + v] = one[3 + v]!;
  }
  target.gap[slot] = gap;
  target.surfaceUp[slot] = up;
  target.kept[slot] = kept;
  target.surfel[slot] = surfel;
}
