import type { Quaternion } from 'three';
import type { Capsule } from './Capsule.js';
import { directionTexel } from '../cube/texelDirections.js';
import { isKnownFree } from './knownFree.js';
import { STRIDE, Surfels } from './Surfels.js';
import type { SurfaceField } from './SurfaceField.js';

/** Fields kept: what the newest cannot see any more, an older one may have seen. */
const KEPT = 3;
/** Surfels are gathered this much farther than asked for, so that it need not be done anew at every move, metres. */
const SPARE = 0.15;

/** An older field drawn this near to a new one is of no more use, metres. */
const SAME_PLACE = 0.05;

/** The surfels near the body, of one kept field. */
export interface NearSurfels {
  readonly surfels: Surfels;
  /** Their numbers. */
  readonly near: Int32Array;
  nearCount: number;
  /** Version of `surfels` when they were gathered. */
  version: number;
  /** For `findContacts`: distance of each from the body's axis, by its number; Infinity where not looked at. */
  readonly distance: Float32Array;
}

/**
 * The newest field and, while nothing moves, the two before it, as surfels: all that is known of the surroundings.
 */
export class FieldMemory {
  /** Newest first. */
  readonly kept: NearSurfels[] = [];
  /** Grows whenever what is known changes. */
  revision = 0;
  readonly #spare: NearSurfels[] = [];
  #x = NaN;
  #y = NaN;
  #z = NaN;
  #height = 0;
  #reach = 0;

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
    if (slot?.surfels.resolution !== field.resolution) slot = nearSurfels(field.resolution);
    slot.surfels.fill(field, this.toBody);
    // What was seen from here before is seen again.
    for (let k = this.kept.length - 1; k >= 0; k--) {
      if (this.kept[k]!.surfels.center.distanceTo(field.center) > SAME_PLACE) continue;
      this.#spare.push(...this.kept.splice(k, 1));
    }
    this.kept.unshift(slot);
    this.revision++;
    this.#x = NaN;
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
   * Sees to it that `near` holds every surfel within `reach` of the capsule, metres beyond its radius.
   */
  gather(capsule: Capsule, reach: number): void {
    let fresh = reach <= this.#reach && capsule.height <= this.#height;
    if (fresh) {
      const dx = capsule.x - this.#x;
      const dy = capsule.y - this.#y;
      const dz = capsule.z - this.#z;
      const moved = Math.sqrt(dx * dx + dy * dy + dz * dz);
      fresh = moved + reach <= this.#reach + 1e-9;
    }
    for (const each of this.kept) if (each.version !== each.surfels.version) fresh = false;
    if (fresh) return;
    this.#x = capsule.x;
    this.#y = capsule.y;
    this.#z = capsule.z;
    this.#height = capsule.height;
    this.#reach = reach + SPARE;
    for (const each of this.kept) gatherNear(each, capsule, this.#reach);
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
      this.#toWorld(dx, dy, dz);
      if (isKnownFree(s.distance, s.resolution, s.far, way[0]!, way[1]!, way[2]!, margin)) {
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
    this.#toWorld(x - s.origin.x, y - s.origin.y, z - s.origin.z);
    const dx = way[0]!;
    const dy = way[1]!;
    const dz = way[2]!;
    const away = Math.sqrt(dx * dx + dy * dy + dz * dz);
    return away - s.distance[directionTexel(dx, dy, dz, s.resolution)]! > depth;
  }

  /** Turns a vector of the body's frame to world axes, into `way`. */
  #toWorld(x: number, y: number, z: number): void {
    const { w, x: qx, y: qy, z: qz } = this.toBody;
    // By the conjugate.
    const tx = 2 * (-qy * z + qz * y);
    const ty = 2 * (-qz * x + qx * z);
    const tz = 2 * (-qx * y + qy * x);
    way[0] = x + w * tx - (qy * tz - qz * ty);
    way[1] = y + w * ty - (qz * tx - qx * tz);
    way[2] = z + w * tz - (qx * ty - qy * tx);
  }
}

const way = /* @__PURE__ */ new Float64Array(3);

function nearSurfels(resolution: number): NearSurfels {
  const surfels = new Surfels(resolution);
  const count = 6 * resolution * resolution;
  return {
    surfels,
    near: new Int32Array(count),
    nearCount: 0,
    version: -1,
    distance: new Float32Array(count).fill(Infinity),
  };
}

function gatherNear(target: NearSurfels, capsule: Capsule, reach: number): void {
  const { surfels, near } = target;
  const { data, count, extent, origin } = surfels;
  const x = capsule.x - origin.x;
  const z = capsule.z - origin.z;
  const low = capsule.y + capsule.radius - origin.y;
  const high = Math.max(low, capsule.y + capsule.height - capsule.radius - origin.y);
  const reached = capsule.radius + reach;
  let n = 0;
  for (let i = 0, o = 0; i < count; i++, o += STRIDE) {
    const dx = data[o]! - x;
    const dz = data[o + 2]! - z;
    const y = data[o + 1]!;
    const dy = y < low ? low - y : y > high ? y - high : 0;
    const within = reached + extent[i]!;
    if (dx * dx + dy * dy + dz * dz < within * within) near[n++] = i;
  }
  target.nearCount = n;
  target.version = surfels.version;
}
