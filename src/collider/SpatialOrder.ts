import { RUN, type Vertices, widened } from './Vertices.js';

/** Triangles between two looks at the clock. */
const GRAIN = 512;
/** Most cells of the grid: their counts take a megabyte while it is made. */
const CELLS = 2 ** 18;
/** As many triangles a cell are fine enough. */
const IN_CELL = 32;

/**
 * Triangles in the order of a grid's cells, by their first vertex, and the boxes around runs of them; found bit by bit (a
 * counting sort). Memory is what takes the time, where they are shuffled: so each is looked up but twice.
 */
export class SpatialOrder {
  /** Numbers of triangles, in order once it is `done`. */
  readonly triangles: Uint32Array;
  done = false;
  readonly #vertices: Vertices;
  readonly #runs: Float32Array;
  readonly #least: [number, number, number];
  /** Cells a unit of length, and along each axis. */
  readonly #scale: number;
  readonly #cells: [number, number, number];
  /** How many triangles each cell has, then where its next one goes. */
  #places: Uint32Array;
  #counted = false;
  #next = 0;

  /**
   * @param whole the box around about all triangles; what is beyond goes to the cells at its border
   * @param runs receives the box around each run of 64
   */
  constructor(vertices: Vertices, whole: Float32Array, runs: Float32Array) {
    this.#vertices = vertices;
    this.#runs = runs;
    for (let i = 0; i < runs.length; i++) runs[i] = i % 6 < 3 ? Infinity : -Infinity;
    this.triangles = new Uint32Array(vertices.triangles);
    this.#least = [whole[0]!, whole[1]!, whole[2]!];
    const extents = [whole[3]! - whole[0]!, whole[4]! - whole[1]!, whole[5]! - whole[2]!];
    const most = Math.min(CELLS, Math.max(1, vertices.triangles / IN_CELL));
    let side = Math.max(...extents) / most;
    const count = (axis: number) => Math.max(1, Math.ceil(extents[axis]! / side));
    while (count(0) * count(1) * count(2) > most) side *= 1.1;
    this.#scale = 1 / side;
    this.#cells = [count(0), count(1), count(2)];
    this.#places = new Uint32Array(this.#cells[0] * this.#cells[1] * this.#cells[2]);
  }

  /** Does some triangles more. */
  work(): void {
    const { triangles } = this.#vertices;
    const end = Math.min(triangles, this.#next + GRAIN);
    if (this.#counted) this.#place(this.#next, end);
    else this.#count(this.#next, end);
    this.#next = end;
    if (end < triangles) return;
    if (this.#counted) {
      this.done = true;
      this.#places = new Uint32Array(0);
      return;
    }
    const places = this.#places;
    let place = 0;
    for (let cell = 0; cell < places.length; cell++) {
      const count = places[cell]!;
      places[cell] = place;
      place += count;
    }
    this.#counted = true;
    this.#next = 0;
  }

  #count(from: number, to: number): void {
    const { array, stride, offset, index } = this.#vertices;
    const places = this.#places;
    for (let i = from; i < to; i++) {
      const at = stride * (index === null ? 3 * i : index[3 * i]!) + offset;
      places[this.#cellOf(array[at]!, array[at + 1]!, array[at + 2]!)]!++;
    }
  }

  #place(from: number, to: number): void {
    const { array, stride, offset, factor, index } = this.#vertices;
    const { triangles } = this;
    const places = this.#places;
    const runs = this.#runs;
    for (let i = from; i < to; i++) {
      const corner = 3 * i;
      const a = stride * (index === null ? corner : index[corner]!) + offset;
      const b = stride * (index === null ? corner + 1 : index[corner + 1]!) + offset;
      const c = stride * (index === null ? corner + 2 : index[corner + 2]!) + offset;
      const place = places[this.#cellOf(array[a]!, array[a + 1]!, array[a + 2]!)]!++;
      triangles[place] = i;
      let at = 6 * Math.floor(place / RUN);
      for (let axis = 0; axis < 3; axis++, at++) {
        const u = array[a + axis]! * factor;
        const v = array[b + axis]! * factor;
        const w = array[c + axis]! * factor;
        const least = widened(u < v ? (u < w ? u : w) : v < w ? v : w, -1);
        const most = widened(u > v ? (u > w ? u : w) : v > w ? v : w, 1);
        if (least < runs[at]!) runs[at] = least;
        if (most > runs[at + 3]!) runs[at + 3] = most;
      }
    }
  }

  #cellOf(x: number, y: number, z: number): number {
    const { factor } = this.#vertices;
    const [nx, ny, nz] = this.#cells;
    const i = this.#along(x * factor - this.#least[0], nx);
    const j = this.#along(y * factor - this.#least[1], ny);
    const k = this.#along(z * factor - this.#least[2], nz);
    return i + nx * (j + ny * k);
  }

  /** Out of range, or no number at all, is the first or the last. */
  #along(distance: number, count: number): number {
    const cell = Math.floor(distance * this.#scale);
    return cell > 0 ? Math.min(cell, count - 1) : 0;
  }
}
