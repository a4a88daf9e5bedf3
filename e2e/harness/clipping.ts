import {
  BackSide,
  BoxGeometry,
  Mesh,
  MeshBasicMaterial,
  Plane,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { CubeCollider } from 'three-cube-collider';

/** A room whose part above a tilted global plane is cut away: how many texels see what is not drawn, or miss what is. */
export default async function clipping() {
  const renderer = new WebGLRenderer();
  const plane = new Plane(new Vector3(0.3, -0.9, 0.2).normalize(), 0.4);
  renderer.clippingPlanes = [plane];
  const scene = new Scene();
  scene.add(new Mesh(new BoxGeometry(2, 2, 2), new MeshBasicMaterial({ side: BackSide })));
  const collider = new CubeCollider({ far: 3 });
  collider.position.set(0.2, -0.3, 0.1);
  const field = (await collider.updateAsync(renderer, scene))!;
  const point = new Vector3();
  let wrong = 0;
  let cut = 0;
  for (let texel = 0; texel < field.count; texel++) {
    const direction = new Vector3().fromArray(field.direction, 3 * texel);
    const center = collider.position;
    let distance = Infinity;
    for (const axis of ['x', 'y', 'z'] as const) {
      if (direction[axis] === 0) continue;
      distance = Math.min(distance, (Math.sign(direction[axis]) - center[axis]) / direction[axis]);
    }
    point.copy(center).addScaledVector(direction, distance);
    const side = plane.distanceToPoint(point);
    if (Math.abs(side) < 0.002) continue;
    const seen = field.distance[texel]! < Infinity;
    if (side < 0) cut++;
    if (seen !== side > 0) wrong++;
  }
  collider.dispose();
  renderer.dispose();
  return { wrong, cut, texels: field.count };
}
