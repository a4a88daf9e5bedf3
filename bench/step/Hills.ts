import { Solid } from '../../test/support/world/Solid.js';

/** How far a ray is followed, metres: farther than a cubemap sees. */
const FAR = 5;

/** The height of the ground of `terrain`, metres. */
const height = (x: number, z: number): number =>
  Math.sin(0.5 * x) * Math.cos(0.4 * z) + 0.1 * Math.sin(5 * x);

/** The triangles of `test/support/terrain.ts`, without an end: only to be seen, not to be judged by. */
export class Hills extends Solid {
  readonly bound = 1e6;

  /** @param cell edge of a square of two triangles, metres */
  constructor(readonly cell: number) {
    super('hills');
  }

  cast(ox: number, oy: number, oz: number, dx: number, dy: number, dz: number): number {
    const { cell } = this;
    let i = Math.floor(ox / cell);
    let j = Math.floor(oz / cell);
    const stepX = dx > 0 ? 1 : -1;
    const stepZ = dz > 0 ? 1 : -1;
    let nextX = dx === 0 ? Infinity : ((i + (dx > 0 ? 1 : 0)) * cell - ox) / dx;
    let nextZ = dz === 0 ? Infinity : ((j + (dz > 0 ? 1 : 0)) * cell - oz) / dz;
    for (let entered = 0; entered < FAR;) {
      const t = this.#castIn(i, j, ox, oy, oz, dx, dy, dz);
      if (t < Infinity) return t;
      entered = Math.min(nextX, nextZ);
      if (nextX < nextZ) {
        i += stepX;
        nextX += Math.abs(cell / dx);
      } else {
        j += stepZ;
        nextZ += Math.abs(cell / dz);
      }
    }
    return Infinity;
  }

  nearest(): void {
    throw new Error('Hills: only to be seen.');
  }

  /** The two triangles of a square: their common edge runs from (x, z + 1) to (x + 1, z). */
  #castIn(
    i: number,
    j: number,
    ox: number,
    oy: number,
    oz: number,
    dx: number,
    dy: number,
    dz: number,
  ): number {
    // prettier-ignore
    const { cell } = this;
    const x = i * cell;
    const z = j * cell;
    const b = height(x, z + cell);
    const c = height(x + cell, z);
    let best = Infinity;
    for (let half = 0; half < 2; half++) {
      const corner = half === 0 ? height(x, z) : height(x + cell, z + cell);
      const slopeX = (half === 0 ? c - corner : corner - b) / cell;
      const slopeZ = (half === 0 ? b - corner : corner - c) / cell;
      const base = half === 0 ? corner : corner - (slopeX + slopeZ) * cell;
      // y = base + slopeX (x - i cell) + slopeZ (z - j cell)
      const t =
        (base + slopeX * (ox - x) + slopeZ * (oz - z) - oy) / (dy - slopeX * dx - slopeZ * dz);
      if (!(t > 0 && t < best)) continue;
      const u = (ox + t * dx - x) / cell;
      const v = (oz + t * dz - z) / cell;
      if (u < 0 || v < 0 || u > 1 || v > 1 || (half === 0 ? u + v > 1 : u + v < 1)) continue;
      best = t;
      const length = Math.sqrt(1 + slopeX * slopeX + slopeZ * slopeZ);
      this.nx = -slopeX / length;
      this.ny = 1 / length;
      this.nz = -slopeZ / length;
    }
    return best;
  }
}
