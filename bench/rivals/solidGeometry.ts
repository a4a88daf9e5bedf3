import {
  type BatchedMesh,
  BufferAttribute,
  BufferGeometry,
  type InstancedMesh,
  Matrix4,
  Mesh,
  type Object3D,
  Vector3,
} from 'three';
import { isSolid } from '../../src/collider/isSolid.js';

/** Writes where a vertex is drawn, in the mesh's own frame, to `target`. */
export type VertexPlace = (mesh: Mesh, vertex: number, target: Vector3) => Vector3;

/** Some of a mesh's vertices and corners, drawn once. */
interface Part {
  mesh: Mesh;
  /** To the world. */
  matrix: Matrix4;
  vertices: { start: number; count: number };
  /** In the index, or of the vertices where there is none. */
  corners: { start: number; count: number };
}

/** As three's own raycaster has it: with morph targets and skins in the pose of this moment. */
const posed: VertexPlace = (mesh, vertex, target) => mesh.getVertexPosition(vertex, target);

/**
 * What the collider takes for solid, by the rules it states.
 *
 * @param wanted which of it, and with all that hangs on it, is meant; all by default
 */
export function solidMeshes(
  object: Object3D,
  wanted: (object: Object3D) => boolean = () => true,
  found: Mesh[] = [],
): Mesh[] {
  const { visible, userData } = object;
  if (!visible || userData.collider === false || userData.sensor === true) return found;
  if (!wanted(object)) return found;
  if (object instanceof Mesh && [object.material].flat().some((each) => isSolid(each))) {
    found.push(object);
  }
  for (const child of object.children) solidMeshes(child, wanted, found);
  return found;
}

/** Meshes, their instances one by one, in one indexed geometry in world space; world matrices must be up to date. */
export function solidGeometry(meshes: readonly Mesh[], place = posed): BufferGeometry {
  const parts = meshes.flatMap(partsOf);
  const sum = (key: 'vertices' | 'corners') =>
    parts.reduce((total, part) => total + part[key].count, 0);
  const positions = new Float32Array(3 * sum('vertices'));
  const index = new Uint32Array(sum('corners'));
  const at = new Vector3();
  let vertex = 0;
  let corner = 0;
  for (const { mesh, matrix, vertices, corners } of parts) {
    const own = mesh.geometry.index;
    for (let i = 0; i < corners.count; i++) {
      const old = own ? own.getX(corners.start + i) : corners.start + i;
      index[corner++] = vertex + old - vertices.start;
    }
    for (let i = 0; i < vertices.count; i++) {
      place(mesh, vertices.start + i, at)
        .applyMatrix4(matrix)
        .toArray(positions, 3 * vertex++);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  return geometry.setIndex(new BufferAttribute(index, 1));
}

function partsOf(mesh: Mesh): Part[] {
  if ((mesh as Partial<BatchedMesh>).isBatchedMesh) return batchParts(mesh as BatchedMesh);
  const { index, attributes } = mesh.geometry;
  const vertices = { start: 0, count: attributes.position?.count ?? 0 };
  const corners = index ? { start: 0, count: index.count } : vertices;
  const instanced = mesh as InstancedMesh;
  if (!instanced.isInstancedMesh) return [{ mesh, matrix: mesh.matrixWorld, vertices, corners }];
  return Array.from({ length: instanced.count }, (_, i) => {
    const matrix = new Matrix4();
    instanced.getMatrixAt(i, matrix);
    return { mesh, matrix: matrix.premultiply(mesh.matrixWorld), vertices, corners };
  });
}

function batchParts(mesh: BatchedMesh): Part[] {
  return Array.from({ length: mesh.instanceCount }, (_, i) => {
    const { start, count, vertexStart, vertexCount } = mesh.getGeometryRangeAt(
      mesh.getGeometryIdAt(i),
    )!;
    const matrix = new Matrix4();
    mesh.getMatrixAt(i, matrix);
    return {
      mesh,
      matrix: matrix.premultiply(mesh.matrixWorld),
      vertices: { start: vertexStart, count: vertexCount },
      corners: { start, count },
    };
  });
}
