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
  const texels: number[] = [];
  const first: number[] = [];
  const blockOf = new Int32Array(6 * n * n);
  for (let face = 0; face < 6; face++) {
    for (const [bx, by] of places(0, 0, n, EDGE, n)) {
      const block = first.length;
      first.push(texels.length);
      for (const [x, y] of places(bx, by, EDGE, 1, n)) {
        const texel = texelIndex(face, x, y, n);
        blockOf[texel] = block;
        texels.push(texel);
      }
    }
  }
  const count = first.length;
  first.push(texels.length);
  return {
    count,
    texels: Int32Array.from(texels),
    first: Int32Array.from(first),
    ...findNeighbours(n, texels, first, blockOf),
  };
}

/** The corners of a grid, row by row: every `step` texels of a square of `edge`, within `n`. */
function places(x0: number, y0: number, edge: number, step: number, n: number): [number, number][] {
  const found: [number, number][] = [];
  for (let y = y0; y < Math.min(n, y0 + edge); y += step) {
    for (let x = x0; x < Math.min(n, x0 + edge); x += step) found.push([x, y]);
  }
  return found;
}

function findNeighbours(n: number, texels: number[], first: number[], blockOf: Int32Array) {
  const count = first.length - 1;
  const beside = new Int32Array(SIDES * count).fill(-1);
  const diagonal = new Int32Array(4 * count).fill(-1);
  const table = neighbours(n);
  for (let b = 0; b < count; b++) {
    for (let a = first[b]!; a < first[b + 1]!; a++) {
      const texel = texels[a]!;
      const x = texel % n;
      const y = Math.floor(texel / n) % n;
      for (let side = 0; side < SIDES; side++) {
        const other = blockOf[table[SIDES * texel + side]!]!;
        // Else blocks of two faces may not lie edge to edge.
        if (other !== b && n % EDGE === 0) beside[SIDES * b + side] = other;
      }
      for (let corner = 0; corner < 4; corner++) {
        const dx = corner % 2 === 0 ? -1 : 1;
        const dy = corner < 2 ? -1 : 1;
        if (x + dx < 0 || x + dx >= n || y + dy < 0 || y + dy >= n) continue;
        const other = blockOf[texel + dy * n + dx]!;
        // The texel in that corner is the only one both of whose sides lead out of the block.
        const out = Math.floor((x + dx) / EDGE) !== Math.floor(x / EDGE);
        const up = Math.floor((y + dy) / EDGE) !== Math.floor(y / EDGE);
        if (out && up) diagonal[4 * b + corner] = other;
      }
    }
  }
  return { beside, diagonal };
}
