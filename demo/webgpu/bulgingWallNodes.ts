import type { Color, Material, ShaderMaterial } from 'three';
import {
  mix,
  normalize,
  positionGeometry,
  positionLocal,
  positionWorld,
  smoothstep,
  uniform,
  varying,
  vec3,
} from 'three/tsl';
import { DoubleSide, type Node, NodeMaterial } from 'three/webgpu';
import { HEIGHT, HEM, WIDTH } from '../hall/bulgingWall.js';
import { tint } from './tint.js';

/** `demo/hall/bulgingWall.ts`, in nodes. */
export function bulgingWallNodes(source: Material): NodeMaterial {
  const { time, low, high } = (source as ShaderMaterial).uniforms as Record<
    string,
    { value: unknown }
  >;
  const seconds = uniform(0).onFrameUpdate(() => time!.value as number);
  const material = new NodeMaterial();
  material.name = 'bulging wall';
  material.side = DoubleSide;
  material.fog = true;

  const { x, y } = positionGeometry;
  const hemmed = (x: Node<'float'>, half: number) => smoothstep(0, HEM, x.abs().negate().add(half));
  const hem = hemmed(x, WIDTH / 2).mul(hemmed(y.sub(HEIGHT / 2), HEIGHT / 2 + 0.6));
  const wide = x.mul(1.6).sub(seconds.mul(1.1)).sin().mul(0.3);
  const fine = y.mul(2.1).add(x.mul(1.3)).add(seconds.mul(0.9)).sin().mul(0.1);
  const bulging = hem.mul(wide.add(fine));
  material.positionNode = positionLocal.add(vec3(0, 0, bulging));

  // Lines of equal bulge, as on a map, over a colour that tells which way it goes.
  const bulge = varying(bulging).mul(14).toVar();
  const lines = bulge.fract().sub(0.5).abs();
  const ink = smoothstep(0.04, bulge.fwidth().add(0.04), lines).oneMinus();
  const [from, to] = [low, high].map((color) => tint(color!.value as Color));
  const plain = mix(from!, to!, smoothstep(-0.35, 0.35, bulge.div(14)));
  const color = mix(plain, vec3(0.98, 0.9, 0.75), ink.mul(0.45));
  // The level's own light: the sky's from above, the sun's from the south-west.
  const place = varying(positionWorld);
  const normal = place.dFdx().cross(place.dFdy()).normalize();
  const sun = normalize(vec3(-0.62, 0.68, 0.5));
  const light = normal.y.mul(0.2).add(0.55).add(normal.dot(sun).max(0).mul(0.75));
  material.colorNode = color.mul(light);
  return material;
}
