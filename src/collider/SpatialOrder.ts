import type { Vertices } from './TriangleIndex.js';

/** Most cells of the grid: their counts take a megabyte while it is made. */
const CELLS = 2 ** 18;
/** As many triangles a cell are fine enough. */
const IN_CELL = 32;

/** Triangles in the order of a grid's cells, by their first vertex; found bit by bit (a counting sort). */
export class SpatialOrder {
  /** Numbers of triangles, in order once it is `done`. */
  readonly triangles: Uint32Array;
  done = false;
  readonly #vertices: Vertices;
  readonly #least: [number, number, number];
  /** Cells a unit of length, and along each axis. */
  readonly #scale: number;
  readonly #cells: [number, number, number];
  /** How many triangles each cell has, then where its next one goes. */
  #places: Uint32Array;
  #counted = false;
  #next = 0;

  /** @param whole the box around all vertices */
  constructor(vertices: Vertices, whole: Float32Array) {
    this.#vertices = vertices;
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

  /** Does that many triangles more. */
  work(grain: number): void {
    const { triangles } = this.#vertices;
    const end = Math.min(triangles, this.#next + grain);
    const places = this.#places;
    for (let i = this.#next; i < end; i++) {
      const cell = this.#cellOf(i);
      if (this.#counted) this.triangles[places[cell]!++] = i;
      else places[cell]!++;
    }
    this.#next = end;
    if (end < triangles) return;
    if (this.#counted) {
      this.done = true;
      this.#places = new Uint32Array(0);
      return;
    }
    let place = 0;
    for (let cell = 0; cell < places.length; cell++) {
      const count = places[cell]!;
      places[cell] = place;
      place += count;
    }
    this.#counted = true;
    this.#next = 0;
  }

  #cellOf(triangle: number): number {
    const { array, stride, offset, factor, index } = this.#vertices;
    const at = stride * (index === null ? 3 * triangle : index[3 * triangle]!) + offset;
    const [nx, ny, nz] = this.#cells;
    const x = this.#along(array[at]! * factor - this.#least[0], nx);
    const y = this.#along(array[at + 1]! * factor - this.#least[1], ny);
    const z = this.#along(array[at + 2]! * factor - this.#least[2], nz);
    return x + nx * (y + ny * z);
  }

  /** Out of range, or no number at all, is the first or the last. */
  #along(distance: number, count: number): number {
    const cell = Math.floor(distance * this.#scale);
    return cell > 0 ? Math.min(cell, count - 1) : 0;
  }
}
