import { encodeSurfaceGLSL, type TexelFormat } from '../cube/encoding.js';

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
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec3 vFromCenter; // from the cubemap's centre to the surface, world axes

void main() {
  #include <batching_vertex>
  #include <morphinstance_vertex>
  #include <begin_vertex>
  #include <morphtarget_vertex>
  #include <skinbase_vertex>
  #include <skinning_vertex>
  #include <project_vertex>
  #include <logdepthbuf_vertex>
  #include <clipping_planes_vertex>
  vFromCenter = ( vec4( mvPosition.xyz, 0.0 ) * viewMatrix ).xyz;
}`;

const FRAGMENT_HEAD = /* glsl */ `
#include <common>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec3 vFromCenter;`;

/** The paper's fragment shader, (9)-(11). The length is taken per fragment: lengths do not interpolate (mend of (9)). */
export const axisFragmentShader = /* glsl */ `
${FRAGMENT_HEAD}
uniform float rMin;
uniform float rMax;

void main() {
  #include <clipping_planes_fragment>
  #include <logdepthbuf_fragment>
  float d = length( vFromCenter );                 // (9)
  float red = 1.0 - ( d - rMin ) / ( rMax - rMin ); // (10)
  gl_FragColor = vec4( red, 0.0, 0.0, 1.0 );        // (11); the 8-bit target clamps red to 0..1
}`;

/**
 * Distance, geometric normal (turned toward the centre) and facing of the surface.
 *
 * The interpolated place lies in the triangle's plane but a little beside the texel's ray (vertices snap to a grid, and
 * large triangles are clipped), which at a slant is centimetres of distance a few metres away. Meeting the plane with
 * the ray itself mends that: the point a texel stands for is then in the surface's plane.
 */
export function surfaceFragmentShader(format: TexelFormat): string {
  return /* glsl */ `
${FRAGMENT_HEAD}
uniform float far;
uniform float frontSign; // -1 where a material shows the inside of its triangles
uniform float resolution;
${encodeSurfaceGLSL(format)}

/** Unit vector through the texel's middle, world axes: (14)-(16). */
vec3 texelDirection() {
  vec2 tile = mod( gl_FragCoord.xy, resolution ) * 2.0 / resolution - 1.0;
  return normalize( ( vec4( tile, - 1.0, 0.0 ) * viewMatrix ).xyz );
}

void main() {
  // Derivatives first: after a discard they are undefined.
  vec3 normal = cross( dFdx( vFromCenter ), dFdy( vFromCenter ) );
  #include <clipping_planes_fragment>
  float distance = length( vFromCenter );
  normal *= ( dot( normal, vFromCenter ) > 0.0 ? -1.0 : 1.0 ) / max( length( normal ), 1e-30 );
  float height = - dot( normal, vFromCenter ); // of the centre over the plane
  float slant = - dot( normal, texelDirection() );
  // Nearly edge-on the plane says little of the distance.
  if ( slant > 0.02 ) distance = clamp( height / slant, 0.9 * distance, 1.1 * distance );
  if ( distance > far ) discard;
  if ( normal == vec3( 0.0 ) ) normal = - vFromCenter / distance;
  #include <logdepthbuf_fragment>
  bool front = gl_FrontFacing == ( frontSign > 0.0 );
  gl_FragColor = encodeSurface( distance, normal, front, far );
}`;
}
