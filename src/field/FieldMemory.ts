import type { Quaternion } from 'three';
import { directionTexel } from '../cube/texelDirections.js';
import { isKnownFree } from './knownFree.js';
import { axis, PIECE } from './pieces.js';
import { isSeenAgain } from './seenAgain.js';
import { Surfels } from './Surfels.js';
import { own, toWorldAxes, world } from './toWorldAxes.js';
import type { SurfaceField } from './SurfaceField.js';

/** Fields kept: what the newest cannot see any more, an older one may have seen. */
const KEPT = 3;
/** An older field drawn this near to a new one is of no more use, metres. */
const SAME_PLACE = 0.05;
/** How much farther than asked blocks are collected, metres. */
const MARGIN = 0.3;

/** Of a block of a kept field: none of its surfels is its own; else 1 + the number of newer fields that may yet show them. */
export const NONE = 0;
const OWN = 1;

/** One kept field. */
export interface KeptField {
  readonly surfels: Surfels;
  /** By a surfel's number: 1 where a newer field shows it again, so that it is passed over here. */
  readonly again: Uint8Array;
  /** What is known of each block of them, see `NONE`. */
  readonly blocks: Uint8Array;
  /** Numbers of those that `FieldMemory.gather` found near, `nears` of them. */
  readonly near: Uint16Array;
  nears: number;
  /** For `findContacts`: distance of each from the body's axis, by its number; Infinity where not looked at. */
  readonly distance: Float32Array;
}

/**
 * The newest field and, while nothing moves, the two before it, as surfels: all that is known of the surroundings.
 */
export class FieldMemory {
  /** Newest first. */
  readonly kept: KeptField[] = [];
  /** Grows whenever what is known changes. */
  revision = 0;
  readonly #spare: KeptField[] = [];
  /** What `near` was collected for, as `axis`, and the revision then. */
  readonly #gathered = new Float64Array(5);
  #gatheredAt = -1;

  /** @param toBody turns world axes into the body's */
  constructor(readonly toBody: Quaternion) {}

  get newest(): Surfels | null {
    return this.kept.length > 0 ? this.kept[0]!.surfels : null;
  }

  /** Takes a field in, if it is not in yet; returns whether it did. */
  take(field: SurfaceField): boolean {
    if (this.newest?.serial === field.serial && this.newest.time === field.time) return false;
    if (this.newest !== null && this.newest.resolution !== field.resolution) this.forget();
    let slot = this.kept.length < KEPT ? this.#spare.pop() : this.kept.pop();
    if (slot?.surfels.resolution !== field.resolution) slot = keptField(field.resolution);
    slot.surfels.fill(field, this.toBody);
    slot.again.fill(0);
    slot.blocks.fill(OWN);
    // What was seen from here before is seen again.
    for (let k = this.kept.length - 1; k >= 0; k--) {
      if (this.kept[k]!.surfels.center.distanceTo(field.center) > SAME_PLACE) continue;
      this.#spare.push(...this.kept.splice(k, 1));
    }
    // What nothing so far shows again, the newest may.
    for (const { blocks } of this.kept) {
      for (let b = 0; b < blocks.length; b++) {
        // No field has more newer ones than that; counted on, the byte would run over into NONE.
        if (blocks[b] !== NONE && blocks[b]! < OWN + KEPT) blocks[b]!++;
      }
    }
    this.kept.unshift(slot);
    this.revision++;
    return true;
  }

  /** Forgets everything. */
  forget(): void {
    if (this.kept.length > 0) this.revision++;
    this.#spare.push(...this.kept);
    this.kept.length = 0;
  }

  /** Forgets all but the newest: something moved, and they show where it was. */
  forgetOlder(): void {
    if (this.kept.length > 1) this.revision++;
    while (this.kept.length > 1) this.#spare.push(this.kept.pop()!);
  }

  /** Forgets all but the newest of those that were asked for before `clock`: something has changed since. */
  forgetBefore(clock: number): void {
    for (let k = this.kept.length - 1; k > 0; k--) {
      if (this.kept[k]!.surfels.asked > clock) continue;
      this.#spare.push(...this.kept.splice(k, 1));
      this.revision++;
    }
  }

