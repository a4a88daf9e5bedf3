import {
  Color,
  DoubleSide,
  Group,
  Mesh,
  PlaneGeometry,
  ShaderMaterial,
  UniformsLib,
  UniformsUtils,
} from 'three';
import { assemble, merge, type Materials, slab } from '../pieces.js';
import { hemmed } from './cloth.js';
import type { Exhibit } from './Exhibit.js';

export const [WIDTH, HEIGHT] = [6.4, 3];
/** Over which the bulges die down to the frame, metres. */
export const HEM = 1.1;

export interface BulgingWall extends Exhibit {
  readonly sheet: Mesh;
  /** How far south of its frame the GPU draws it, x and y metres from the middle of its foot. */
  bulge(x: number, y: number, time: number): number;
}

/** A sheet in a frame that breathes by a shader of its own. */
export function createBulgingWall(material: Materials): BulgingWall {
  const sheet = new ShaderMaterial({
    name: 'bulging wall',
    uniforms: {
      ...UniformsUtils.clone(UniformsLib.fog),
      time: { value: 0 },
      low: { value: new Color('#7d5a78') },
      high: { value: new Color('#e8b95a') },
    },
    vertexShader,
    fragmentShader,
    side: DoubleSide,
    fog: true,
  });
  const mesh = new Mesh(
    new PlaneGeometry(WIDTH, HEIGHT, 64, 30).translate(0, HEIGHT / 2, 0),
    sheet,
  );
  mesh.name = 'bulging wall';

  const half = WIDTH / 2 + 0.22;
  const pillar = (x: number) => slab(0.5, HEIGHT + 0.4, 0.7, x).translate(0, HEIGHT + 0.3, 0);
  const frame = assemble('wall frame', [
    [merge(pillar(-half), pillar(half)), material('stone')],
    [slab(WIDTH + 1.1, 0.3, 0.5, 0).translate(0, HEIGHT + 0.3, 0), material('plaster')],
    [slab(WIDTH + 1.4, 0.14, 0.9, 0).translate(0, HEIGHT + 0.43, 0), material('tile')],
  ]);
  const wall = new Group();
  wall.name = 'wall';
  wall.add(mesh, frame);
  return {
    object: wall,
    sheet: mesh,
    bulge(x, y, time) {
      const hem = hemmed(x, WIDTH / 2, HEM) * hemmed(y - HEIGHT / 2, HEIGHT / 2 + 0.6, HEM);
      return (
        hem *
        (0.3 * Math.sin(1.6 * x - 1.1 * time) + 0.1 * Math.sin(2.1 * y + 1.3 * x + 0.9 * time))
      );
    },
    update: (time) => (sheet.uniforms.time!.value = time),
  };
}

const vertexShader = /* glsl */ `
uniform float time;
varying vec3 place;
varying float bulging;
#include <fog_pars_vertex>

float hemmed( float x, float half_ ) {
  return smoothstep( 0.0, ${HEM.toFixed(2)}, half_ - abs( x ) );
}

void main() {
  float hem = hemmed( position.x, ${(WIDTH / 2).toFixed(2)} ) *
    hemmed( position.y - ${(HEIGHT / 2).toFixed(2)}, ${(HEIGHT / 2 + 0.6).toFixed(2)} );
  bulging = hem * ( 0.3 * sin( 1.6 * position.x - 1.1 * time ) +
    0.1 * sin( 2.1 * position.y + 1.3 * position.x + 0.9 * time ) );
  vec4 at = modelMatrix * vec4( position + vec3( 0.0, 0.0, bulging ), 1.0 );
  place = at.xyz;
  vec4 mvPosition = viewMatrix * at;
  gl_Position = projectionMatrix * mvPosition;
  #include <fog_vertex>
}`;

const fragmentShader = /* glsl */ `
uniform float time;
uniform vec3 low;
uniform vec3 high;
varying vec3 place;
varying float bulging;
#include <common>
#include <fog_pars_fragment>

void main() {
  // Lines of equal bulge, as on a map, over a colour that tells which way it goes.
  float lines = abs( fract( 14.0 * bulging ) - 0.5 );
  float width = fwidth( 14.0 * bulging );
  float ink = 1.0 - smoothstep( 0.04, 0.04 + width, lines );
  vec3 color = mix( low, high, smoothstep( - 0.35, 0.35, bulging ) );
  color = mix( color, vec3( 0.98, 0.9, 0.75 ), 0.45 * ink );

  // The level's own light: the sky's from above, the sun's from the south-west.
  vec3 normal = normalize( cross( dFdx( place ), dFdy( place ) ) );
  vec3 sun = normalize( vec3( -0.62, 0.68, 0.5 ) );
  float light = 0.55 + 0.2 * normal.y + 0.75 * max( 0.0, dot( normal, sun ) );
  gl_FragColor = vec4( color * light, 1.0 );
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  #include <fog_fragment>
}`;
