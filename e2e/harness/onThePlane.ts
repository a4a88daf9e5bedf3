import {
  DoubleSide,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { CubeCollider } from 'three-cube-collider';

/**
 * A floor whose vertices lie exactly in the planes of the face cameras, or nearly: texels that miss what a ray meets,
 * and the largest error of those that do not, metres, per place of the collider.
 */
export default async function onThePlane() {
  const renderer = new WebGLRenderer();
  const scene = new Scene();
  const material = new MeshBasicMaterial({ side: DoubleSide });
  scene.add(new Mesh(new PlaneGeometry(8, 8, 4, 4).rotateX(-Math.PI / 2), material));
  const collider = new CubeCollider({ readback: 'sync', far: 1.8 });
  const reports = [];
  for (const x of [0.1, 0, 2]) {
    for (const z of [0, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3, 1e-2, 0.5]) {
      const center = new Vector3(x, 0.35, z);
      collider.position.copy(center);
      collider.update(renderer, scene);
      const { direction, distance, count } = collider.field!;
      let expected = 0;
      let missed = 0;
      let worst = 0;
      for (let texel = 0; texel < count; texel++) {
        const d = center.y / -direction[3 * texel + 1]!;
        // Not beyond the floor's edge, nor where a ray leaves the reach.
        const onFloor = [0, 2].every(
          (axis) => Math.abs(center.getComponent(axis) + d * direction[3 * texel + axis]!) < 3.99,
        );
        if (!(d > 0 && d < 1.79 && onFloor)) continue;
        expected++;
        if (distance[texel] === Infinity) missed++;
        else worst = Math.max(worst, Math.abs(distance[texel]! - d));
      }
      reports.push({ x, z, expected, missed, worst });
    }
  }
  collider.dispose();
  renderer.dispose();
  return reports;
}
