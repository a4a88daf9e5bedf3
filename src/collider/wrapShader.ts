import {
  encodeIdsGLSL,
  encodeSurfaceGLSL,
  hasIdTexture,
  type TexelFormat,
} from '../cube/encoding.js';
import { FACES } from '../cube/faces.js';

/** A program's texts, as three hands them to `onBeforeCompile`. */
export interface ShaderTexts {
  vertexShader: string;
  fragmentShader: string;
}

export interface WrapOptions {
  readonly output: 'surface' | 'axis';
  readonly format: TexelFormat;
  /** Written in GLSL ES 3: it declares what it puts out. */
  readonly glsl3: boolean;
  /** A `RawShaderMaterial`: three puts nothing before it. */
  readonly raw: boolean;
}

/** For `RawShaderMaterial`s in GLSL ES 1, as three does it for `ShaderMaterial`s. */
const FROM_GLSL1 = `
#define texture2D texture
#define textureCube texture
#define texture2DProj textureProj
#define texture2DLodEXT textureLod
#define texture2DProjLodEXT textureProjLod
#define textureCubeLodEXT textureLod
#define texture2DGradEXT textureGrad
#define texture2DProjGradEXT textureProjGrad
#define textureCubeGradEXT textureGrad`;

/** Names within our own parts that a user's macro may have taken. */
const NAMES = [
  'distance', 'normal', 'front', 'far', 'object', 'instance', 'o', 'n', 'folded', 'code', 'high', 'known', 'place',
  'low', 'middle', 'octahedral', 'encodeSurface', 'encodeIds',
]; // prettier-ignore

/** The functions of ours that the user may have as well. */
const FUNCTIONS = ['octahedral', 'encodeSurface', 'encodeIds'];

const ownNames = [
  ...NAMES.map((name) => `#undef ${name}`),
  ...FUNCTIONS.map((name) => `#define ${name} cc_${name}`),
].join('\n');

const vector = (v: readonly number[]) => `vec3( ${v.map((x) => x.toFixed(1)).join(', ')} )`;

/** From a face camera's axes to the world's. */
const FACE_AXES = FACES.map(
  ({ right, up, forward }) =>
    `mat3( ${vector(right)}, ${vector(up)}, ${vector(forward.map((x) => -x))} )`,
).join(',\n  ');

/**
 * Puts the user's shaders into ours: their `main` is renamed and called, so every trick of their vertices and every
 * `discard` counts, and what they put out is put aside for distance, normal, facing and numbers. All names of ours begin
 * with `cc_`. What it cannot make sense of does not compile, and is told then.
 *
 * The place comes from `gl_Position`: the face cameras' projections are of 90° and square, so its x, y and w are
 * the place itself in the camera's axes, however the user came by it.
 */
export function wrapShader(texts: ShaderTexts, options: WrapOptions): ShaderTexts {
  return {
    vertexShader: wrapVertex(texts.vertexShader, options),
    fragmentShader: wrapFragment(texts.fragmentShader, options),
  };
}

