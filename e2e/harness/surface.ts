import {
  DoubleSide,
  FrontSide,
  type Intersection,
  type Material,
  Matrix3,
  type Mesh,
  Raycaster,
  type Side,
  Vector3,
  type WebGLRendererParameters,
} from 'three';
import type { CubeColliderOptions } from 'three-cube-collider';
import { type Backend, createRendering } from '../support/rendering.js';
import { boxesAround } from './boxes.js';

export interface SurfaceCase {
  backend?: Backend;
  collider?: CubeColliderOptions;
  renderer?: WebGLRendererParameters;
  center?: [number, number, number];
}

export interface SurfaceReport {
  format: string | null;
  reversed: boolean;
  texels: number;
  /** Within 1 cm of three's Raycaster and within 0.02 of its normal. */
  good: number;
  /** Of the good ones, those whose facing is told wrong. */
  wrongSide: number;
  /** Of the others, those with no silhouette or edge within half a texel. */
  unexplained: number;
  /** Largest errors among the good ones, metres and length of the normals' difference. */
  worstDistance: number;
  worstNormal: number;
  reads: number;
}

/** Every texel of one cubemap against a ray of three's own through its middle. */
export default async function surface(test: SurfaceCase): Promise<SurfaceReport> {
  const rendering = await createRendering(test.backend, test.renderer);
  const { renderer } = rendering;
  const center = new Vector3(...(test.center ?? [10, 2, 3]));
  const { scene, meshes } = boxesAround(center);
  // Drawn as what shows one side, so that fronts and backs are told; three's own rays shall meet both.
  const show = (side: Side) =>
    meshes.forEach(({ material }) => ((material as Material).side = side));
  show(FrontSide);
  const collider = rendering.collider({ far: 6, ...test.collider });
  collider.position.copy(center);
  const field = (await collider.updateAsync(renderer, scene))!;
  show(DoubleSide);

  const ray = new Raycaster();
  const direction = new Vector3();
  const normal = new Vector3();
  const toWorld = new Matrix3();
  const report: SurfaceReport = {
    format: collider.format,
    reversed: reversed(renderer),
    texels: field.count,
    good: 0,
    wrongSide: 0,
    unexplained: 0,
    worstDistance: 0,
    worstNormal: 0,
    reads: collider.stats.reads,
  };
  for (let texel = 0; texel < field.count; texel++) {
    direction.fromArray(field.direction, 3 * texel).normalize();
    ray.set(center, direction);
    const hit = ray
      .intersectObjects(meshes, false)
      .find(({ distance }) => distance > collider.near);
    if (!hit) {
      if (field.distance[texel] === Infinity) report.good++;
      continue;
    }
    normal
      .copy(hit.face!.normal)
      .applyNormalMatrix(toWorld.getNormalMatrix(hit.object.matrixWorld));
    normal.normalize();
    const back = normal.dot(direction) > 0;
    if (back) normal.negate();
    const distanceError = Math.abs(field.distance[texel]! - hit.distance);
    const normalError = normal.distanceTo(new Vector3().fromArray(field.normal, 3 * texel));
    if (!(distanceError <= 0.01 && normalError <= 0.02)) {
      if (!atEdge(ray, hit, meshes, center, direction, 1 / field.resolution)) report.unexplained++;
      continue;
    }
    report.good++;
    report.worstDistance = Math.max(report.worstDistance, distanceError);
    report.worstNormal = Math.max(report.worstNormal, normalError);
    if ((field.front[texel] === 0) !== back) report.wrongSide++;
  }
  collider.dispose();
  renderer.dispose();
  return report;
}

/** `WebGPURenderer` has no state to ask, but a property. */
function reversed(renderer: object): boolean {
  const { state, reversedDepthBuffer } = renderer as {
    state?: { buffers: { depth: { getReversed(): boolean } } };
    reversedDepthBuffer?: boolean;
  };
  return state === undefined ? reversedDepthBuffer === true : state.buffers.depth.getReversed();
}

/** Does any of eight rays around `direction`, at most `spread` (tangent) away, meet another plane or nothing? */
function atEdge(
  ray: Raycaster,
  hit: Intersection,
  meshes: Mesh[],
  center: Vector3,
  direction: Vector3,
  spread: number,
): boolean {
  const side = new Vector3(direction.y, direction.z, direction.x).cross(direction).normalize();
  const other = new Vector3().crossVectors(direction, side);
  for (let i = 0; i < 8; i++) {
    const angle = (i * Math.PI) / 4;
    const around = direction
      .clone()
      .addScaledVector(side, spread * Math.cos(angle))
      .addScaledVector(other, spread * Math.sin(angle))
      .normalize();
    ray.set(center, around);
    const near = ray.intersectObjects(meshes, false)[0];
    if (!near || near.object !== hit.object) return true;
    if (near.face!.normal.distanceTo(hit.face!.normal) > 1e-6) return true;
  }
  return false;
}
