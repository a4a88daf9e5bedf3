/** Tiles of the atlas in a row; two rows hold the six faces. */
export const ATLAS_COLUMNS = 3;
export const ATLAS_ROWS = 2;

/**
 * Width and height in texels of an atlas with faces of `resolution`² texels.
 *
 * @param cubemaps how many, one above the other: each is a run of texels of its own
 */
export function atlasSize(resolution: number, cubemaps = 1): { width: number; height: number } {
  return { width: ATLAS_COLUMNS * resolution, height: cubemaps * ATLAS_ROWS * resolution };
}

/** Column and row of a face's tile, counted from the bottom left as GL does. */
export function tileOf(face: number): { column: number; row: number } {
  return { column: face % ATLAS_COLUMNS, row: Math.floor(face / ATLAS_COLUMNS) };
}

/**
 * A texel's number: face by face, row by row from the bottom. Fields, directions and every array of texels use this
 * order; only the decoder knows the atlas's.
 */
export function texelIndex(face: number, x: number, y: number, resolution: number): number {
  return (face * resolution + y) * resolution + x;
}

/** Where texel `x`, `y` of `face` lies in the atlas read bottom row first (multiply by 4 for RGBA). */
export function atlasIndex(face: number, x: number, y: number, resolution: number): number {
  const column = face % ATLAS_COLUMNS;
  const row = (face - column) / ATLAS_COLUMNS;
  return (row * resolution + y) * ATLAS_COLUMNS * resolution + column * resolution + x;
}
