import { texelIndex } from '../cube/atlas.js';
import { FACES } from '../cube/faces.js';
import { directionTexel } from '../cube/texelDirections.js';

/** The sides of a texel in every table of neighbours: toward growing x, falling x, growing y, falling y of its face. */
export const SIDES = 4;

const tables = new Map<number, Int32Array>();

/**
 * The four neighbours of every texel, across the seams of the faces too, in the order +x, -x, +y, -y of its own face.
 * Made once a resolution and shared.
 *
 * @param resolution texels per face edge
 * @returns `SIDES` texel numbers for each of 6 · resolution² texels
 */
export function neighbours(resolution: number): Int32Array {
  let table = tables.get(resolution);
  if (table === undefined) tables.set(resolution, (table = makeTable(resolution)));
  return table;
}

function makeTable(n: number): Int32Array {
  const table = new Int32Array(SIDES * 6 * n * n);
  for (let face = 0; face < 6; face++) {
    const { forward: f, right: r, up: u } = FACES[face]!;
    for (let y = 0; y < n; y++) {
      for (let x = 0; x < n; x++) {
        const texel = texelIndex(face, x, y, n);
        for (let side = 0; side < SIDES; side++) {
          // A step beyond the seam leads on along the face's plane, where the next face's outermost texel lies.
          const a = (2 * (x + (side === 0 ? 1 : side === 1 ? -1 : 0)) + 1) / n - 1;
          const b = (2 * (y + (side === 2 ? 1 : side === 3 ? -1 : 0)) + 1) / n - 1;
          table[SIDES * texel + side] = directionTexel(
            f[0] + a * r[0] + b * u[0],
            f[1] + a * r[1] + b * u[1],
            f[2] + a * r[2] + b * u[2],
            n,
          );
        }
      }
    }
  }
  return table;
}
