import type { Color, Material, ShaderMaterial, Texture, Vector3 } from 'three';
import {
  cameraProjectionMatrix,
  cameraViewMatrix,
  float,
  mix,
  positionLocal,
  smoothstep,
  texture,
  uniform,
  varying,
  vec3,
  vec4,
} from 'three/tsl';
import { BackSide, NodeMaterial } from 'three/webgpu';
import { tint } from './tint.js';

/** `demo/sky.ts`, in nodes. */
export function skyNodes(source: Material): NodeMaterial {
  const { sun, horizon, zenith, glow, clouds } = (source as ShaderMaterial).uniforms as Record<
    string,
    { value: unknown }
  >;
  const toward = uniform(sun!.value as Vector3);
  const [low, high, around] = [horizon, zenith, glow].map((color) => tint(color!.value as Color));
  const material = new NodeMaterial();
  material.name = 'sky';
  material.side = BackSide;
  material.depthWrite = false;
  material.fog = false;

  const turned = cameraViewMatrix.mul(vec4(positionLocal, 0)).xyz;
  const clip = cameraProjectionMatrix.mul(vec4(turned, 1)).toVar();
  // On the far plane, whatever the camera's range is.
  material.vertexNode = vec4(clip.xy, clip.w.mul(0.999999), clip.w);

  const direction = varying(positionLocal).normalize().toVar();
  const height = direction.y.max(0).toVar();
  const down = float(1).sub(height);
  const blend = down.mul(down).mul(float(1).sub(height.mul(0.4)));
  const toSun = direction.dot(toward).max(0).toVar();
  const near = toSun
    .pow(6)
    .mul(0.22)
    .add(smoothstep(0.9993, 0.9997, toSun).mul(6));
  const open = mix(high!, low!, blend).add(around!.mul(near));
  // Clouds lie on a plane overhead, and thin out toward the horizon.
  const place = direction.xz.div(height.add(0.12)).mul(0.11);
  const cloud = texture(clouds!.value as Texture, place).x;
  const cover = cloud.mul(0.75).mul(smoothstep(0.03, 0.3, height));
  material.colorNode = mix(open, vec3(1, 0.97, 0.93), cover);
  return material;
}
