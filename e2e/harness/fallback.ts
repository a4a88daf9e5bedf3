import { WebGLRenderer } from 'three';
import { CubeCollider } from 'three-cube-collider';
import { boxesAround } from './boxes.js';
import { Vector3 } from 'three';

/** The format chosen on a context that lacks the given extensions, and whether a cubemap comes back in it. */
export default async function fallback(missing: string[]) {
  const renderer = new WebGLRenderer();
  const gl = renderer.getContext();
  const { getExtension } = gl;
  gl.getExtension = ((name: string) =>
    missing.includes(name) ? null : getExtension.call(gl, name as never)) as typeof gl.getExtension;
  const center = new Vector3();
  const { scene } = boxesAround(center);
  const collider = new CubeCollider({ far: 6 });
  const field = (await collider.updateAsync(renderer, scene))!;
  const seen = field.distance.filter((distance) => distance < Infinity).length;
  const { format } = collider;
  collider.dispose();
  renderer.dispose();
  return { format, seen, texels: field.count };
}
