import type { Material, MeshStandardMaterial } from 'three';
import {
  mix,
  positionGeometry,
  positionLocal,
  smoothstep,
  transformNormalToView,
  uniform,
  varying,
  vec2,
  vec3,
} from 'three/tsl';
import { MeshStandardNodeMaterial, type Node, type NodeMaterial } from 'three/webgpu';
import { tint } from './tint.js';
import { DEPTH, HEM, MEAN, TRAINS, WIDTH } from '../hall/waves.js';

/** `demo/hall/waves.ts`, in nodes. */
export function wavesNodes(source: Material): NodeMaterial {
  const { color, roughness, userData } = source as MeshStandardMaterial;
  const seconds = uniform(0).onFrameUpdate(() => (userData.time as { value: number }).value);
  const material = new MeshStandardNodeMaterial({ color, roughness });
  material.name = 'waves';

  const hemmed = (x: Node<'float'>, half: number) => smoothstep(0, HEM, x.abs().negate().add(half));
  const heightAt = (place: Node<'vec2'>): Node<'float'> => {
    let sum: Node<'float'> = seconds.mul(0).add(MEAN);
    for (const [high, along, across, pace] of TRAINS) {
      const phase = place.dot(vec2(along, across)).sub(seconds.mul(pace));
      sum = sum.add(phase.sin().mul(high));
    }
    return sum.mul(hemmed(place.x, WIDTH / 2)).mul(hemmed(place.y, DEPTH / 2));
  };
  const place = positionGeometry.xz;
  const height = heightAt(place);
  material.positionNode = positionLocal.add(vec3(0, height, 0));
  const e = 0.02;
  const slope = (side: Node<'vec2'>) => heightAt(place.sub(side)).sub(heightAt(place.add(side)));
  const normal = vec3(slope(vec2(e, 0)), 2 * e, slope(vec2(0, e))).normalize();
  material.normalNode = transformNormalToView(varying(normal)).normalize();

  // Lighter toward the crests, and a thin line of foam on the highest.
  const crest = varying(height);
  const lit = mix(tint(color), vec3(0.5, 0.78, 0.8), smoothstep(0.2, 0.45, crest));
  material.colorNode = mix(lit, vec3(0.95, 0.93, 0.85), smoothstep(0.43, 0.5, crest).mul(0.35));
  return material;
}
