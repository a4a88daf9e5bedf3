import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute } from 'three';
import { SpatialOrder } from './SpatialOrder.js';
import { RUN, type Vertices, widened } from './Vertices.js';

/** Runs with another box around their boxes. */
const RUNS = 32;
/** Runs, here and there, by which an order is judged before all of it is looked at. */
const SAMPLES = 64;
/** Triangles, and runs whose boxes are known, between two looks at the clock: few, as the first are slow. */
const GRAIN = 4 * RUN;
const RUN_GRAIN = 512;
/** Part of its runs that a place in a mesh may be in, with a fiftieth of the mesh around it; of more, the order is bad. */
const SCATTERED = 0.05;
const AROUND = 0.02;

/**
 * Where a geometry's triangles are: a box around each run of 64, in the geometry's own order or, where that is
 * scattered, in one of its own. It is found bit by bit. 0.4 bytes a triangle, 4.4 with an order of its own.
 */
export class TriangleIndex {
  readonly vertices: Vertices;
  /** All is known. */
  done = false;
  readonly #position: BufferAttribute | InterleavedBufferAttribute;
  readonly #positionVersion: number;
  readonly #index: BufferAttribute | null;
  readonly #indexVersion: number;
  /** Boxes, made once the work begins: what is edited all the time needs none. */
  #runs = new Float32Array(0);
  #blocks = new Float32Array(0);
  readonly #whole = new Float32Array(6);
  /** Boxes of the runs by which the order is judged; null once it is. */
  #samples: Float32Array | null = null;
  #sampled = 0;
  #next = 0;
  #joined = 0;
  #judged = 0;
  #scatter = 0;
  #order: SpatialOrder | null = null;

  constructor(geometry: BufferGeometry, vertices: Vertices) {
    this.vertices = vertices;
    this.#position = geometry.attributes.position as BufferAttribute;
    this.#positionVersion = versionOf(this.#position);
    this.#index = geometry.index;
    this.#indexVersion = geometry.index?.version ?? 0;
  }

