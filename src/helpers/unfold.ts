import { FACE } from '../cube/faces.js';

/**
 * Where each face lies in the unfolded cube, column and row from the bottom left of 4×3 cells, in the faces' order:
 *
 *        +Y
 *     -X -Z +X +Z
 *        -Y
 *
 * It is the cube seen from inside, opened around -Z. The axes of `FACES` run on over all five inner joins (-X|-Z, -Z|+X,
 * +X|+Z, +Y over -Z, -Y under -Z) and from +Z around to -X, so no face is turned or mirrored.
 */
export const UNFOLDED: readonly (readonly [column: number, row: number])[] = (() => {
  const cells: [number, number][] = [];
  cells[FACE.NX] = [0, 1];
  cells[FACE.NZ] = [1, 1];
  cells[FACE.PX] = [2, 1];
  cells[FACE.PZ] = [3, 1];
  cells[FACE.PY] = [1, 2];
  cells[FACE.NY] = [1, 0];
  return cells;
})();

export const UNFOLDED_COLUMNS = 4;
export const UNFOLDED_ROWS = 3;

/** Sizes of the picture, CSS pixels from its bottom left; shared by the shader and the labels. */
export interface Layout {
  width: number;
  height: number;
  padding: number;
  /** Edge of one face. */
  cell: number;
  /** The strip of colours from near to far: x, y, width, height. */
  ramp: readonly [number, number, number, number];
}

/** @param width of the whole picture, CSS pixels */
export function layOut(width: number): Layout {
  // Whole pixels, so that frames lie on the edges of faces.
  const cell = Math.floor((0.92 * width) / UNFOLDED_COLUMNS);
  const padding = (width - UNFOLDED_COLUMNS * cell) / 2;
  const height = 2 * padding + UNFOLDED_ROWS * cell;
  // Bottom right, where the cross leaves two cells empty.
  const left = padding + 2 * cell + 0.24 * cell;
  const ramp = [
    left,
    padding + 0.3 * cell,
    width - padding - left,
    Math.max(4, 0.1 * cell),
  ] as const;
  return { width, height, padding, cell, ramp };
}
