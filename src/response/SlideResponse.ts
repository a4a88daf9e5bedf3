import type { Capsule } from '../field/Capsule.js';
import { ContactSet } from '../field/ContactSet.js';
import type { FieldMemory } from '../field/FieldMemory.js';
import { findContacts } from '../field/findContacts.js';
import { hasTread } from '../field/hasTread.js';
import { timeOfImpact } from '../field/timeOfImpact.js';
import { Planes, type Solution, solvePlanes } from './solvePlanes.js';

/** What a body may climb and how near it comes. Lengths in metres, angles as cosines. */
export interface SlideLimits {
  /** Gap kept to every surface. */
  skin: number;
  /** Cosine of the steepest slope that carries. */
  slope: number;
  /** Highest step that is climbed. */
  stepHeight: number;
}

/** Longest way made on one look, as a part of the radius: planes stand for what is round only near by. */
const STRIDE_RATIO = 0.25;
/** Looks a call at most; what is left of the way then is dropped. */
const MOST_LOOKS = 40;
/** A way shorter than this is none, metres. */
const NOTHING = 1e-6;
/** What is touched, and what a support is taken for, beyond the skin, metres. */
export const TOUCH = 0.005;
/** A gap this little short of the skin is the skin, metres. */
const CLOSE = 1e-4;
/** A way along a wall shorter than this part of the wish is not made: pressing on, one stands. */
const LEAST_SLIDE = 0.06;
/**
 * What gives way to a walker by less than this to the side, once it follows the ground (a part of its normal), holds it
 * up: aside it would have to go far for what is but a little too near, or into the wall there.
 */
const HOLDS_UP = 0.5;
/** A wall that faces the way by less than this, a cosine, is beside it. */
const BESIDE = 0.5;
/** What a wall's normal rises by at most, or falls. */
const UPRIGHT = 0.1;
/** Radius of what feels for ground below an edge, as a part of the body's: texels hidden behind the edge leave gaps. */
const FEELER_RATIO = 0.4;
/** Parts of the axis that must be known-free: no farther apart than this, metres. */
const AXIS_STEP = 0.3;
/** A place is known-free if it is nearer than what was seen by this part of the radius. */
const FREE_RATIO = 0.25;
/** Halvings in search of the border of the known. */
const HALVINGS = 6;
/** How much steeper than the limit a surface's own normal may be, as a cosine: rounding of 8-bit normals. */
const SURFACE_SLACK = 0.006;
/** How far above `stepHeight` an edge may be found, metres: what a field of points rounds. */
const STEP_SLACK = 0.004;

/**
 * Moves a capsule among surfels: contacts ahead become planes, the way is solved against them, made as far as nothing
 * else is met, and what overlaps is pushed out (the way of Jolt's `CharacterVirtual`; depth maps have no inner edges to
 * trip on).
 *
 * Walking and flying differ. A walker's way is horizontal: what carries lifts it, everything else is a wall, however it
 * leans, so that slopes change neither its speed nor its direction; what blocks it is stepped onto if it is low enough.
 * A flyer's way is solved in all three dimensions.
 *
 * All in the body's frame, Y up, metres. Allocates nothing. It keeps what it found around its body: each character needs
 * its own.
 */
export class SlideResponse {
  /** Tells it from a response over the paper's maxima, of another copy of the package too. */
  readonly isSlideResponse = true;
  /** Contacts around where the body ended, within the skin and a little more. */
  readonly contacts = new ContactSet();
  /** How far two opposing surfaces fell short of leaving room for the body and its skin, metres; 0 if all is well. */
  slack = 0;
  /** Whether the way was cut where no field has looked yet. */
  waited = false;
  /** Height climbed by steps in the last call, metres. */
  climbed = 0;

