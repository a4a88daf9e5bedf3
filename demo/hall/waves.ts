import { Mesh, MeshStandardMaterial } from 'three';
import { cloth, hemmed } from './cloth.js';
import type { Exhibit } from './Exhibit.js';

export const [WIDTH, DEPTH] = [8.4, 7];
const CELL = 0.125;
/** Over which the waves die down to its edges, metres. */
export const HEM = 1.3;
const LIFTED = 0.012;
/** How high they lie on the whole, metres. */
export const MEAN = 0.3;
/** Trains of waves: height in metres, radians a metre along x and z, radians a second. */
export const TRAINS = [
  [0.13, 1.7, 0.5, 1.3],
  [0.07, -0.9, 2.1, 1.7],
] as const;

export interface Waves extends Exhibit {
  /** How high over the hall's floor the GPU draws them, x and z metres from their middle. */
  height(x: number, z: number, time: number): number;
}

/** Waves that only a vertex shader knows, in three's own material: `onBeforeCompile` and a uniform of time. */
export function createWaves(): Waves {
  const time = { value: 0 };
  const material = new MeshStandardMaterial({ color: '#5f93bd', roughness: 0.35 });
  material.name = 'waves';
  displace(material, time);
  material.userData.time = time;
  const mesh = new Mesh(cloth(WIDTH, DEPTH, CELL), material);
  mesh.name = 'waves';
  // Over the hall's floor, which its edges would else meet.
  mesh.position.y = LIFTED;
  mesh.receiveShadow = true;
  return {
    object: mesh,
    height(x, z, seconds) {
      const hem = hemmed(x, WIDTH / 2, HEM) * hemmed(z, DEPTH / 2, HEM);
      const sum = TRAINS.reduce(
        (sum, [high, along, across, pace]) =>
          sum + high * Math.sin(along * x + across * z - pace * seconds),
        MEAN,
      );
      return LIFTED + hem * sum;
    },
    update: (seconds) => (time.value = seconds),
  };
}

const float = (value: number) => value.toFixed(4);

/** The same as `height`, and its slope by differences, ahead of three's own vertex shader. */
const GLSL = /* glsl */ `
uniform float time;
varying float crest;

float hemmed( float x, float half_ ) {
  return smoothstep( 0.0, ${float(HEM)}, half_ - abs( x ) );
}

float waveHeight( vec2 p ) {
  float sum = ${float(MEAN)};
  ${TRAINS.map(
    ([high, along, across, pace]) =>
      `sum += ${float(high)} * sin( dot( p, vec2( ${float(along)}, ${float(across)} ) ) - ${float(pace)} * time );`,
  ).join('\n  ')}
  return sum * hemmed( p.x, ${float(WIDTH / 2)} ) * hemmed( p.y, ${float(DEPTH / 2)} );
}
`;

function displace(material: MeshStandardMaterial, time: { value: number }): void {
  material.onBeforeCompile = (shader) => {
    shader.uniforms.time = time;
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', `#include <common>\n${GLSL}`)
      .replace(
        '#include <beginnormal_vertex>',
        /* glsl */ `
        float e = 0.02;
        vec3 objectNormal = normalize( vec3(
          waveHeight( position.xz - vec2( e, 0.0 ) ) - waveHeight( position.xz + vec2( e, 0.0 ) ),
          2.0 * e,
          waveHeight( position.xz - vec2( 0.0, e ) ) - waveHeight( position.xz + vec2( 0.0, e ) ) ) );`,
      )
      .replace(
        '#include <begin_vertex>',
        /* glsl */ `
        vec3 transformed = position + vec3( 0.0, waveHeight( position.xz ), 0.0 );
        crest = transformed.y;`,
      );
    // Lighter toward the crests, and a thin line of foam on the highest.
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', '#include <common>\nvarying float crest;')
      .replace(
        '#include <color_fragment>',
        /* glsl */ `#include <color_fragment>
        diffuseColor.rgb = mix( diffuseColor.rgb, vec3( 0.5, 0.78, 0.8 ), smoothstep( 0.2, 0.45, crest ) );
        diffuseColor.rgb = mix( diffuseColor.rgb, vec3( 0.95, 0.93, 0.85 ), 0.35 * smoothstep( 0.43, 0.5, crest ) );`,
      );
  };
}
