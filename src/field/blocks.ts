import { texelIndex } from '../cube/atlas.js';

/** Texels along a block's edge. */
const EDGE = 4;

/** Square blocks of texels: what lies side by side in the cubemap lies near by in the world. */
export interface Blocks {
  /** How many. */
  readonly count: number;
  /** All texels, block by block. */
  readonly texels: Int32Array;
  /** Where each block begins in `texels`, and where the last one ends. */
  readonly first: Int32Array;
}

const known = new Map<number, Blocks>();

/**
 * The blocks of a cubemap; made once a resolution and shared.
 *
 * @param resolution texels per face edge
 */
export function blocksOf(resolution: number): Blocks {
  let blocks = known.get(resolution);
  if (blocks === undefined) known.set(resolution, (blocks = makeBlocks(resolution)));
  return blocks;
}

function makeBlocks(n: number): Blocks {
  const along = Math.ceil(n / EDGE);
  const count = 6 * along * along;
  const texels = new Int32Array(6 * n * n);
  const first = new Int32Array(count + 1);
  let filled = 0;
  let block = 0;
  for (let face = 0; face < 6; face++) {
    for (let by = 0; by < n; by += EDGE) {
      for (let bx = 0; bx < n; bx += EDGE) {
        first[block++] = filled;
        for (let y = by; y < Math.min(n, by + EDGE); y++) {
          for (let x = bx; x < Math.min(n, bx + EDGE); x++) {
            texels[filled++] = texelIndex(face, x, y, n);
          }
        }
      }
    }
  }
  first[block] = filled;
  return { count, texels, first };
}