  /** Is the geometry still the one it was made of? */
  holds(geometry: BufferGeometry): boolean {
    return (
      geometry.attributes.position === this.#position &&
      versionOf(this.#position) === this.#positionVersion &&
      geometry.index === this.#index &&
      (geometry.index === null || geometry.index.version === this.#indexVersion)
    );
  }

  /** Bytes it takes. */
  get bytes(): number {
    const order = this.#order?.triangles.byteLength ?? 0;
    return this.#runs.byteLength + this.#blocks.byteLength + order;
  }

  /** Has it an order of its own? */
  get ordered(): boolean {
    return this.#order !== null;
  }

  /** Goes on until it is done, or `performance.now()` is past `end`. */
  work(end: number): void {
    do this.#portion();
    while (!this.done && performance.now() < end);
  }

  #portion(): void {
    const { triangles } = this.vertices;
    if (this.#runs.length === 0) {
      const runs = Math.ceil(triangles / RUN);
      this.#runs = new Float32Array(6 * runs);
      this.#blocks = new Float32Array(6 * Math.ceil(runs / RUNS));
      this.#samples = new Float32Array(6 * Math.min(SAMPLES, runs));
    } else if (this.#samples !== null) {
      this.#sample(this.#samples);
    } else if (this.#order !== null && !this.#order.done) {
      this.#order.work();
    } else if (this.#order === null && this.#next < triangles) {
      const from = this.#next;
      this.#next = Math.min(triangles, from + GRAIN);
      for (let start = from; start < this.#next; start += RUN)
        this.#measure(start, this.#runs, (6 * start) / RUN);
    } else if (this.#joined < this.#blocks.length) {
      this.#join();
    } else if (this.#order === null && this.#judged < this.#runs.length) {
      const from = this.#judged;
      this.#judged = Math.min(this.#runs.length, from + 6 * RUN_GRAIN);
      this.#scatter += this.#scattering(this.#runs, from, this.#judged);
    } else if (this.#order === null && this.#isScattered(this.#scatter, this.#runs)) {
      this.#order = new SpatialOrder(this.vertices, this.#whole, this.#runs);
      this.#joined = 0;
    } else {
      this.done = true;
    }
  }

  /**
   * Finds the triangles in a box, and some near it.
   *
   * @param box its least x, y, z and its greatest, in the geometry's own space
   * @param from number of the first triangle that counts
   * @param to number after the last
   * @param target receives their numbers from `count` on, in ascending order
   * @param around a box that is made to hold theirs too
   * @returns how many `target` holds then, or -1 if they are more than it takes
   */
  gather(
    box: Float64Array,
    from: number,
    to: number,
    target: Uint32Array,
    count: number,
    around?: Float64Array,
  ): number {
    const start = count;
    const { triangles } = this.vertices;
    const order = this.#order?.triangles ?? null;
    for (let block = 0; 6 * block < this.#blocks.length; block++) {
      if (!meets(this.#blocks, 6 * block, box)) continue;
      const last = Math.min(this.#runs.length / 6, (block + 1) * RUNS);
      for (let run = block * RUNS; run < last; run++) {
        if (!meets(this.#runs, 6 * run, box)) continue;
        const end = Math.min(triangles, (run + 1) * RUN);
        if (count + RUN > target.length) return -1;
        if (around !== undefined) unite(this.#runs, 6 * run, around, 0);
        for (let i = run * RUN; i < end; i++) {
          const triangle = order === null ? i : order[i]!;
          if (triangle >= from && triangle < to) target[count++] = triangle;
        }
      }
    }
    // As the user's own order has them: what lies in one plane is drawn over as it is there.
    if (order !== null) target.subarray(start, count).sort();
    return count;
  }

  /** Is the order bad by a few of its runs? Then the rest need not be looked at. */
  #sample(boxes: Float32Array): void {
    const end = Math.min(boxes.length, this.#sampled + (6 * GRAIN) / RUN);
    const runs = Math.ceil(this.vertices.triangles / RUN);
    for (let at = this.#sampled; at < end; at += 6) {
      const run = Math.floor((runs * at) / boxes.length);
      this.#measure(RUN * run, boxes, at);
    }
    this.#sampled = end;
    if (end < boxes.length) return;
    this.#samples = null;
    this.#unite(boxes, 0, end);
    if (!this.#isScattered(this.#scattering(boxes, 0, end), boxes)) return;
    this.#order = new SpatialOrder(this.vertices, this.#whole, this.#runs);
  }

  /** The box around one run, in the geometry's own order. */
  #measure(start: number, boxes: Float32Array, at: number): void {
    const { array, stride, offset, factor, index, triangles } = this.vertices;
    const end = Math.min(triangles, start + RUN);
    let x0 = Infinity;
    let y0 = Infinity;
    let z0 = Infinity;
    let x1 = -Infinity;
    let y1 = -Infinity;
    let z1 = -Infinity;
    for (let i = start; i < end; i++) {
      for (let k = 3 * i; k < 3 * i + 3; k++) {
        const at = stride * (index === null ? k : index[k]!) + offset;
        const x = array[at]!;
        const y = array[at + 1]!;
        const z = array[at + 2]!;
        if (x < x0) x0 = x;
        if (x > x1) x1 = x;
        if (y < y0) y0 = y;
        if (y > y1) y1 = y;
        if (z < z0) z0 = z;
        if (z > z1) z1 = z;
      }
    }
    boxes[at] = widened(x0 * factor, -1);
    boxes[at + 1] = widened(y0 * factor, -1);
    boxes[at + 2] = widened(z0 * factor, -1);
    boxes[at + 3] = widened(x1 * factor, 1);
    boxes[at + 4] = widened(y1 * factor, 1);
    boxes[at + 5] = widened(z1 * factor, 1);
  }

  /** The boxes around boxes, for some of them, and around all. */
  #join(): void {
    const blocks = this.#blocks;
    const from = this.#joined;
    this.#joined = Math.min(blocks.length, from + (6 * RUN_GRAIN) / RUNS);
    for (let at = from; at < this.#joined; at += 6) {
      empty(blocks, at);
      const end = Math.min(this.#runs.length, (at + 6) * RUNS);
      for (let run = at * RUNS; run < end; run += 6) unite(this.#runs, run, blocks, at);
    }
    this.#unite(blocks, from, this.#joined);
  }

  /** The box around all boxes, as far as they are known. */
  #unite(boxes: Float32Array, from: number, end: number): void {
    if (from === 0) empty(this.#whole, 0);
    for (let at = from; at < end; at += 6) unite(boxes, at, this.#whole, 0);
  }

  /** Are runs all over the place? @param scattering of all of them */
  #isScattered(scattering: number, runs: Float32Array): boolean {
    return scattering > (SCATTERED * runs.length) / 6;
  }

  /** The parts of the mesh that some runs may be in, added up. */
  #scattering(runs: Float32Array, from: number, end: number): number {
    const whole = this.#whole;
    const longest = Math.max(whole[3]! - whole[0]!, whole[4]! - whole[1]!, whole[5]! - whole[2]!);
    if (!(longest > 0)) return 0;
    const around = AROUND * longest;
    let sum = 0;
    for (let at = from; at < end; at += 6) {
      let part = 1;
      for (let axis = 0; axis < 3; axis++) {
        const extent = Math.max(0, runs[at + axis + 3]! - runs[at + axis]!);
        part *= (extent + around) / (whole[axis + 3]! - whole[axis]! + around);
      }
      sum += part;
    }
    return sum;
  }
}

export function versionOf(attribute: BufferAttribute | InterleavedBufferAttribute): number {
  return 'data' in attribute ? attribute.data.version : attribute.version;
}

/** Makes a box that nothing is in. */
export function empty(boxes: Float32Array | Float64Array, at: number): void {
  boxes[at] = boxes[at + 1] = boxes[at + 2] = Infinity;
  boxes[at + 3] = boxes[at + 4] = boxes[at + 5] = -Infinity;
}

function unite(
  from: Float32Array,
  at: number,
  to: Float32Array | Float64Array,
  into: number,
): void {
  for (let axis = 0; axis < 3; axis++) {
    to[into + axis] = Math.min(to[into + axis]!, from[at + axis]!);
    to[into + axis + 3] = Math.max(to[into + axis + 3]!, from[at + axis + 3]!);
  }
}

function meets(boxes: Float32Array, at: number, box: Float64Array): boolean {
  return (
    boxes[at]! <= box[3]! &&
    boxes[at + 3]! >= box[0]! &&
    boxes[at + 1]! <= box[4]! &&
    boxes[at + 4]! >= box[1]! &&
    boxes[at + 2]! <= box[5]! &&
    boxes[at + 5]! >= box[2]!
  );
}