function wrapVertex(text: string, { raw, glsl3 }: WrapOptions): string {
  const old = raw && !glsl3;
  const { extensions, body } = hoistExtensions(text, raw, old);
  return /* glsl */ `${extensions}
${old ? `#define attribute in\n#define varying out${FROM_GLSL1}` : ''}
#define main cc_main
${body}
#undef main
precision highp float;
precision highp int;
uniform float cc_near;
out highp vec3 cc_view; // from the cubemap's centre, the face camera's axes
out highp vec2 cc_instance; // as in the plain shader

void main() {
  cc_main();
  cc_view = vec3( gl_Position.xy, - gl_Position.w );
  #ifdef USE_BATCHING
    int cc_number = int( getIndirectIndex( gl_DrawID ) );
  #else
    int cc_number = gl_InstanceID;
  #endif
  cc_instance = vec2( float( cc_number >> 12 ), float( cc_number & 4095 ) );
  // As in the plain shader: a vertex in the camera's own plane.
  if ( abs( gl_Position.w ) < 0.1 * cc_near ) gl_Position.w = gl_Position.w < 0.0 ? - 0.1 * cc_near : 0.1 * cc_near;
}`;
}

function wrapFragment(text: string, options: WrapOptions): string {
  const { output, format, raw, glsl3 } = options;
  const old = raw && !glsl3;
  const { extensions, body } = hoistExtensions(text, raw, old);
  const { source, color } = putOutputsAside(body, glsl3);
  const depth = /\bgl_FragDepth(EXT)?\b/.test(source);
  const axis = output === 'axis';
  const beside = !axis && hasIdTexture(format);
  return /* glsl */ `${extensions}
${old ? `#define varying in${FROM_GLSL1}` : ''}
${glsl3 ? '' : '#define gl_FragColor cc_color\nhighp vec4 cc_color;'}
${depth ? 'highp float cc_depth = - 1.0;' : ''}
#define main cc_main
${source.replace(/\bgl_FragDepth(EXT)?\b/g, 'cc_depth')}
#undef main
${ownNames}
precision highp float;
precision highp int;
layout( location = 0 ) out highp vec4 cc_texel;
${beside ? 'layout( location = 1 ) out highp uvec2 cc_ids;' : ''}
in highp vec3 cc_view;
in highp vec2 cc_instance;
uniform float cc_near;
uniform float cc_far;
uniform float cc_resolution;
uniform float cc_frontSign;
uniform float cc_object;
uniform float cc_alphaCut;
${axis ? 'uniform float cc_rMin;\nuniform float cc_rMax;' : encodeSurfaceGLSL(format)}
${beside ? encodeIdsGLSL : ''}
const mat3 cc_axes[ 6 ] = mat3[ 6 ](
  ${FACE_AXES}
);
${depth ? WRITTEN_DEPTH : ''}

void main() {
  // Before the user's main: derivatives are undefined after a discard.
  vec2 cc_tile = floor( gl_FragCoord.xy / cc_resolution );
  vec3 cc_ray = normalize( vec3( ( gl_FragCoord.xy - cc_tile * cc_resolution ) * 2.0 / cc_resolution - 1.0, - 1.0 ) );
  float cc_distance = length( cc_view );
  vec3 cc_normal = cross( dFdx( cc_view ), dFdy( cc_view ) );
  cc_normal *= ( dot( cc_normal, cc_view ) > 0.0 ? - 1.0 : 1.0 ) / max( length( cc_normal ), 1e-30 );
  if ( cc_normal == vec3( 0.0 ) ) cc_normal = - cc_view / cc_distance;
  // The point in the plane, as in the plain shader.
  float cc_slant = - dot( cc_normal, cc_ray );
  float cc_height = - dot( cc_normal, cc_view );
  float cc_most = max( 0.1 * cc_distance, fwidth( cc_distance ) );
  if ( cc_slant > 0.02 ) cc_distance = clamp( cc_height / cc_slant, cc_distance - cc_most, cc_distance + cc_most );
  #ifndef USE_REVERSED_DEPTH_BUFFER
    // A sky drawn at the end of what is seen is nowhere.
    if ( gl_FragCoord.z >= 1.0 ) discard;
  #endif
  cc_main();
  ${color === null ? '' : `if ( cc_alphaCut > 0.0 && ${color}.a < cc_alphaCut ) discard;`}
  ${depth ? USE_WRITTEN_DEPTH : ''}
  ${
    axis
      ? 'cc_texel = vec4( 1.0 - ( cc_distance - cc_rMin ) / ( cc_rMax - cc_rMin ), 0.0, 0.0, 1.0 );'
      : `if ( ! ( cc_distance <= cc_far ) ) discard;
  bool cc_front = cc_frontSign == 0.0 || gl_FrontFacing == ( cc_frontSign > 0.0 );
  vec2 cc_digits = floor( cc_instance + 0.5 );
  float cc_number = cc_digits.x * 4096.0 + cc_digits.y;
  cc_normal = cc_axes[ int( cc_tile.x ) + 3 * int( cc_tile.y ) ] * cc_normal;
  cc_texel = encodeSurface( cc_distance, cc_normal, cc_front, cc_far, cc_object, cc_number );
  ${beside ? 'cc_ids = encodeIds( cc_object, cc_number );' : ''}`
  }
}`;
}

/** Along the face camera's axis, metres, of a depth that the user's shader wrote. */
const WRITTEN_DEPTH = /* glsl */ `
float cc_axisDepth( float depth ) {
  #if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
    return exp2( depth * log2( cc_far + 1.0 ) ) - 1.0;
  #elif defined( USE_REVERSED_DEPTH_BUFFER )
    return cc_near * cc_far / ( depth * ( cc_far - cc_near ) + cc_near );
  #else
    return cc_near * cc_far / ( cc_far - depth * ( cc_far - cc_near ) );
  #endif
}`;

const USE_WRITTEN_DEPTH = /* glsl */ `
  if ( cc_depth >= 0.0 ) {
    if ( cc_depth > 1.0 ) discard;
    vec3 cc_point = cc_ray * ( cc_axisDepth( cc_depth ) / - cc_ray.z );
    cc_distance = length( cc_point );
    cc_normal = cross( dFdx( cc_point ), dFdy( cc_point ) );
    cc_normal *= ( dot( cc_normal, cc_point ) > 0.0 ? - 1.0 : 1.0 ) / max( length( cc_normal ), 1e-30 );
    if ( ! ( abs( length( cc_normal ) - 1.0 ) < 0.01 ) ) cc_normal = - cc_ray;
    gl_FragDepth = cc_depth;
  } else {
    gl_FragDepth = gl_FragCoord.z;
  }`;

/** `#extension` must come first in a raw shader; those of GLSL ES 1 are built into GLSL ES 3. */
function hoistExtensions(text: string, raw: boolean, old: boolean) {
  if (!raw) return { extensions: '', body: text };
  const extensions: string[] = [];
  const body = text.replace(/^[ \t]*#[ \t]*extension\b.*$/gm, (line) => {
    if (!old) extensions.push(line);
    return '';
  });
  return { extensions: extensions.join('\n'), body };
}

