import { Matrix4, type Object3D, Quaternion, Vector3 } from 'three';
import { FACES } from '../cube/faces.js';
import { blocksOf } from './blocks.js';
import { neighbours, SIDES } from './neighbours.js';
import { ENDS, GOES_ON, MIXED, PIECE } from './pieces.js';
import type { SurfaceField } from './SurfaceField.js';
import { APART, COPLANAR_LINK, CREASE, findExtents, meeting, type Extents } from './extents.js';

/** Most corners a surfel has. */
const MOST_CORNERS = 8;
/**
 * Numbers a surfel: point, normal, tangent, bitangent (3 each), how many corners it has, then those in terms of the
 * latter two (2 each).
 */
export const STRIDE = 13 + 2 * MOST_CORNERS;
/** Where the number of a surfel's corners stands, the corners behind it. */
export const CORNERS = 12;
/**
 * A surface seen at a slant less than this (cosine between ray and normal) is told from so far aside that its texel's
 * point may be centimetres off: it is left to a later, nearer look.
 */
const LEAST_SLANT = 0.06;
/** Where surfels go that no longer hold, metres. */
const AWAY = 1e6;
/** A block's surfels lie in one plane if their normals are closer than this (0.8°) and none is farther off, metres. */
const SAME_NORMAL = 0.9999;
const SAME_PLANE = 1e-4;
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
  /** A polygon being cut, and what is left of it. */
  #polygon = new Float32Array(2 * (MOST_CORNERS + 1));
  #cut = new Float32Array(2 * (MOST_CORNERS + 1));

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
      ofTexel[texel] = distance[texel]! < Infinity && slant < -LEAST_SLANT ? n++ : -1;
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
      this.#setCorners(i, texel, o, field, table);
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

  #setPiece(i: number): void {
    const { data, piece } = this;
    for (let v = 0; v < 3; v++) {
      piece[PIECE * i + v] = data[STRIDE * i + v]!;
      piece[PIECE * i + 4 + v] = data[STRIDE * i + 3 + v]!;
    }
  }

  /** Finds what tells block `b` apart. */
  #bound(b: number): void {
    const { block, first, piece } = this;
    const from = first[b]!;
    const to = first[b + 1]!;
    let x = 0;
    let y = 0;
    let z = 0;
    let n = 0;
    for (let p = PIECE * from; p < PIECE * to; p += PIECE) {
      if (piece[p] === AWAY) continue;
      x += piece[p]!;
      y += piece[p + 1]!;
      z += piece[p + 2]!;
      n++;
    }
    x = n > 0 ? x / n : AWAY;
    y /= Math.max(1, n);
    z /= Math.max(1, n);
    let extent = 0;
    let kind = GOES_ON;
    const nx = piece[PIECE * from + 4]!;
    const ny = piece[PIECE * from + 5]!;
    const nz = piece[PIECE * from + 6]!;
    for (let p = PIECE * from; p < PIECE * to; p += PIECE) {
      if (piece[p] === AWAY) continue;
      const dx = piece[p]! - x;
      const dy = piece[p + 1]! - y;
      const dz = piece[p + 2]! - z;
      extent = Math.max(extent, Math.sqrt(dx * dx + dy * dy + dz * dz) + piece[p + 3]!);
      const alike = nx * piece[p + 4]! + ny * piece[p + 5]! + nz * piece[p + 6]!;
      const off = Math.abs(nx * dx + ny * dy + nz * dz);
      if (piece[p + 7] !== GOES_ON || alike < SAME_NORMAL || off > SAME_PLANE) kind = MIXED;
    }
    const o = PIECE * b;
    block[o] = x;
    block[o + 1] = y;
    block[o + 2] = z;
    block[o + 3] = extent;
    block[o + 4] = nx;
    block[o + 5] = ny;
    block[o + 6] = nz;
    block[o + 7] = kind;
  }

  /**
   * Where the rays through the corners of what the texel reaches meet its plane, cut at the creases with all eight
   * neighbours, in tangent coordinates.
   */
  #setCorners(i: number, texel: number, o: number, field: SurfaceField, table: Int32Array): void {
    const n = this.resolution;
    const { data } = this;
    const { forward: f, right: r, up: u } = FACES[Math.floor(texel / (n * n))]!;
    const x = texel % n;
    const y = Math.floor(texel / n) % n;
    const s = SIDES * texel;
    const { reach, link } = this.#extents;
    const px = data[o]!;
    const py = data[o + 1]!;
    const pz = data[o + 2]!;
    const nx = data[o + 3]!;
    const ny = data[o + 4]!;
    const nz = data[o + 5]!;
    const offset = nx * px + ny * py + nz * pz;
    for (let c = 0; c < 4; c++) {
      // Counter-clockwise: (+x, +y), (-x, +y), (-x, -y), (+x, -y).
      const dx = c === 0 || c === 3 ? reach[s]! : -reach[s + 1]!;
      const dy = c < 2 ? reach[s + 2]! : -reach[s + 3]!;
      const a = (2 * (x + dx) + 1) / n - 1;
      const b = (2 * (y + dy) + 1) / n - 1;
      const rx = f[0] + a * r[0] + b * u[0];
      const ry = f[1] + a * r[1] + b * u[1];
      const rz = f[2] + a * r[2] + b * u[2];
      const depth = offset / (nx * rx + ny * ry + nz * rz);
      const qx = depth * rx - px;
      const qy = depth * ry - py;
      const qz = depth * rz - pz;
      let along = qx * data[o + 6]! + qy * data[o + 7]! + qz * data[o + 8]!;
      let across = qx * data[o + 9]! + qy * data[o + 10]! + qz * data[o + 11]!;
      // Edge-on, a ray may miss the plane or meet it far away: no extent is better than a wild one.
      if (!(depth > 0 && along * along + across * across < 1)) along = across = 0;
      this.#polygon[2 * c] = along;
      this.#polygon[2 * c + 1] = across;
    }
    let corners = 4;
    for (let side = 0; side < SIDES; side++) {
      if (link[s + side] !== CREASE) continue;
      corners = this.#cutAt(field, table[s + side]!, o, corners);
    }
    for (let dy = -1; dy <= 1; dy += 2) {
      if (y + dy < 0 || y + dy >= n) continue;
      for (let dx = -1; dx <= 1; dx += 2) {
        if (x + dx < 0 || x + dx >= n) continue;
        const j = texel + dy * n + dx;
        const k = 3 * j;
        const { normal } = field;
        // Alike, there is nothing to cut.
        const same =
          normal[k]! * normal[3 * texel]! +
          normal[k + 1]! * normal[3 * texel + 1]! +
          normal[k + 2]! * normal[3 * texel + 2]!;
        if (same > 0.9999 || meeting(field, texel, j) !== CREASE) continue;
        corners = this.#cutAt(field, j, o, corners);
      }
    }
    let extent = 0;
    for (let c = 0; c < corners; c++) {
      const along = this.#polygon[2 * c]!;
      const across = this.#polygon[2 * c + 1]!;
      data[o + CORNERS + 1 + 2 * c] = along;
      data[o + CORNERS + 2 + 2 * c] = across;
      extent = Math.max(extent, along * along + across * across);
    }
    data[o + CORNERS] = corners;
    this.piece[PIECE * i + 3] = Math.sqrt(extent);
  }

  /** Cuts `#polygon`, in the plane of the surfel at `o`, along the plane of texel `j`. */
  #cutAt(field: SurfaceField, j: number, o: number, corners: number): number {
    if (corners === MOST_CORNERS) return corners;
    const { data } = this;
    const { direction, distance, normal } = field;
    const k = 3 * j;
    const mx = normal[k]!;
    const my = normal[k + 1]!;
    const mz = normal[k + 2]!;
    const d = distance[j]!;
    const offset = d * (mx * direction[k]! + my * direction[k + 1]! + mz * direction[k + 2]!);
    let own = mx * data[o]! + my * data[o + 1]! + mz * data[o + 2]! - offset;
    let along = mx * data[o + 6]! + my * data[o + 7]! + mz * data[o + 8]!;
    let across = mx * data[o + 9]! + my * data[o + 10]! + mz * data[o + 11]!;
    // What lies toward the neighbour goes: where its ray would meet this plane. (The own point may lie on the crease.)
    const nx = data[o + 3]!;
    const ny = data[o + 4]!;
    const nz = data[o + 5]!;
    const rx = direction[k]!;
    const ry = direction[k + 1]!;
    const rz = direction[k + 2]!;
    const height = nx * data[o]! + ny * data[o + 1]! + nz * data[o + 2]!;
    const depth = height / (nx * rx + ny * ry + nz * rz);
    if (depth * (mx * rx + my * ry + mz * rz) > offset) {
      own = -own;
      along = -along;
      across = -across;
    }
    const polygon = this.#polygon;
    const cut = this.#cut;
    let n = 0;
    let ax = polygon[2 * corners - 2]!;
    let ay = polygon[2 * corners - 1]!;
    let a = own + along * ax + across * ay;
    for (let c = 0; c < corners; c++) {
      const bx = polygon[2 * c]!;
      const by = polygon[2 * c + 1]!;
      const b = own + along * bx + across * by;
      if (a >= 0 !== b >= 0) {
        const t = a / (a - b);
        cut[2 * n] = ax + t * (bx - ax);
        cut[2 * n + 1] = ay + t * (by - ay);
        n++;
      }
      if (b >= 0 && n < MOST_CORNERS) {
        cut[2 * n] = bx;
        cut[2 * n + 1] = by;
        n++;
      }
      ax = bx;
      ay = by;
      a = b;
    }
    if (n === 0) return corners;
    this.#polygon = cut;
    this.#cut = polygon;
    return n;
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
