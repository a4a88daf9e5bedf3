import { type Box3, Vector3 } from 'three';
import { STRIDE } from './triangles.js';

/** Cells along the longer side, at most, and their least width, metres. */
const MOST_CELLS = 128;
const LEAST_CELL = 0.25;
/** Surfaces nearer above one another than this are one, metres. */
const THIN = 0.02;

/** A surface met on the way down a column. */
export interface Surface {
  /** Metres. */
  y: number;
  /** The vertical part of its normal, 0 to 1, whichever side it shows. */
  level: number;
}

/** What lies above and below one another, in a grid of columns: where each vertical line meets the triangles. */
export class ColumnMap {
  /** Width of a cell, metres. */
  readonly cell: number;
  readonly columns: number;
  readonly rows: number;
  readonly #min: Vector3;
  readonly #surfaces: Surface[][];

  /** @param soup triangles, metres, Y up */
  constructor(soup: Float32Array, bounds: Box3) {
    const size = bounds.getSize(new Vector3());
    this.cell = Math.max(LEAST_CELL, Math.max(size.x, size.z) / MOST_CELLS);
    this.columns = Math.max(1, Math.ceil(size.x / this.cell));
    this.rows = Math.max(1, Math.ceil(size.z / this.cell));
    this.#min = bounds.min.clone();
    this.#surfaces = Array.from({ length: this.columns * this.rows }, () => []);
    for (let i = 0; i + STRIDE <= soup.length; i += STRIDE) this.#add(soup, i);
    this.#surfaces = this.#surfaces.map(sorted);
  }

  /** The middle of a column. */
  x(column: number): number {
    return this.#min.x + (column + 0.5) * this.cell;
  }

  z(row: number): number {
    return this.#min.z + (row + 0.5) * this.cell;
  }

  /** What a column meets, from below; nothing outside of the grid. */
  at(column: number, row: number): readonly Surface[] {
    if (column < 0 || row < 0 || column >= this.columns || row >= this.rows) return [];
    return this.#surfaces[row * this.columns + column]!;
  }

  /** Puts a triangle into each column whose middle line meets it. */
  #add(soup: Float32Array, i: number): void {
    const { cell } = this;
    const ax = (soup[i]! - this.#min.x) / cell - 0.5;
    const az = (soup[i + 2]! - this.#min.z) / cell - 0.5;
    const bx = (soup[i + 3]! - this.#min.x) / cell - 0.5;
    const bz = (soup[i + 5]! - this.#min.z) / cell - 0.5;
    const cx = (soup[i + 6]! - this.#min.x) / cell - 0.5;
    const cz = (soup[i + 8]! - this.#min.z) / cell - 0.5;
    const [ay, by, cy] = [soup[i + 1]!, soup[i + 4]!, soup[i + 7]!];
    const area = (bx - ax) * (cz - az) - (cx - ax) * (bz - az);
    if (!(Math.abs(area) > 1e-9)) return;

    const level = levelOf(bx - ax, (by - ay) / cell, bz - az, cx - ax, (cy - ay) / cell, cz - az);
    const lastColumn = Math.min(this.columns - 1, Math.floor(Math.max(ax, bx, cx)));
    const lastRow = Math.min(this.rows - 1, Math.floor(Math.max(az, bz, cz)));
    for (let row = Math.max(0, Math.ceil(Math.min(az, bz, cz))); row <= lastRow; row++) {
      const first = Math.max(0, Math.ceil(Math.min(ax, bx, cx)));
      for (let column = first; column <= lastColumn; column++) {
        const u = ((column - ax) * (cz - az) - (cx - ax) * (row - az)) / area;
        const v = ((bx - ax) * (row - az) - (column - ax) * (bz - az)) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        const y = ay + u * (by - ay) + v * (cy - ay);
        this.#surfaces[row * this.columns + column]!.push({ y, level });
      }
    }
  }
}

/** The vertical part of the normal of two edges. */
function levelOf(ux: number, uy: number, uz: number, vx: number, vy: number, vz: number): number {
  const y = uz * vx - ux * vz;
  return Math.abs(y) / Math.hypot(uy * vz - uz * vy, y, ux * vy - uy * vx);
}

/** From below, without what lies double. */
function sorted(surfaces: Surface[]): Surface[] {
  surfaces.sort((a, b) => a.y - b.y);
  return surfaces.filter(({ y }, i) => i + 1 === surfaces.length || surfaces[i + 1]!.y - y > THIN);
}
