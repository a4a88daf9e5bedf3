import { Matrix4, type Object3D, Quaternion, Vector3 } from 'three';
import { blocksOf } from './blocks.js';
import { setCorners } from './corners.js';
import { APART, COPLANAR_LINK, type Extents, findExtents } from './extents.js';
import { isSeam } from './isSeam.js';
import { STRIDE } from './layout.js';
import { neighbours, SIDES } from './neighbours.js';
import { AWAY, boundBlock, ENDS, GOES_ON, PIECE } from './pieces.js';
import type { SurfaceField } from './SurfaceField.js';

/**
 * A surface seen at a slant less than this (cosine between ray and normal) is told from so far aside that its texel's
 * point may be centimetres off: it is left to a later, nearer look.
 */
const LEAST_SLANT = 0.06;
/** What of a surfel moves with its object. */
const MOVING = 12;

/**
 * The surfels of one field: for each texel that saw something a piece of plane, as far as it is sure to reach.
 *
 * A surfel is a point with a plane and the corners of a piece of it, trimmed against its neighbours (see `findExtents`):
 * flat is exactly flat, an edge is where the planes meet, and next to nothing grows past a silhouette.
 *
 * Numbers are relative to the field's centre and turned into the body's frame, whose Y is the character's up. A moved
 * object's surfels are carried along by its matrix (`carry`).
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

  /** Surfels as drawn, before any was carried. */
  readonly #drawn: Float32Array;
  readonly #drawnPoses: Matrix4[] = [];
  readonly #extents: Extents;

  constructor(readonly resolution: number) {
    const count = 6 * resolution * resolution;
    this.data = new Float32Array(STRIDE * count);
    this.#drawn = new Float32Array(MOVING * count);
    this.piece = new Float32Array(PIECE * count);
    const blocks = blocksOf(resolution);
    this.block = new Float32Array(PIECE * blocks.count);
    this.first = new Int32Array(blocks.count + 1);
    this.link = new Int32Array(SIDES * count);
    this.object = new Uint16Array(count);
    this.instance = new Uint32Array(count);
    this.distance = new Float32Array(count);
    this.ofTexel = new Int32Array(count);
    this.#extents = {
      reach: new Float32Array(SIDES * count),
      link: new Uint8Array(SIDES * count),
    };
  }

  /**
   * Takes a field's texels over; the field may be overwritten afterwards.
   *
   * @param toBody turns world axes into the body's
   */
  fill(field: SurfaceField, toBody: Quaternion): this {
    const { count, direction, distance, normal, resolution } = field;
    this.distance.set(distance);
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

    const table = neighbours(resolution);
    up.set(0, 1, 0).applyQuaternion(toWorld.copy(toBody).conjugate());
    findExtents(field, table, up, this.#extents);
    const { data, link, ofTexel } = this;
    const blocks = blocksOf(resolution);
    let n = 0;
    for (let a = 0, b = 0; a < count; a++) {
      if (blocks.first[b] === a) this.first[b++] = n;
      const texel = blocks.texels[a]!;
      const k = 3 * texel;
      const slant =
        normal[k]! * direction[k]! +
        normal[k + 1]! * direction[k + 1]! +
        normal[k + 2]! * direction[k + 2]!;
      const seen = distance[texel]! < Infinity && slant < -LEAST_SLANT;
      ofTexel[texel] = seen && !isSeam(field, texel, table) ? n++ : -1;
    }
    this.count = this.first[blocks.count] = n;
    const turn = toBody.w !== 1;
    for (let texel = 0; texel < count; texel++) {
      const i = ofTexel[texel]!;
      if (i < 0) continue;
      const k = 3 * texel;
      const d = distance[texel]!;
      const o = STRIDE * i;
      data[o] = direction[k]! * d;
      data[o + 1] = direction[k + 1]! * d;
      data[o + 2] = direction[k + 2]! * d;
      data[o + 3] = normal[k]!;
      data[o + 4] = normal[k + 1]!;
      data[o + 5] = normal[k + 2]!;
      tangents(data, o);
      this.piece[PIECE * i + 3] = setCorners(data, o, field, texel, table, this.#extents);
      if (turn) for (let v = 0; v < 12; v += 3) rotate(data, o + v, toBody);
      let kind = GOES_ON;
      for (let side = 0; side < SIDES; side++) {
        const goes = this.#extents.link[SIDES * texel + side]!;
        link[SIDES * i + side] = goes === APART ? -1 : ofTexel[table[SIDES * texel + side]!]!;
        if (goes !== COPLANAR_LINK) kind = ENDS;
      }
      this.piece[PIECE * i + 7] = kind;
      this.object[i] = field.object[texel]!;
      this.instance[i] = field.instance[texel]!;
    }
    for (let i = 0; i < n; i++) {
      for (let v = 0; v < MOVING; v++) this.#drawn[MOVING * i + v] = data[STRIDE * i + v]!;
      this.#setPiece(i);
    }
    for (let b = 0; b < blocks.count; b++) this.#bound(b);
    return this;
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
    this.poses[id - 1]!.copy(now);
    this.moved[id] = 1;
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
    this.moved[id] = 1;
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

const up = /* @__PURE__ */ new Vector3();
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
function rotate(data: Float32Array, o: number, q: Quaternion): void {
  turned.set(data[o]!, data[o + 1]!, data[o + 2]!).applyQuaternion(q);
  data[o] = turned.x;
  data[o + 1] = turned.y;
  data[o + 2] = turned.z;
}

const turned = /* @__PURE__ */ new Vector3();
