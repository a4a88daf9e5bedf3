import { FACES } from './faces.js';
import { atlasIndex, texelIndex } from './atlas.js';
import { finerDirection, PLACE_BITS, PLACES } from './finerTexel.js';
import { sharedDirections } from './texelDirections.js';
import type { SurfaceField } from '../field/SurfaceField.js';

/**
 * How a surface texel is stored, best first.
 *
 * | format  | distance        | normal (octahedral) | back face        | object          | instance      | a miss  |
 * | ------- | --------------- | ------------------- | ---------------- | --------------- | ------------- | ------- |
 * | RGBA32F | 32-bit float    | 12 + 12 bits        | sign of B        | abs(B) - 1, 16  | A, 24 bits    | R = 0   |
 * | RGBA16F | 22 bits of far  | 11 + 11 bits        | sign of R        | beside, 16 bits | beside, 24    | R = 0   |
 * | RGBA8   | 15 bits of far  | 8 + 8 bits          | highest bit of R | beside, 16 bits | beside, 24    | R,G = 0 |
 *
 * "Beside" is a second texture, RG32UI (`encodeIdsGLSL`), which every WebGL 2 draws and reads. Objects past the 65,535th
 * read as 0, unknown. Drawn finer (`supersample`), a texel also holds its place
 * in the block it was the nearest of: see `keepPlaceGLSL`. Every grid of the normal has a middle, so the six axes
 * (floors, walls) come back exact.
 */
export type TexelFormat = 'RGBA32F' | 'RGBA16F' | 'RGBA8';

export const TEXEL_FORMATS: readonly TexelFormat[] = ['RGBA32F', 'RGBA16F', 'RGBA8'];

/** Whether objects' and instances' numbers need a texture of their own. */
export function hasIdTexture(format: TexelFormat): boolean {
  return format !== 'RGBA32F';
}

/** Steps of one octahedral coordinate, always even so that 0 is one of them. */
export const NORMAL_STEPS = { RGBA32F: 4094, RGBA16F: 2046, RGBA8: 254 } as const;
/** Steps of the distance in RGBA8: 15 bits, of which 0 means "nothing seen". */
const BYTE_STEPS = 32766;
/** RGBA16F writes the distance as two integers below this; a half float holds them exactly. */
const HALF_DIGIT = 2048;
const HALF_STEPS = HALF_DIGIT * HALF_DIGIT - 1;
/** Largest number of an object. */
const MAX_OBJECT = 0xffff;

const OCTAHEDRAL_GLSL = /* glsl */ `
vec2 octahedral( vec3 n ) {
  n /= abs( n.x ) + abs( n.y ) + abs( n.z );
  vec2 folded = ( 1.0 - abs( n.yx ) ) * vec2( n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0 );
  return n.z < 0.0 ? folded : n.xy;
}`;

/**
 * GLSL `vec4 encodeSurface( float distance, vec3 normal, bool front, float far, float object, float instance )`: the
 * texel for a surface at 0 < `distance` <= `far` with a unit `normal` in world axes. Formats with a texture for ids pass
 * over `object` and `instance`.
 */
export function encodeSurfaceGLSL(format: TexelFormat): string {
  const steps = NORMAL_STEPS[format].toFixed(1);
  const body = {
    RGBA32F: /* glsl */ `
  vec2 o = floor( ( octahedral( normal ) * 0.5 + 0.5 ) * ${steps} + 0.5 );
  return vec4( distance, o.x * 4096.0 + o.y, ( front ? 1.0 : -1.0 ) * ( 1.0 + object ), instance );`,
    RGBA16F: /* glsl */ `
  vec2 o = floor( octahedral( normal ) * ${steps} * 0.5 + 0.5 );
  float code = floor( min( distance / far, 1.0 ) * ${HALF_STEPS.toFixed(1)} + 0.5 );
  float high = floor( code / ${HALF_DIGIT.toFixed(1)} );
  return vec4( ( front ? 1.0 : -1.0 ) * ( high + 1.0 ), code - high * ${HALF_DIGIT.toFixed(1)}, o );`,
    RGBA8: /* glsl */ `
  vec2 o = floor( ( octahedral( normal ) * 0.5 + 0.5 ) * ${steps} + 0.5 );
  float code = 1.0 + floor( min( distance / far, 1.0 ) * ${BYTE_STEPS.toFixed(1)} + 0.5 );
  float high = floor( code / 256.0 );
  return vec4( high + ( front ? 0.0 : 128.0 ), code - high * 256.0, o ) / 255.0;`,
  }[format];
  return `${OCTAHEDRAL_GLSL}
vec4 encodeSurface( float distance, vec3 normal, bool front, float far, float object, float instance ) {${body}
}`;
}

/** GLSL `uvec2 encodeIds( float object, float instance )`: both as they are. `keepPlaceGLSL` uses the room above. */
export const encodeIdsGLSL = /* glsl */ `
uvec2 encodeIds( float object, float instance ) {
  return uvec2( object, instance );
}`;