  /**
   * Sees to it that the blocks which may come within `reach` of a segment are among the `near` of each kept field: those
   * within a little more are collected at once, so that a few steps' questions need not look through all.
   *
   * Reads `axis`, which is relative to no field here: body's frame, metres.
   */
  gather(): void {
    const x = axis[0]!;
    const z = axis[1]!;
    const low = axis[2]!;
    const high = axis[3]!;
    const reach = axis[4]!;
    const g = this.#gathered;
    if (this.#gatheredAt === this.revision) {
      const dx = x - g[0]!;
      const dz = z - g[1]!;
      const below = g[2]! - low;
      const above = high - g[3]!;
      const dy = Math.max(0, below, above);
      if (Math.sqrt(dx * dx + dy * dy + dz * dz) + reach <= g[4]!) return;
    }
    this.#gatheredAt = this.revision;
    g[0] = x;
    g[1] = z;
    g[2] = low;
    g[3] = high;
    g[4] = reach + MARGIN;
    for (let k = 0; k < this.kept.length; k++) {
      const field = this.kept[k]!;
      const { blocks, near, surfels } = field;
      const { block, origin } = surfels;
      let n = 0;
      for (let b = 0; b < blocks.length; b++) {
        if (blocks[b] === NONE) continue;
        const p = PIECE * b;
        const dx = block[p]! + origin.x - x;
        const dz = block[p + 2]! + origin.z - z;
        const y = block[p + 1]! + origin.y;
        const dy = y < low ? low - y : y > high ? y - high : 0;
        const within = g[4]! + block[p + 3]!;
        if (dx * dx + dy * dy + dz * dz < within * within) near[n++] = b;
      }
      field.nears = n;
    }
  }

  /**
   * Does block `b` of kept field `k` have surfels that no newer field shows again? Marks the others in `again`; asked
   * once a new field. Only of blocks of interest: most are not.
   */
  hasOwn(k: number, b: number): boolean {
    const { surfels, again, blocks } = this.kept[k]!;
    const unasked = Math.min(k, blocks[b]! - OWN);
    if (unasked > 0) {
      blocks[b] = NONE;
      surfels.find(b);
      for (let i = surfels.first[b]!; i < surfels.first[b + 1]!; i++) {
        if (again[i] === 1) continue;
        if (this.#isSeenAgain(k, i, unasked)) again[i] = 1;
        else blocks[b] = OWN;
      }
    }
    return blocks[b] !== NONE;
  }

  /** @param newest how many of the newer fields to ask */
  #isSeenAgain(k: number, i: number, newest: number): boolean {
    const { surfels } = this.kept[k]!;
    for (let newer = 0; newer < newest; newer++) {
      if (isSeenAgain(this.kept[newer]!.surfels, surfels, i, this.toBody)) return true;
    }
    return false;
  }

  /**
   * Has any kept field seen the place to be free, with everything within `reach` of it in its view?
   *
   * @param x @param y @param z body's frame, metres
   */
  isKnownFree(x: number, y: number, z: number, margin: number, reach: number): boolean {
    for (let k = 0; k < this.kept.length; k++) {
      const s = this.kept[k]!.surfels;
      const dx = x - s.origin.x;
      const dy = y - s.origin.y;
      const dz = z - s.origin.z;
      const room = s.far - reach;
      if (!(room > 0) || dx * dx + dy * dy + dz * dz > room * room) continue;
      own[0] = dx;
      own[1] = dy;
      own[2] = dz;
      toWorldAxes(this.toBody);
      if (isKnownFree(s.distance, s.resolution, s.far, world[0]!, world[1]!, world[2]!, margin)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Does the place lie in the shadow of something, more than `depth` behind it as the newest field sees it, so that no
   * kept field can tell what is there?
   *
   * @param x @param y @param z body's frame, metres
   */
  isHidden(x: number, y: number, z: number, depth: number): boolean {
    if (this.kept.length === 0 || this.isKnownFree(x, y, z, 0, 0)) return false;
    const s = this.kept[0]!.surfels;
    own[0] = x - s.origin.x;
    own[1] = y - s.origin.y;
    own[2] = z - s.origin.z;
    toWorldAxes(this.toBody);
    const dx = world[0]!;
    const dy = world[1]!;
    const dz = world[2]!;
    const away = Math.sqrt(dx * dx + dy * dy + dz * dz);
    return away - s.distance[directionTexel(dx, dy, dz, s.resolution)]! > depth;
  }
}

function keptField(resolution: number): KeptField {
  const surfels = new Surfels(resolution);
  const count = 6 * resolution * resolution;
  return {
    surfels,
    again: new Uint8Array(count),
    blocks: new Uint8Array(surfels.first.length - 1),
    near: new Uint16Array(surfels.first.length - 1),
    nears: 0,
    distance: new Float32Array(count).fill(Infinity),
  };
}
