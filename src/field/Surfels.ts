import { Matrix4, type Object3D, Quaternion, Vector3 } from 'three';
import { blocksOf, EDGE } from './blocks.js';
import { boundQuads, LONGEST, middle } from './boundQuads.js';
import { setCorners } from './corners.js';
import { APART, COPLANAR_LINK, type Extents, findExtents } from './extents.js';
import { beyond, FlatBlocks, SAME_NORMAL, SAME_PLANE } from './FlatBlocks.js';
import { isSeam } from './isSeam.js';
import { STRIDE } from './layout.js';
import { neighbours, SIDES } from './neighbours.js';
import { AWAY, boundBlock, ENDS, GOES_ON, MIXED, PIECE } from './pieces.js';
import type { SurfaceField } from './SurfaceField.js';
import type { Texels } from './Texels.js';
import { own, toWorldAxes, world } from './toWorldAxes.js';

/**
 * A surface seen at a slant less than this (cosine between ray and normal) is told from so far aside that its texel's
 * point may be centimetres off: it is left to a later, nearer look.
 */
const LEAST_SLANT = 0.06;
/** What of a surfel moves with its object. */
const MOVING = 12;
/** How far a texel's piece goes beside its ray at most, in texels along each axis of the face: that may pass half a one
 * beside the middle, and a neighbour's ray as much. */
const ASIDE = 2;
/** What is known of a block: a ball around what its rays leave open; a smaller one; where its pieces end; all. */
const ROUGH = 0;
const AIMED = 1;
const ENDED = 2;
const MADE = 3;

/** What `Surfels.planeOf` found: a unit normal and a point, 3 each, body's frame, relative to `Surfels.origin`. */
export const plane = /* @__PURE__ */ new Float64Array(6);

/**
 * The surfels of one field: for each texel that saw something a piece of plane, as far as it is sure to reach.
 *
 * A surfel is a point with a plane and the corners of a piece of it, trimmed against its neighbours (see `findExtents`):
 * flat is exactly flat, an edge is where the planes meet, and next to nothing grows past a silhouette.
 *
 * Numbers are relative to the field's centre and turned into the body's frame, whose Y is the character's up. A moved
 * object's surfels are carried along by its matrix (`carry`).
 *
 * Of a field most is never asked for: surfels are made block by block, for who comes near one. Until then a block knows
 * but how far it reaches at most, which it is cheaper to be told more exactly than to make it: who asks whether one is of
 * interest asks again after each `refine`.
 */
export class Surfels {
  /** How many there are. */
  count = 0;
  /** `STRIDE` numbers each, metres, body's frame, relative to `origin`. */
  readonly data: Float32Array;
  /**
   * What tells surfels apart without a closer look, see `PIECE`: the extent is that of the farthest corner, and the plane
   * goes on where all four sides do.
   */
  readonly piece: Float32Array;
  /** The same of blocks of surfels, which are numbered block by block. */
  readonly block: Float32Array;
  /** Number of each block's first surfel, and behind the last block's last. */
  readonly first: Int32Array;
  /** Each surfel's block. */
  readonly blockOf: Uint16Array;
  /** For each of `SIDES` sides the number of the surfel that goes on there, or -1. */
  readonly link: Int32Array;
  /** As in the field: 1 + place in `objects`, or 0. */
  readonly object: Uint16Array;
  readonly instance: Uint32Array;
  /** The field's centre, body's frame. */
  readonly origin = new Vector3();
  /** The field's centre, world space. */
  readonly center = new Vector3();
  /** The field's distances, texel by texel, for `isKnownFree`. */
  readonly distance: Float32Array;
  /** Surfel of each texel, or -1. */
  readonly ofTexel: Int32Array;
  far = 0;
  time = 0;
  serial = -1;
  /** When it was asked for, by the character's clock, seconds. */
  asked = -Infinity;
  readonly objects: Object3D[] = [];
  /** World matrix of each object as its surfels now lie. */
  readonly poses: Matrix4[] = [];
  /** 1 for each object that has moved since it was drawn; its place is its number in `object`. */
  readonly moved: Uint8Array = new Uint8Array(65536);

  /** Surfels as drawn, of objects that have moved since. */
  readonly #drawn: Float32Array;
  readonly #drawnPoses: Matrix4[] = [];
  readonly #extents: Extents;
  /** The field's, kept for blocks that are found later. */
  readonly #texels: Texels;
  /** How much is known of each block, see `ROUGH`. */
  readonly #known: Uint8Array;
  readonly #flat: FlatBlocks;
  readonly #toBody = new Quaternion();
  /** The character's, world axes. */
  readonly #up = new Vector3();

