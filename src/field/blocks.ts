import { texelIndex } from '../cube/atlas.js';
import { neighbours, SIDES } from './neighbours.js';

/** Texels along a block's edge. */
export const EDGE = 4;

/** Square blocks of texels: what lies side by side in the cubemap lies near by in the world. */
export interface Blocks {
  /** How many. */
  readonly count: number;
  /** All texels, block by block. */
  readonly texels: Int32Array;
  /** Where each block begins in `texels`, and where the last one ends. */
  readonly first: Int32Array;
  /** For each side of each block the block that lies beside it, or -1 where that may be several. */
  readonly beside: Int32Array;
  /** For each corner of each block the block that lies beyond it in the same face, or -1 where that ends. */
  readonly diagonal: Int32Array;
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
  const beside = findBeside(n, texels, first);
  return { count, texels, first, beside, diagonal: findDiagonal(along) };
}

/** @param along blocks along a face's edge */
function findDiagonal(along: number): Int32Array {
  const diagonal = new Int32Array(4 * 6 * along * along).fill(-1);
  for (let b = 0; b < 6 * along * along; b++) {
    const x = b % along;
    const y = Math.floor(b / along) % along;
    for (let corner = 0; corner < 4; corner++) {
      const dx = corner % 2 === 0 ? -1 : 1;
      const dy = corner < 2 ? -1 : 1;
      if (x + dx < 0 || x + dx >= along || y + dy < 0 || y + dy >= along) continue;
      diagonal[4 * b + corner] = b + dx + dy * along;
    }
  }
  return diagonal;
}

function findBeside(n: number, texels: Int32Array, first: Int32Array): Int32Array {
  const count = first.length - 1;
  const beside = new Int32Array(SIDES * count).fill(-1);
  if (n % EDGE !== 0) return beside;
  const blockOf = new Int32Array(texels.length);
  for (let b = 0; b < count; b++) {
    for (let a = first[b]!; a < first[b + 1]!; a++) blockOf[texels[a]!] = b;
  }
  const table = neighbours(n);
  for (let b = 0; b < count; b++) {
    for (let a = first[b]!; a < first[b + 1]!; a++) {
      for (let side = 0; side < SIDES; side++) {
        const other = blockOf[table[SIDES * texels[a]! + side]!]!;
        if (other !== b) beside[SIDES * b + side] = other;
      }
    }
  }
  return beside;
}