/** GLSL `float decodeDistance( vec4 texel, float far )`: metres, 0 for a miss. For pictures; fields decode on the CPU. */
export function decodeDistanceGLSL(format: TexelFormat): string {
  const body = {
    RGBA32F: `return texel.r;`,
    RGBA16F: /* glsl */ `
  if ( texel.r == 0.0 ) return 0.0;
  return ( ( abs( texel.r ) - 1.0 ) * ${HALF_DIGIT.toFixed(1)} + texel.g ) / ${HALF_STEPS.toFixed(1)} * far;`,
    RGBA8: /* glsl */ `
  vec2 bytes = floor( texel.rg * 255.0 + 0.5 );
  float code = mod( bytes.x, 128.0 ) * 256.0 + bytes.y;
  return code == 0.0 ? 0.0 : max( ( code - 1.0 ) / ${BYTE_STEPS.toFixed(1)} * far, 1e-6 );`,
  }[format];
  return `float decodeDistance( vec4 texel, float far ) {${body}
}`;
}

/**
 * Decodes an atlas, read bottom row first, into `field`: its texels. What the draw was (centre, time, serial, reach,
 * objects) is the caller's to set, the reach before. Allocates nothing.
 *
 * @param data 4 numbers a texel: floats for the float formats, bytes for RGBA8
 * @param ids 4 numbers a texel, of formats with a texture for them; without it whose a texel was is not known
 * @param supersample above 1 each texel holds the place of a finer one, and the field's directions are written too: they
 *   must be its own
 */
export function decodeSurface(
  format: TexelFormat,
  data: Float32Array | Uint8Array,
  field: SurfaceField,
  ids: Uint32Array | null = null,
  supersample = 1,
): void {
  const { resolution, far, direction, distance, normal, front, object, instance } = field;
  const steps = NORMAL_STEPS[format];
  const middles = sharedDirections(resolution);
  for (let face = 0; face < FACES.length; face++) {
    for (let y = 0; y < resolution; y++) {
      let from = 4 * atlasIndex(face, 0, y, resolution);
      let to = texelIndex(face, 0, y, resolution);
      for (let x = 0; x < resolution; x++, from += 4, to++) {
        let d: number;
        let ox = 0;
        let oy = 0;
        let isFront = false;
        let seen = 0;
        let which = 0;
        let place = 0;
        if (format === 'RGBA32F') {
          d = data[from]!;
          if (d > 0) {
            const packed = data[from + 1]!;
            const high = Math.floor(packed / 4096);
            ox = (2 * high) / steps - 1;
            oy = (2 * (packed - 4096 * high)) / steps - 1;
            const side = data[from + 2]!;
            isFront = side > 0;
            seen = Math.abs(side);
            if (supersample > 1) {
              place = seen & (PLACES - 1);
              seen = seen >> PLACE_BITS;
            }
            seen -= 1;
            which = data[from + 3]!;
          }
        } else if (format === 'RGBA16F') {
          const high = data[from]!;
          isFront = high > 0;
          d =
            high === 0
              ? 0
              : (((Math.abs(high) - 1) * HALF_DIGIT + data[from + 1]!) / HALF_STEPS) * far;
          ox = (2 * data[from + 2]!) / steps;
          oy = (2 * data[from + 3]!) / steps;
        } else {
          const high = data[from]!;
          isFront = high < 128;
          const code = (high & 127) * 256 + data[from + 1]!;
          d = code === 0 ? 0 : Math.max(((code - 1) / BYTE_STEPS) * far, 1e-6);
          ox = (2 * data[from + 2]!) / steps - 1;
          oy = (2 * data[from + 3]!) / steps - 1;
        }
        if (!(d > 0)) {
          // Of the sky most was sky before: then all the rest is as it should be.
          if (distance[to] === Infinity) continue;
          distance[to] = Infinity;
          front[to] = object[to] = instance[to] = 0;
          normal[3 * to] = normal[3 * to + 1] = normal[3 * to + 2] = 0;
          if (supersample > 1) {
            for (let v = 3 * to; v < 3 * to + 3; v++) direction[v] = middles[v]!;
          }
          continue;
        }
        distance[to] = d;
        front[to] = isFront ? 1 : 0;
        if (ids !== null) {
          seen = ids[from]!;
          const low = ids[from + 1]!;
          which = low & 0xffffff;
          place = low >>> 24;
        }
        object[to] = seen <= MAX_OBJECT ? seen : 0;
        instance[to] = which;
        if (supersample > 1) {
          finerDirection(face, x, y, place, resolution, supersample, direction, 3 * to);
        }
        const nz = 1 - Math.abs(ox) - Math.abs(oy);
        const fold = nz < 0 ? -nz : 0;
        const nx = ox + (ox >= 0 ? -fold : fold);
        const ny = oy + (oy >= 0 ? -fold : fold);
        const inverse = 1 / Math.sqrt(nx * nx + ny * ny + nz * nz);
        normal[3 * to] = nx * inverse;
        normal[3 * to + 1] = ny * inverse;
        normal[3 * to + 2] = nz * inverse;
      }
    }
  }
}