/** Makes plain variables of what a shader puts out. `color` is the first, null where it has no alpha. */
function putOutputsAside(text: string, glsl3: boolean): { source: string; color: string | null } {
  if (!glsl3) {
    return {
      source: text.replace(/\bgl_FragData\s*\[\s*0\s*\]/g, 'gl_FragColor'),
      color: 'cc_color',
    };
  }
  let color: string | null | undefined;
  const bare = text.replace(/\/\*[\s\S]*?\*\/|\/\/.*$/gm, ' ');
  const source = bare.replace(
    /(?:layout\s*\([^)]*\)\s*)?\bout\s+((?:(?:lowp|mediump|highp)\s+)?(float|int|uint|[iu]?vec[234])\s+(\w+)[^;(){}]*);/g,
    (_, declaration: string, type: string, name: string) => {
      if (color === undefined) color = type === 'vec4' ? name : null;
      return `${declaration};`;
    },
  );
  return { source, color: color ?? null };
}

/** Shaders that draw nothing, in place of what cannot be wrapped. WebGL wants every output written somewhere. */
export const NOTHING: ShaderTexts = {
  vertexShader: 'void main() { gl_Position = vec4( 0.0, 0.0, 2.0, 1.0 ); }',
  fragmentShader: /* glsl */ `
layout( location = 0 ) out highp vec4 cc_texel;
layout( location = 1 ) out highp uvec2 cc_ids;
void main() {
  cc_texel = vec4( 0.0 );
  cc_ids = uvec2( 0u );
  discard;
}`,
};
