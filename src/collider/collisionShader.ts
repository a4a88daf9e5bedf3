import {
  encodeIdsGLSL,
  encodeSurfaceGLSL,
  hasIdTexture,
  type TexelFormat,
} from '../cube/encoding.js';

/**
 * The vertex shader of both modes: three's own chain of vertex tricks, then the place seen from the centre.
 *
 * `modelViewMatrix` is composed by three in doubles with a camera at the centre, so it is M·(p, 1) - c at full
 * precision wherever the world's origin is. That is the mend of the paper's vertex equation and (9), which subtract the
 * centre before the object's matrix and so hold for pure translations only.
 */
export const collisionVertexShader = /* glsl */ `
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
uniform float near;
varying vec3 vFromCenter; // from the cubemap's centre to the surface, world axes
varying vec2 vInstance; // its number's digits to the base of 4096, rounded by the fragment shader

void main() {
  #ifdef USE_BATCHING
    int instance = int( getIndirectIndex( gl_DrawID ) );
  #else
    int instance = gl_InstanceID;
  #endif
  // Not one flat number: several drivers can have flat ones only by rewriting the geometry.
  vInstance = vec2( float( instance >> 12 ), float( instance & 4095 ) );
  #include <uv_vertex>
  #include <color_vertex>
  #include <batching_vertex>
  #include <morphinstance_vertex>
  #include <skinbase_vertex>
  #ifdef USE_DISPLACEMENTMAP
    #include <beginnormal_vertex>
    #include <morphnormal_vertex>
    #include <skinnormal_vertex>
  #endif
  #include <begin_vertex>
  #include <morphtarget_vertex>
  #include <skinning_vertex>
  #include <displacementmap_vertex>
  #include <project_vertex>
  // A vertex in the face camera's own plane has w = 0, and a rasteriser that interpolates before it clips (SwiftShader)
  // then loses the whole triangle. It is clipped at any rate: move it a little.
  if ( abs( gl_Position.w ) < 0.1 * near ) gl_Position.w = gl_Position.w < 0.0 ? - 0.1 * near : 0.1 * near;
  #include <logdepthbuf_vertex>
  #include <clipping_planes_vertex>
  vFromCenter = ( vec4( mvPosition.xyz, 0.0 ) * viewMatrix ).xyz;
}`;

/**
 * `float surfaceDistance( out vec3 normal )`: equation (9), from the centre to the surface along the texel's own ray,
 * and the geometric normal, turned toward the centre. To be called before any discard: derivatives are undefined after.
 *
 * Mend of (9): the length is taken per fragment, since lengths do not interpolate. And the interpolated place lies in
 * the triangle's plane, but a little beside the texel's ray (rasterisers snap vertices to a grid and clip large
 * triangles), which at a slant is many millimetres of distance. Meeting the plane with the ray itself gives the point
 * that the texel's direction, (14)-(16), stands for: errors of 10 mm at 3.5 m become micrometres.
 */
const FRAGMENT_HEAD = /* glsl */ `
#include <common>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
#ifdef USE_ALPHATEST
  #include <uv_pars_fragment>
  #include <color_pars_fragment>
  uniform float opacity;
  uniform float alphaTest;
  #ifdef USE_MAP
    uniform sampler2D map;
  #endif
  #ifdef USE_ALPHAMAP
    uniform sampler2D alphaMap;
  #endif
#endif
varying vec3 vFromCenter;
uniform float resolution; // texels per face edge

// What the user's alpha cuts out. Maps are read unblurred: a texel stands for one ray, and a fence's wires must not
// fade because the cubemap is small.
void cutOut() {
  #ifdef USE_ALPHATEST
    float alpha = opacity;
    #ifdef USE_MAP
      alpha *= textureLod( map, vMapUv, 0.0 ).a;
    #endif
    #ifdef USE_COLOR_ALPHA
      alpha *= vColor.a;
    #endif
    #ifdef USE_ALPHAMAP
      alpha *= textureLod( alphaMap, vAlphaMapUv, 0.0 ).g;
    #endif
    if ( alpha < alphaTest ) discard;
  #endif
}

vec3 texelDirection() { // unit, through the texel's middle, world axes
  vec2 tile = mod( gl_FragCoord.xy, resolution ) * 2.0 / resolution - 1.0;
  return normalize( ( vec4( tile, - 1.0, 0.0 ) * viewMatrix ).xyz );
}

float surfaceDistance( out vec3 normal ) {
  float distance = length( vFromCenter );
  normal = cross( dFdx( vFromCenter ), dFdy( vFromCenter ) );
  normal *= ( dot( normal, vFromCenter ) > 0.0 ? -1.0 : 1.0 ) / max( length( normal ), 1e-30 );
  if ( normal == vec3( 0.0 ) ) normal = - vFromCenter / distance;
  float slant = - dot( normal, texelDirection() );
  float height = - dot( normal, vFromCenter ); // of the centre over the plane
  // The place is less than a texel beside the ray; nearly edge-on the plane says little of the distance.
  float most = max( 0.1 * distance, fwidth( distance ) );
  return slant > 0.02 ? clamp( height / slant, distance - most, distance + most ) : distance;
}`;

/** The paper's fragment shader, (9)-(11). */
export const axisFragmentShader = /* glsl */ `
${FRAGMENT_HEAD}
uniform float rMin;
uniform float rMax;

void main() {
  vec3 normal;
  float d = surfaceDistance( normal );              // (9)
  #include <clipping_planes_fragment>
  cutOut();
  #include <logdepthbuf_fragment>
  float red = 1.0 - ( d - rMin ) / ( rMax - rMin ); // (10)
  gl_FragColor = vec4( red, 0.0, 0.0, 1.0 );        // (11); the 8-bit target clamps red to 0..1
}`;

/** Distance, geometric normal and facing of the surface, whose it is, and which instance. GLSL 3. */
export function surfaceFragmentShader(format: TexelFormat): string {
  const beside = hasIdTexture(format);
  return /* glsl */ `
layout( location = 0 ) out highp vec4 texel;
${beside ? 'layout( location = 1 ) out highp uvec2 ids;' : ''}
${FRAGMENT_HEAD}
varying vec2 vInstance;
uniform float far;
uniform float frontSign; // -1 where a material shows the inside of its triangles, 0 where it shows both sides
uniform float object; // number of the object drawn now, from 1
${encodeSurfaceGLSL(format)}
${beside ? encodeIdsGLSL : ''}

void main() {
  vec3 normal;
  float distance = surfaceDistance( normal );
  #include <clipping_planes_fragment>
  cutOut();
  if ( distance > far ) discard;
  #include <logdepthbuf_fragment>
  bool front = frontSign == 0.0 || gl_FrontFacing == ( frontSign > 0.0 );
  vec2 digits = floor( vInstance + 0.5 );
  float instance = digits.x * 4096.0 + digits.y;
  texel = encodeSurface( distance, normal, front, far, object, instance );
  ${beside ? 'ids = encodeIds( object, instance );' : ''}
}`;
}
