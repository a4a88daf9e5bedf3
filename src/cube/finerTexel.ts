import type { TexelFormat } from './encoding.js';
import { texelDirection } from './texelDirections.js';

/** Bits that hold a place in a block: 2 for its column and 2 for its row, also of a block of 2×2. */
export const PLACE_BITS = 4;
export const PLACES = 1 << PLACE_BITS;
const SIDE = 4;

/**
 * GLSL `void keepPlace( inout vec4 texel, inout uvec2 ids, ivec2 place )`: writes into a texel where in its block of finer
 * ones it lay, 0 to 3 each way. `encodeSurfaceGLSL` and `encodeIdsGLSL` leave room for it:
 *
 * - RGBA32F: B, whose sign is the facing and whose amount is 1 + the object's number, times 16, plus the place.
 * - Formats with ids beside: the byte above the 24 bits of the instance's number.
 */
export function keepPlaceGLSL(format: TexelFormat): string {
  const body =
    format === 'RGBA32F'
      ? /* glsl */ `
  float amount = min( abs( texel.b ), 65537.0 ) * ${PLACES.toFixed(1)} + code;
  texel.b = texel.b < 0.0 ? - amount : amount;`
      : /* glsl */ `
  ids.g += uint( code ) << 24;`;
  return `void keepPlace( inout vec4 texel, inout uvec2 ids, ivec2 place ) {
  float code = float( place.x + ${SIDE} * place.y );${body}
}`;
}

/**
 * The unit vector through the middle of a finer texel, world axes: of one in the block that makes up texel (x, y).
 *
 * @param place column + 4 · row in the block
 * @param resolution texels per face edge, not the finer ones
 * @param supersample finer texels along a block's edge
 * @param target written at `offset`, `offset + 1`, `offset + 2`
 */
export function finerDirection(
  face: number,
  x: number,
  y: number,
  place: number,
  resolution: number,
  supersample: number,
  target: Float32Array,
  offset: number,
): void {
  const column = place & (SIDE - 1);
  const row = place >> 2;
  const fine = resolution * supersample;
  texelDirection(face, x * supersample + column, y * supersample + row, fine, target, offset);
}