  constructor(readonly resolution: number) {
    const count = 6 * resolution * resolution;
    this.data = new Float32Array(STRIDE * count);
    this.#drawn = new Float32Array(MOVING * count);
    this.piece = new Float32Array(PIECE * count);
    const blocks = blocksOf(resolution);
    this.block = new Float32Array(PIECE * blocks.count);
    this.first = new Int32Array(blocks.count + 1);
    this.#known = new Uint8Array(blocks.count);
    this.blockOf = new Uint16Array(count);
    this.link = new Int32Array(SIDES * count);
    this.object = new Uint16Array(count);
    this.instance = new Uint32Array(count);
    this.distance = new Float32Array(count);
    this.ofTexel = new Int32Array(count);
    this.#flat = new FlatBlocks(resolution, this.block, this.ofTexel);
    this.#extents = {
      reach: new Float32Array(SIDES * count),
      link: new Uint8Array(SIDES * count),
    };
    this.#texels = {
      resolution,
      direction: new Float32Array(3 * count),
      distance: this.distance,
      normal: new Float32Array(3 * count),
      front: new Uint8Array(count),
    };
  }

  /**
   * Takes a field's texels over; the field may be overwritten afterwards.
   *
   * @param toBody turns world axes into the body's
   */
  fill(field: SurfaceField, toBody: Quaternion): this {
    const { direction, normal } = this.#texels;
    this.distance.set(field.distance);
    direction.set(field.direction);
    normal.set(field.normal);
    this.#texels.front.set(field.front);
    this.center.copy(field.center);
    this.origin.copy(field.center).applyQuaternion(toBody);
    this.far = field.far;
    this.time = field.time;
    this.serial = field.serial;
    this.moved.fill(0, 0, this.objects.length + 1);
    this.moved.fill(0, 0, field.objects.length + 1);
    this.objects.length = 0;
    for (let i = 0; i < field.objects.length; i++) {
      this.objects.push(field.objects[i]!);
      (this.poses[i] ??= new Matrix4()).copy(field.matrices[i]!);
      (this.#drawnPoses[i] ??= new Matrix4()).copy(field.matrices[i]!);
    }

    this.#toBody.copy(toBody);
    this.#up.set(0, 1, 0).applyQuaternion(toWorld.copy(toBody).conjugate());
    this.#known.fill(ROUGH);
    this.#number(field);
    return this;
  }

  /**
   * Gets to know block `b` better, at last by making its surfels: to be called before anything of them is looked at, as
   * long as the block may be of interest. Allocates nothing.
   *
   * @returns whether it may now reach less far than it was said to; false if its surfels were made already
   */
  refine(b: number): boolean {
    const known = this.#known[b]!;
    if (known === MADE) return false;
    const kind = this.block[PIECE * b + 7]!;
    if (known === ENDED || kind === GOES_ON) {
      this.find(b);
    } else if (known === ROUGH && kind === MIXED) {
      this.#known[b] = AIMED;
      this.#boundQuads(b, null);
    } else {
      this.#end(b);
    }
    return true;
  }

  /** The plane of surfel `i`, which `texel` saw: writes `plane`. */
  planeOf(texel: number, i: number): void {
    if (this.moved[this.object[i]!] === 1) {
      for (let v = 0; v < 3; v++) {
        plane[v] = this.piece[PIECE * i + 4 + v]!;
        plane[3 + v] = this.piece[PIECE * i + v]!;
      }
      return;
    }
    const { direction, distance, normal } = this.#texels;
    const d = distance[texel]!;
    for (let v = 0; v < 3; v++) {
      plane[v] = normal[3 * texel + v]!;
      plane[3 + v] = d * direction[3 * texel + v]!;
    }
    if (this.#toBody.w === 1) return;
    rotate(plane, 0, this.#toBody);
    rotate(plane, 3, this.#toBody);
  }

  /** Does the plane of surfel `i`, which `texel` saw, go on all around it? */
  goesOn(texel: number, i: number): boolean {
    const b = this.blockOf[i]!;
    if (this.block[PIECE * b + 7] === GOES_ON) return true;
    if (this.#known[b] === MADE) return this.piece[PIECE * i + 7] === GOES_ON;
    if (this.#known[b]! < ENDED) this.#end(b);
    const { link } = this.#extents;
    for (let s = SIDES * texel; s < SIDES * (texel + 1); s++) {
      if (link[s] !== COPLANAR_LINK) return false;
    }
    return true;
  }

  /** Makes the surfels of block `b`, if they are not made yet. Allocates nothing. */
  find(b: number): void {
    if (this.#known[b] === MADE) return;
    const midst = this.block[PIECE * b + 7] === GOES_ON;
    if (this.#known[b] !== ENDED) this.#findEnds(b);
    this.#known[b] = MADE;
    const { resolution, data, distance, link, ofTexel, piece } = this;
    const { texels, first } = blocksOf(resolution);
    const table = neighbours(resolution);
    const end = first[b + 1]!;
    const turn = this.#toBody.w !== 1;
    const { direction, normal } = this.#texels;
    for (let a = first[b]!; a < end; a++) {
      const texel = texels[a]!;
      const i = ofTexel[texel]!;
      if (i < 0) continue;
      const k = 3 * texel;
      const d = distance[texel]!;
      const o = STRIDE * i;
      for (let v = 0; v < 3; v++) {
        data[o + v] = direction[k + v]! * d;
        data[o + 3 + v] = normal[k + v]!;
      }
      tangents(data, o);
      setCorners(data, o, this.#texels, texel, table, this.#extents, midst, piece, PIECE * i + 3);
      if (turn) for (let v = 0; v < MOVING; v += 3) rotate(data, o + v, this.#toBody);
      let kind = GOES_ON;
      for (let side = 0; side < SIDES; side++) {
        const goes = this.#extents.link[SIDES * texel + side]!;
        link[SIDES * i + side] = goes === APART ? -1 : ofTexel[table[SIDES * texel + side]!]!;
        if (goes !== COPLANAR_LINK) kind = ENDS;
      }
      piece[PIECE * i + 7] = kind;
      this.#setPiece(i);
    }
    const extent = this.block[PIECE * b + 3]!;
    this.#bound(b);
    if (extent < this.block[PIECE * b + 3]!) this.block[PIECE * b + 3] = extent;
  }

  #end(b: number): void {
    this.#known[b] = ENDED;
    this.#findEnds(b);
    this.#boundQuads(b, this.#extents.reach);
  }

  /** Finds how far the pieces of block `b` go, and how they go on. */
  #findEnds(b: number): void {
    const { resolution, distance } = this;
    const { texels, first } = blocksOf(resolution);
    const table = neighbours(resolution);
    const { reach, link } = this.#extents;
    // In the midst of a plane all is known.
    const midst = this.block[PIECE * b + 7] === GOES_ON;
    for (let a = first[b]!; a < first[b + 1]!; a++) {
      const texel = texels[a]!;
      if (midst) {
        for (let s = SIDES * texel; s < SIDES * (texel + 1); s++) {
          reach[s] = 0.5;
          link[s] = COPLANAR_LINK;
        }
      } else if (distance[texel]! < Infinity) {
        findExtents(this.#texels, texel, table, this.#up, this.#extents);
      }
    }
  }

  /** Finds a ball around the pieces of block `b`, before they are cut. @param reach null if it is not known yet */
  #boundQuads(b: number, reach: Float32Array | null): void {
    const { block, ofTexel, resolution } = this;
    const { texels, first } = blocksOf(resolution);
    for (let v = 0; v < 3; v++) own[v] = block[PIECE * b + v]!;
    toWorldAxes(this.#toBody);
    for (let v = 0; v < 3; v++) middle[v] = world[v]!;
    const most = 0.5 + beyond(resolution);
    const at = PIECE * b + 3;
    boundQuads(this.#texels, texels, first[b]!, first[b + 1]!, ofTexel, reach, most, block, at);
  }

  /** Makes them all: for tests and tools. */
  findAll(): this {
    for (let b = 0; b < this.#known.length; b++) this.find(b);
    return this;
  }

  /** Gives surfels their numbers and their owners, and blocks a reach that none exceeds. */
  #number(field: SurfaceField): void {
    const { resolution, distance, ofTexel, object, instance, blockOf, block } = this;
    const { direction, normal } = this.#texels;
    const blocks = blocksOf(resolution);
    const table = neighbours(resolution);
    // Tangent of the angle between a ray and one through the farthest corner.
    const aside = (ASIDE * Math.SQRT2 * 2) / resolution;
    let n = 0;
    for (let b = 0; b < blocks.count; b++) {
      const begin = n;
      this.first[b] = n;
      let x = 0;
      let y = 0;
      let z = 0;
      const o = PIECE * b;
      // Of the first, for all if they lie in one plane.
      let offset = 0;
      let flat = true;
      const end = blocks.first[b + 1]!;
      for (let a = blocks.first[b]!; a < end; a++) {
        const texel = blocks.texels[a]!;
        const d = distance[texel]!;
        ofTexel[texel] = -1;
        if (d === Infinity) continue;
        const k = 3 * texel;
        const rx = direction[k]!;
        const ry = direction[k + 1]!;
        const rz = direction[k + 2]!;
        const slant = -(normal[k]! * rx + normal[k + 1]! * ry + normal[k + 2]! * rz);
        if (slant <= LEAST_SLANT || isSeam(this.#texels, texel, table)) continue;
        const p = 4 * (n - begin);
        rough[p] = d * rx;
        rough[p + 1] = d * ry;
        rough[p + 2] = d * rz;
        // How far a ray so much aside may meet its plane.
        rough[p + 3] = slant > aside ? Math.min(LONGEST, (d * aside) / (slant - aside)) : LONGEST;
        x += rough[p]!;
        y += rough[p + 1]!;
        z += rough[p + 2]!;
        if (n === begin) {
          for (let v = 0; v < 3; v++) block[o + 4 + v] = normal[k + v]!;
          offset = -d * slant;
        } else if (flat) {
          const along = block[o + 4]! * rx + block[o + 5]! * ry + block[o + 6]! * rz;
          const alike =
            block[o + 4]! * normal[k]! +
            block[o + 5]! * normal[k + 1]! +
            block[o + 6]! * normal[k + 2]!;
          flat = alike > SAME_NORMAL && Math.abs(d * along - offset) < SAME_PLANE;
        }
        object[n] = field.object[texel]!;
        instance[n] = field.instance[texel]!;
        blockOf[n] = b;
        ofTexel[texel] = n++;
      }
      const count = n - begin;
      block[o + 7] = flat ? ENDS : MIXED;
      this.#flat.offset[b] = offset;
      this.#flat.whole[b] = count === end - blocks.first[b]! ? 1 : 0;
      if (count === 0) {
        block[o] = AWAY;
        block[o + 1] = block[o + 2] = block[o + 3] = 0;
        this.#known[b] = MADE;
        continue;
      }
      x /= count;
      y /= count;
      z /= count;
      block[o] = x;
      block[o + 1] = y;
      block[o + 2] = z;
      let extent = flat ? this.#flat.extent(b, beyond(resolution)) : Infinity;
      if (extent === Infinity) {
        extent = 0;
        for (let p = 0; p < 4 * count; p += 4) {
          const dx = rough[p]! - x;
          const dy = rough[p + 1]! - y;
          const dz = rough[p + 2]! - z;
          const far = Math.sqrt(dx * dx + dy * dy + dz * dz) + rough[p + 3]!;
          if (far > extent) extent = far;
        }
      }
      block[o + 3] = extent;
    }
    this.count = this.first[blocks.count] = n;
    this.#flat.findMidsts();
    if (this.#toBody.w !== 1) {
      for (let b = 0; b < blocks.count; b++) {
        if (block[PIECE * b] === AWAY) continue;
        rotate(block, PIECE * b, this.#toBody);
        rotate(block, PIECE * b + 4, this.#toBody);
      }
    }
  }

  /**
   * Moves the surfels of object number `id` to where a world matrix puts them.
   *
   * @param toBody turns world axes into the body's
   * @param now the object's own world matrix, or a former one
   * If the matrix does more than move and turn it, its surfels no longer hold and are put out of reach, until a new field
   * shows what it has become.
   *
   * @returns whether they hold
   */
  carry(id: number, toBody: Quaternion, now = this.objects[id - 1]!.matrixWorld): boolean {
    this.#unfix(id);
    this.poses[id - 1]!.copy(now);
    since
      .copy(this.#drawnPoses[id - 1]!)
      .invert()
      .premultiply(now);
    if (!isRigid(since)) {
      for (let i = 0; i < this.count; i++) {
        if (this.object[i] === id) this.piece[PIECE * i] = this.data[STRIDE * i] = AWAY;
      }
      return false;
    }
    this.#move(id, -1, toBody, this.#drawn, MOVING);
    return true;
  }

  /**
   * Moves the surfels of object number `id`, or of one instance of it, on from where they are now: of what its world
   * matrix does not tell, as a bending skin near the place where one stands.
   *
   * @param instance -1 for all
   * @param way a rigid move, world space
   * @param toBody turns world axes into the body's
   */
  bend(id: number, instance: number, way: Matrix4, toBody: Quaternion): void {
    this.#unfix(id);
    since.copy(way);
    if (isRigid(since)) this.#move(id, instance, toBody, this.data, STRIDE);
  }

  /** Moves surfels by `since`, from where `source` has them, `stride` numbers each. */
  #move(
    id: number,
    instance: number,
    toBody: Quaternion,
    source: Float32Array,
    stride: number,
  ): void {
    const { data, count, object } = this;
    if (toBody.w !== 1) {
      toBodyMatrix.makeRotationFromQuaternion(toBody);
      since.premultiply(toBodyMatrix).multiply(toBodyMatrix.transpose());
    }
    const e = since.elements;
    // Of the move only what it does to places near the centre: the origin may be far away.
    const { x: cx, y: cy, z: cz } = this.origin;
    const tx = e[0]! * cx + e[4]! * cy + e[8]! * cz + e[12]! - cx;
    const ty = e[1]! * cx + e[5]! * cy + e[9]! * cz + e[13]! - cy;
    const tz = e[2]! * cx + e[6]! * cy + e[10]! * cz + e[14]! - cz;
    for (let i = 0; i < count; i++) {
      if (object[i] !== id || (instance >= 0 && this.instance[i] !== instance)) continue;
      // Its neighbours may be another object's, and stay behind.
      this.piece[PIECE * i + 7] = ENDS;
      for (let o = STRIDE * i, w = stride * i, v = 0; v < MOVING; v += 3, o += 3, w += 3) {
        const x = source[w]!;
        const y = source[w + 1]!;
        const z = source[w + 2]!;
        const t = v === 0 ? 1 : 0;
        data[o] = e[0]! * x + e[4]! * y + e[8]! * z + t * tx;
        data[o + 1] = e[1]! * x + e[5]! * y + e[9]! * z + t * ty;
        data[o + 2] = e[2]! * x + e[6]! * y + e[10]! * z + t * tz;
      }
      this.#setPiece(i);
    }
    for (let b = 0; b < this.first.length - 1; b++) {
      for (let i = this.first[b]!; i < this.first[b + 1]!; i++) {
        if (object[i] !== id) continue;
        this.#bound(b);
        break;
      }
    }
  }

  /** What is to be moved must be made, and is kept as it was drawn. */
  #unfix(id: number): void {
    if (this.moved[id] === 1) return;
    this.moved[id] = 1;
    const { data, first, object } = this;
    for (let b = 0; b < first.length - 1; b++) {
      for (let i = first[b]!; i < first[b + 1]!; i++) {
        if (object[i] !== id) continue;
        this.find(b);
        for (let v = 0; v < MOVING; v++) this.#drawn[MOVING * i + v] = data[STRIDE * i + v]!;
      }
    }
  }

  #bound(b: number): void {
    boundBlock(this.piece, this.first[b]!, this.first[b + 1]!, this.block, b);
  }

  #setPiece(i: number): void {
    const { data, piece } = this;
    for (let v = 0; v < 3; v++) {
      piece[PIECE * i + v] = data[STRIDE * i + v]!;
      piece[PIECE * i + 4 + v] = data[STRIDE * i + 3 + v]!;
    }
  }
}

/** Of a block's surfels: point, and how far they reach from it. */
const rough = /* @__PURE__ */ new Float64Array(4 * EDGE * EDGE);
const toWorld = /* @__PURE__ */ new Quaternion();
const since = /* @__PURE__ */ new Matrix4();
const toBodyMatrix = /* @__PURE__ */ new Matrix4();

/** Does the matrix keep lengths, to a part in a thousand? */
function isRigid({ elements: e }: Matrix4): boolean {
  for (let c = 0; c < 12; c += 4) {
    const squared = e[c]! * e[c]! + e[c + 1]! * e[c + 1]! + e[c + 2]! * e[c + 2]!;
    if (!(Math.abs(squared - 1) < 2e-3)) return false;
  }
  return true;
}

/** An orthonormal basis of the plane with the normal at `o + 3` (Duff et al. 2017), written at `o + 6` and `o + 9`. */
function tangents(data: Float32Array, o: number): void {
  const x = data[o + 3]!;
  const y = data[o + 4]!;
  const z = data[o + 5]!;
  const sign = z >= 0 ? 1 : -1;
  const a = -1 / (sign + z);
  const b = x * y * a;
  data[o + 6] = 1 + sign * x * x * a;
  data[o + 7] = sign * b;
  data[o + 8] = -sign * x;
  data[o + 9] = b;
  data[o + 10] = sign + y * y * a;
  data[o + 11] = -y;
}

/** Turns the vector at `o`. */
function rotate(data: Float32Array | Float64Array, o: number, q: Quaternion): void {
  turned.set(data[o]!, data[o + 1]!, data[o + 2]!).applyQuaternion(q);
  data[o] = turned.x;
  data[o + 1] = turned.y;
  data[o + 2] = turned.z;
}

const turned = /* @__PURE__ */ new Vector3();