  readonly #ahead = new ContactSet();
  /** What `#ahead` was last filled for. */
  readonly #seen = {
    memory: null as FieldMemory | null,
    revision: 0,
    x: 0,
    y: 0,
    z: 0,
    height: 0,
    radius: 0,
    reach: -Infinity,
  };
  /** Farthest look of this call, beyond the skin, metres. */
  #reach = TOUCH;
  readonly #planes = new Planes();
  readonly #d: Solution = { x: 0, y: 0, z: 0 };
  readonly #way: Solution = { x: 0, y: 0, z: 0 };
  readonly #feeler: Capsule = { x: 0, y: 0, z: 0, radius: 0, height: 0 };
  readonly #from = { x: 0, y: 0, z: 0 };

  /** Does contact `i` of `set` carry: is it, and the surface it belongs to, no steeper than the limit? */
  carries(set: ContactSet, i: number, limits: SlideLimits): boolean {
    return (
      set.normal[3 * i + 1]! >= limits.slope && set.surfaceUp[i]! >= limits.slope - SURFACE_SLACK
    );
  }

  /** Fills `contacts` around the body, within the skin and a little more. */
  look(memory: FieldMemory, body: Capsule, limits: SlideLimits): ContactSet {
    // As far as the next step will want to see, which begins here.
    const { contacts } = this;
    const set = this.#see(memory, body, limits.skin + this.#reach);
    contacts.count = 0;
    for (let i = 0; i < set.count; i++) {
      if (set.gap[i]! < limits.skin + TOUCH) contacts.take(set, i);
    }
    return contacts;
  }

  /** Fills `#ahead` around the body within `reach`, or farther, if it is not filled so already. */
  #see(memory: FieldMemory, body: Capsule, reach: number): ContactSet {
    const seen = this.#seen;
    const same =
      seen.memory === memory &&
      seen.revision === memory.revision &&
      seen.x === body.x &&
      seen.y === body.y &&
      seen.z === body.z &&
      seen.height === body.height &&
      seen.radius === body.radius;
    if (same && reach <= seen.reach) return this.#ahead;
    this.#find(memory, body, reach);
    seen.memory = memory;
    seen.revision = memory.revision;
    seen.x = body.x;
    seen.y = body.y;
    seen.z = body.z;
    seen.height = body.height;
    seen.radius = body.radius;
    seen.reach = reach;
    return this.#ahead;
  }

  /** Fills `#ahead` around the body within `reach`. */
  #find(memory: FieldMemory, body: Capsule, reach: number): ContactSet {
    this.#seen.reach = -Infinity;
    return findContacts(memory, body, reach, this.#ahead);
  }

  /** Moves `body` through the air by x, y, z: slides along what it meets. */
  fly(
    memory: FieldMemory,
    body: Capsule,
    x: number,
    y: number,
    z: number,
    limits: SlideLimits,
  ): void {
    this.#begin();
    const longest = STRIDE_RATIO * body.radius;
    for (let look = 0; look < MOST_LOOKS; look++) {
      const length = Math.sqrt(x * x + y * y + z * z);
      const part = length > longest ? longest / length : 1;
      const d = this.#d;
      d.x = part * x;
      d.y = part * y;
      d.z = part * z;
      this.#planesAhead(memory, body, part * length, limits);
      this.slack = Math.max(this.slack, solvePlanes(this.#planes, d));
      const made = this.#advance(memory, body, limits);
      x -= made * part * x;
      y -= made * part * y;
      z -= made * part * z;
      if (this.waited || made === 0 || x * x + y * y + z * z < NOTHING * NOTHING) break;
    }
    this.look(memory, body, limits);
  }

  /**
   * Moves `body` over the ground by x, z, following it up and down as far as it carries.
   */
  walk(memory: FieldMemory, body: Capsule, x: number, z: number, limits: SlideLimits): void {
    this.#begin();
    const longest = STRIDE_RATIO * body.radius;
    for (let look = 0; look < MOST_LOOKS; look++) {
      const length = Math.sqrt(x * x + z * z);
      const part = length > longest ? longest / length : 1;
      const dx = part * x;
      const dz = part * z;
      this.#from.x = body.x;
      this.#from.y = body.y;
      this.#from.z = body.z;
      this.#solveWalk(memory, body, dx, dz, part * length, limits);
      let made = this.#advance(memory, body, limits);
      // Blocked: is it a step?
      const along = (body.x - this.#from.x) * dx + (body.z - this.#from.z) * dz;
      const whole = dx * dx + dz * dz;
      if (!this.waited && along < 0.98 * whole && this.#step(memory, body, dx, dz, along, limits)) {
        made = 1;
      }
      x -= made * dx;
      z -= made * dz;
      const mx = body.x - this.#from.x;
      const mz = body.z - this.#from.z;
      // Pressed against something the rest of the way would come to nothing too.
      const stuck = mx * mx + mz * mz < LEAST_SLIDE * LEAST_SLIDE * whole;
      if (this.waited || stuck || x * x + z * z < NOTHING * NOTHING) break;
    }
    this.look(memory, body, limits);
  }

  /**
   * Lowers `body` onto what carries it, at most `depth`.
   *
   * @param onward whether it is under way: then an edge that it is rolling off will do, with ground under its middle
   * @returns whether it found something that carries; if not, `body` is where it was
   */
  snap(
    memory: FieldMemory,
    body: Capsule,
    depth: number,
    limits: SlideLimits,
    onward: boolean,
  ): boolean {
    const { skin } = limits;
    const part = timeOfImpact(memory, body, this.#put(0, -depth, 0), skin - CLOSE);
    if (part === 1) return false;
    const { y } = body;
    body.y -= part * depth;
    const carried =
      this.#supported(memory, body, limits) ||
      (onward && this.isOnStair(memory, body, depth, limits));
    if (carried && this.isKnown(memory, body)) return true;
    body.y = y;
    this.look(memory, body, limits);
    return false;
  }

  /** Is there room for the body as it is, to half its skin? */
  fits(memory: FieldMemory, body: Capsule, limits: SlideLimits): boolean {
    const set = this.#find(memory, body, limits.skin);
    for (let i = 0; i < set.count; i++) if (set.gap[i]! < 0.5 * limits.skin) return false;
    return this.isKnown(memory, body);
  }

  #begin(): void {
    this.slack = 0;
    this.waited = false;
    this.climbed = 0;
    this.#reach = TOUCH;
  }

  /** How far beyond the skin to look before a way of so much: a little more than needed, for it may vary. */
  #reachOf(travel: number): number {
    const reach = travel + TOUCH;
    if (reach > this.#reach) this.#reach = (1 + 1e-6) * reach;
    return reach;
  }

  #supported(memory: FieldMemory, body: Capsule, limits: SlideLimits): boolean {
    const set = this.look(memory, body, limits);
    for (let i = 0; i < set.count; i++) if (this.carries(set, i, limits)) return true;
    return false;
  }

  /** A way to look along. */
  #put(x: number, y: number, z: number): Solution {
    const way = this.#way;
    way.x = x;
    way.y = y;
    way.z = z;
    return way;
  }

  /**
   * Does it touch, as of the last look, the edge of something flat enough from the side, with ground under its middle no
   * more than `depth` below?
   */
  isOnStair(memory: FieldMemory, body: Capsule, depth: number, limits: SlideLimits): boolean {
    const { contacts: set } = this;
    for (let i = 0; i < set.count; i++) {
      if (set.gap[i]! > limits.skin + TOUCH) continue;
      if (set.normal[3 * i + 1]! < 0.1 || set.surfaceUp[i]! < limits.slope) continue;
      return this.#groundBelow(memory, body, depth);
    }
    return false;
  }

  /** Is there anything within `depth` straight below the foot? */
  #groundBelow(memory: FieldMemory, body: Capsule, depth: number): boolean {
    const feeler = this.#feeler;
    feeler.radius = FEELER_RATIO * body.radius;
    feeler.height = 2 * feeler.radius;
    feeler.x = body.x;
    feeler.y = body.y + body.radius - feeler.radius;
    feeler.z = body.z;
    return timeOfImpact(memory, feeler, this.#put(0, -(body.radius + depth), 0), 0) < 1;
  }

  /** Every contact that `travel` may bring nearer than the skin, as a plane. */
  #planesAhead(memory: FieldMemory, body: Capsule, travel: number, limits: SlideLimits): void {
    const { skin } = limits;
    const set = this.#see(memory, body, skin + this.#reachOf(travel));
    const { normal } = set;
    this.#planes.clear();
    for (let i = 0; i < set.count; i++) {
      const bound = skin - set.gap[i]!;
      this.#planes.add(normal[3 * i]!, normal[3 * i + 1]!, normal[3 * i + 2]!, bound);
    }
  }

  /**
   * A walker's way, into `#d`. What carries is a function of where one stands, the lowest height it allows; put into the
   * planes of everything else, it leaves a problem in x and z alone.
   */
  #solveWalk(
    memory: FieldMemory,
    body: Capsule,
    dx: number,
    dz: number,
    travel: number,
    limits: SlideLimits,
  ): void {
    const { skin } = limits;
    // A slope at the limit falls by more than the way made.
    const set = this.#see(memory, body, skin + this.#reachOf(2 * travel));
    const { normal, gap, count } = set;
    const d = this.#d;
    d.x = dx;
    d.y = 0;
    d.z = dz;
    // Two rounds: the solution may stand on another support than the wish.
    for (let round = 0; round < 2; round++) {
      const ground = this.#highestSupport(d.x, d.z, limits);
      // dy = rise - (slopeX · dx + slopeZ · dz)
      let slopeX = 0;
      let slopeZ = 0;
      let rise = 0;
      if (ground >= 0) {
        const up = normal[3 * ground + 1]!;
        slopeX = normal[3 * ground]! / up;
        slopeZ = normal[3 * ground + 2]! / up;
        rise = (skin - gap[ground]!) / up;
        this.#way.x = slopeX;
        this.#way.z = slopeZ;
        const hold = this.#highestHold(limits);
        if (hold >= 0) rise = Math.max(rise, (skin - gap[hold]!) / normal[3 * hold + 1]!);
      }
      this.#planes.clear();
      for (let i = 0; i < count; i++) {
        if (this.carries(set, i, limits)) continue;
        const ny = normal[3 * i + 1]!;
        const nx = normal[3 * i]! - ny * slopeX;
        const nz = normal[3 * i + 2]! - ny * slopeZ;
        const bound = skin - gap[i]! - ny * rise;
        const length = Math.sqrt(nx * nx + nz * nz);
        if (length < 0.05) {
          // Straight above it is no wall, but leaves less room than the body needs.
          this.slack = Math.max(this.slack, bound / 2);
          continue;
        }
        const { next } = this.#planes;
        next[0] = nx / length;
        next[1] = 0;
        next[2] = nz / length;
        next[3] = bound / length;
        this.#planes.addNext();
      }
      d.x = dx;
      d.y = 0;
      d.z = dz;
      this.slack = Math.max(this.slack, solvePlanes(this.#planes, d));
      if (d.x * d.x + d.z * d.z < LEAST_SLIDE * LEAST_SLIDE * travel * travel) this.#stand(d);
      d.y = ground >= 0 ? rise - slopeX * d.x - slopeZ * d.z : 0;
      if (ground === this.#highestSupport(d.x, d.z, limits)) break;
    }
  }

  /**
   * The contact of `#ahead` that holds the body up highest, where it is and on ground that slopes like `#way`, among those
   * that do not carry but lean too much like the ground to be walls; -1 without any.
   */
  #highestHold(limits: SlideLimits): number {
    const { normal, gap, count } = this.#ahead;
    const { x: slopeX, z: slopeZ } = this.#way;
    let best = -1;
    let highest = -Infinity;
    for (let i = 0; i < count; i++) {
      const ny = normal[3 * i + 1]!;
      if (ny < HOLDS_UP || this.carries(this.#ahead, i, limits)) continue;
      const nx = normal[3 * i]! - ny * slopeX;
      const nz = normal[3 * i + 2]! - ny * slopeZ;
      const y = (limits.skin - gap[i]!) / ny;
      if (nx * nx + nz * nz > HOLDS_UP * HOLDS_UP || y <= highest) continue;
      highest = y;
      best = i;
    }
    return best;
  }

  /** Leaves of a slide only what pushes out of walls. */
  #stand(d: { x: number; y: number; z: number }): void {
    d.x = d.z = 0;
    solvePlanes(this.#planes, d);
  }

  /** The contact of `#ahead` that lifts the body highest at x, z from here, among those that carry; -1 without any. */
  #highestSupport(x: number, z: number, limits: SlideLimits): number {
    const { normal, gap, count } = this.#ahead;
    let best = -1;
    let highest = -Infinity;
    for (let i = 0; i < count; i++) {
      if (!this.carries(this.#ahead, i, limits)) continue;
      const y =
        (limits.skin - gap[i]! - normal[3 * i]! * x - normal[3 * i + 2]! * z) / normal[3 * i + 1]!;
      if (y <= highest) continue;
      highest = y;
      best = i;
    }
    return best;
  }

  /**
   * Makes as much of `#d` as meets nothing nearer than half the skin and stays in what is known.
   *
   * @returns that part, 0 to 1
   */
  #advance(memory: FieldMemory, body: Capsule, limits: SlideLimits): number {
    const { x, y, z } = this.#d;
    // What is within the skin already is among the planes.
    let part = timeOfImpact(memory, body, this.#d, 0.5 * limits.skin, limits.skin - CLOSE);
    const fx = body.x;
    const fy = body.y;
    const fz = body.z;
    put(body, fx, fy, fz, x, y, z, part);
    if (this.isKnown(memory, body)) return part;
    this.waited = true;
    let low = 0;
    for (let i = 0; i < HALVINGS; i++) {
      const middle = (low + part) / 2;
      put(body, fx, fy, fz, x, y, z, middle);
      if (this.isKnown(memory, body)) low = middle;
      else part = middle;
    }
    put(body, fx, fy, fz, x, y, z, low);
    return low;
  }

  /** Does the body's axis lie in what the fields saw as free, all around it in their view? */
  isKnown(memory: FieldMemory, body: Capsule): boolean {
    const { x, y, z, radius, height } = body;
    const length = height - 2 * radius;
    const pieces = Math.max(1, Math.ceil(length / AXIS_STEP));
    for (let i = 0; i <= pieces; i++) {
      const level = y + radius + (length * i) / pieces;
      if (!memory.isKnownFree(x, level, z, FREE_RATIO * radius, radius)) return false;
    }
    return true;
  }

  /**
   * Tries to get farther than `#from` and `along` by going up, on and down again, onto what carries.
   *
   * @param along what was made without, as a dot product with dx, dz
   * @returns whether the body now stands on a step; if not, it is where it was
   */
  #step(
    memory: FieldMemory,
    body: Capsule,
    dx: number,
    dz: number,
    along: number,
    limits: SlideLimits,
  ): boolean {
    const { skin, stepHeight } = limits;
    if (stepHeight === 0) return false;
    const way = Math.sqrt(dx * dx + dz * dz) + skin;
    const steepest = limits.slope - SURFACE_SLACK;
    // The floor it stands on is no step.
    if (!hasTread(memory, body, -0.5 * skin, stepHeight, way, steepest)) return false;
    const slidX = body.x;
    const slidY = body.y;
    const slidZ = body.z;
    const { x, y, z } = this.#from;
    body.x = x;
    body.y = y;
    body.z = z;
    const lift = stepHeight + skin;
    const up = lift * timeOfImpact(memory, body, this.#put(0, lift, 0), 0.99 * skin);
    if (
      up > NOTHING &&
      (this.#stepOn(memory, body, dx, dz, up, true, along, limits) ||
        this.#stepOn(memory, body, dx, dz, up, false, along, limits))
    ) {
      this.climbed += body.y - y;
      return true;
    }
    body.x = slidX;
    body.y = slidY;
    body.z = slidZ;
    return false;
  }

  /**
   * From `#from` up, on and down again.
   *
   * @param straight whether as far as it can straight on, or all of it along what stands beside the foot: a wall that ends
   *   below the lifted body would let that come nearer, and not down
   * @returns whether it stands there, higher and farther than before; if not, `body` is anywhere
   */
  #stepOn(
    memory: FieldMemory,
    body: Capsule,
    dx: number,
    dz: number,
    up: number,
    straight: boolean,
    along: number,
    limits: SlideLimits,
  ): boolean {
    const { skin } = limits;
    const { x, y, z } = this.#from;
    body.x = x;
    body.y = y + up;
    body.z = z;
    const on = straight ? timeOfImpact(memory, body, this.#put(dx, 0, dz), 0.99 * skin) : 0;
    body.x += on * dx;
    body.z += on * dz;
    let farther = on * (dx * dx + dz * dz);
    if (on < 1) {
      // Up a stair along its wall: the rest of the way beside that.
      const slid = this.#slide(memory, body, (1 - on) * dx, (1 - on) * dz, y, limits);
      // Nothing beside: that was tried.
      if (!straight && slid.x === dx && slid.z === dz) return false;
      const part = timeOfImpact(memory, body, slid, 0.5 * skin, skin - CLOSE);
      body.x += part * slid.x;
      body.z += part * slid.z;
      farther += part * (slid.x * dx + slid.z * dz);
    }
    if (farther <= along + NOTHING * NOTHING || !this.isKnown(memory, body)) return false;
    // Not quite to the skin: of walls that it touches, rounding would make floors.
    const gap = skin - CLOSE;
    body.y -= up * timeOfImpact(memory, body, this.#put(0, -up, 0), gap, gap, null, 0.5 * skin);
    // Down on what it came from, nothing was climbed.
    return body.y > y + NOTHING && this.#stands(memory, body, y - skin, limits);
  }

  /**
   * What of a level way is left where it leads into walls.
   *
   * @param floor where the foot comes from: walls beside that may end below where the body is now
   * @returns `#way`
   */
  #slide(
    memory: FieldMemory,
    body: Capsule,
    x: number,
    z: number,
    floor: number,
    limits: SlideLimits,
  ): Solution {
    const reach = limits.skin + Math.sqrt(x * x + z * z) + TOUCH;
    const { y } = body;
    this.#planes.clear();
    this.#addWalls(this.#find(memory, body, reach), x, z, -Infinity, limits);
    body.y = floor;
    this.#addWalls(this.#find(memory, body, reach), x, z, -BESIDE, limits);
    body.y = y;
    const way = this.#put(x, 0, z);
    solvePlanes(this.#planes, way);
    way.y = 0;
    return way;
  }

  /** Adds what stands in a level way as upright planes, but those that face it by more than `facing`, a cosine. */
  #addWalls(set: ContactSet, x: number, z: number, facing: number, limits: SlideLimits): void {
    const { normal } = set;
    const least = facing * Math.sqrt(x * x + z * z);
    for (let i = 0; i < set.count; i++) {
      const nx = normal[3 * i]!;
      const nz = normal[3 * i + 2]!;
      const length = Math.sqrt(nx * nx + nz * nz);
      // Floors and ceilings are in nobody's way.
      if (length < 0.05 || nx * x + nz * z < least * length) continue;
      this.#planes.add(nx / length, 0, nz / length, (limits.skin - set.gap[i]!) / length);
    }
  }

  /** Does the body stand on a surface flat enough, no more than a step above `floor`, with room around it? */
  #stands(memory: FieldMemory, body: Capsule, floor: number, limits: SlideLimits): boolean {
    const set = this.#find(memory, body, limits.skin + TOUCH);
    let stands = false;
    for (let i = 0; i < set.count; i++) {
      const up = set.normal[3 * i + 1]!;
      const upright = up < UPRIGHT && up > -UPRIGHT;
      // Walls may still push it out.
      if (set.gap[i]! < (upright ? 0.5 : 0.98) * limits.skin) return false;
      if (up < 0.01 || set.surfaceUp[i]! < limits.slope - SURFACE_SLACK) continue;
      if (set.point[3 * i + 1]! <= floor + limits.stepHeight + STEP_SLACK) stands = true;
      else if (!upright) return false;
    }
    return stands && this.isKnown(memory, body);
  }
}

function put(
  body: Capsule,
  fx: number,
  fy: number,
  fz: number,
  x: number,
  y: number,
  z: number,
  part: number,
): void {
  body.x = fx + part * x;
  body.y = fy + part * y;
  body.z = fz + part * z;
}
