import { ATLAS_COLUMNS } from '../cube/atlas.js';
import { decodeDistanceGLSL, type TexelFormat } from '../cube/encoding.js';
import { UNFOLDED } from './unfold.js';
import { VIRIDIS } from './viridis.js';

export const unfoldVertexShader = /* glsl */ `
varying vec2 vUv;

void main() {
  vUv = position.xy * 0.5 + 0.5;
  gl_Position = vec4( position.xy, 0.0, 1.0 );
}`;

/**
 * Draws the panel, the six faces and the strip of colours. `nearness` is 1 at the near end of the scale, 0 at the far
 * one, negative for a miss. The colours are viridis, near bright and far dark.
 */
export function unfoldFragmentShader(output: 'surface' | 'axis', format: TexelFormat): string {
  const cells = UNFOLDED.map(([column, row]) => `ivec2( ${column}, ${row} )`).join(', ');
  const horner = [...VIRIDIS]
    .reverse()
    .map((each) => `  color = color * t + vec3( ${each.join(', ')} );`)
    .join('\n');
  const nearness =
    output === 'axis'
      ? 'return texel.r > 0.0 ? texel.r : -1.0;'
      : 'float d = decodeDistance( texel, far ); return d > 0.0 ? 1.0 - d / far : -1.0;';
  return /* glsl */ `
uniform sampler2D atlas;
uniform sampler2D labels;
uniform vec2 size;
uniform float padding;
uniform float cell;
uniform vec4 ramp;
uniform float far;
uniform int resolution;
uniform vec3 winners[ 6 ];
varying vec2 vUv;

const ivec2 cells[ 6 ] = ivec2[ 6 ]( ${cells} );
const vec3 PANEL = vec3( 0.043, 0.059, 0.082 );
${decodeDistanceGLSL(format)}

float nearness( vec4 texel ) {
  ${nearness}
}

vec3 viridis( float t ) {
  vec3 color = vec3( 0.0 );
${horner}
  return color;
}

/** Of a rounded box around the picture, positive outside. */
float boxDistance( vec2 p, float radius ) {
  vec2 q = abs( p - 0.5 * size ) - 0.5 * size + radius;
  return length( max( q, 0.0 ) ) + min( max( q.x, q.y ), 0.0 ) - radius;
}

void main() {
  vec2 p = vUv * size;
  vec4 color = vec4( PANEL, 0.84 );
  float pixel = fwidth( p.x );

  vec2 place = ( p - padding ) / cell;
  for ( int face = 0; face < 6; face ++ ) {
    vec2 uv = place - vec2( cells[ face ] );
    if ( any( lessThan( uv, vec2( 0.0 ) ) ) || any( greaterThanEqual( uv, vec2( 1.0 ) ) ) ) continue;
    ivec2 tile = ivec2( face % ${ATLAS_COLUMNS}, face / ${ATLAS_COLUMNS} ) * resolution;
    float t = nearness( texelFetch( atlas, tile + ivec2( uv * float( resolution ) ), 0 ) );
    color = t < 0.0 ? vec4( PANEL * 0.5, 0.86 ) : vec4( viridis( clamp( t, 0.0, 1.0 ) ), 1.0 );
  }

  // The winners: a bright ring with a dark rim, on any colour.
  for ( int face = 0; face < 6; face ++ ) {
    if ( winners[ face ].z <= 0.0 ) continue;
    vec2 middle = padding + cell * ( vec2( cells[ face ] ) + ( winners[ face ].xy + 0.5 ) / float( resolution ) );
    float away = abs( distance( p, middle ) - 0.085 * cell );
    color = mix( color, vec4( PANEL, 1.0 ), 0.8 * ( 1.0 - smoothstep( 1.5, 1.5 + pixel, away ) ) );
    color = mix( color, vec4( 1.0 ), 1.0 - smoothstep( 0.6, 0.6 + pixel, away ) );
  }

  vec2 strip = ( p - ramp.xy ) / ramp.zw;
  if ( all( greaterThanEqual( strip, vec2( 0.0 ) ) ) && all( lessThan( strip, vec2( 1.0 ) ) ) ) {
    color = vec4( viridis( 1.0 - strip.x ), 1.0 );
  }

  vec4 label = texture2D( labels, vUv ); // premultiplied
  color.rgb = color.rgb * ( 1.0 - label.a ) + label.rgb;
  color.a = max( color.a, label.a );

  float edge = boxDistance( p, 8.0 );
  color.rgb += 0.16 * ( 1.0 - smoothstep( 0.0, pixel, abs( edge + 0.5 ) - 0.5 ) );
  color.a *= 1.0 - smoothstep( -pixel, 0.0, edge );
  gl_FragColor = color;
}`;
}
