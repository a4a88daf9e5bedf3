import { type BufferGeometry, type InstancedMesh, Matrix4, type Mesh, Vector3 } from 'three';
import type { Material, Object3D } from 'three';

/** Coordinates of a triangle's corners: x, y, z three times. */
export const STRIDE = 9;

/** More than so many triangles are sampled evenly: a start is found as well among half of them. */
const MOST = 1_500_000;

const corner = new Vector3();
const toRoot = new Matrix4();
const placed = new Matrix4();

/**
 * Every triangle that a character may meet, in the frame of `root`'s parent, nine numbers each: as posed now, with skins,
 * morph targets and instances. What no collider takes for solid is left out: the sky, what is hidden, what is seen through.
 *
 * Updates world matrices.
 */
export function collectTriangles(root: Object3D, most = MOST): Float32Array {
  root.updateWorldMatrix(true, true);
  const meshes: Mesh[] = [];
  visitSolid(root, (mesh) => meshes.push(mesh));
  const total = meshes.reduce((sum, mesh) => sum + countOf(mesh), 0);
  const step = Math.max(1, Math.ceil(total / most));
  const soup = new Float32Array(STRIDE * meshes.reduce((sum, m) => sum + sampled(m, step), 0));
  toRoot.copy(root.parent?.matrixWorld ?? placed.identity()).invert();
  let at = 0;
  for (const mesh of meshes) at = writeMesh(mesh, step, soup, at);
  return soup;
}

/** Calls `visit` for each mesh that can be walked on. */
function visitSolid(object: Object3D, visit: (mesh: Mesh) => void): void {
  if (!object.visible || object.userData.collider === false) return;
  const mesh = object as Mesh;
  if (mesh.isMesh && mesh.geometry.attributes.position !== undefined && isOpaque(mesh)) visit(mesh);
  for (const child of object.children) visitSolid(child, visit);
}

/** As the collider sees it: what is seen through is no obstacle, unless an alpha test cuts it. */
function isOpaque({ material }: Mesh): boolean {
  const materials: Material[] = Array.isArray(material) ? material : [material];
  return materials.some((each) => each.depthWrite && (!each.transparent || each.alphaTest > 0));
}

function trianglesOf(geometry: BufferGeometry): number {
  const corners = geometry.index?.count ?? geometry.attributes.position!.count;
  const { start, count } = geometry.drawRange;
  return Math.max(0, Math.floor(Math.min(corners - start, count) / 3));
}

const instancesOf = (mesh: Mesh) =>
  (mesh as InstancedMesh).isInstancedMesh ? (mesh as InstancedMesh).count : 1;

const countOf = (mesh: Mesh) => trianglesOf(mesh.geometry) * instancesOf(mesh);

const sampled = (mesh: Mesh, step: number) =>
  Math.ceil(trianglesOf(mesh.geometry) / step) * instancesOf(mesh);

function writeMesh(mesh: Mesh, step: number, soup: Float32Array, at: number): number {
  const { geometry } = mesh;
  const { index, drawRange } = geometry;
  const triangles = trianglesOf(geometry);
  for (let instance = 0; instance < instancesOf(mesh); instance++) {
    placed.copy(mesh.matrixWorld).premultiply(toRoot);
    if ((mesh as InstancedMesh).isInstancedMesh) {
      const own = new Matrix4();
      (mesh as InstancedMesh).getMatrixAt(instance, own);
      placed.multiply(own);
    }
    for (let t = 0; t < triangles; t += step) {
      for (let k = 0; k < 3; k++, at += 3) {
        const i = drawRange.start + 3 * t + k;
        mesh.getVertexPosition(index === null ? i : index.getX(i), corner).applyMatrix4(placed);
        corner.toArray(soup, at);
      }
    }
  }
  return at;
}
