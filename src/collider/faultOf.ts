import type { BatchedMesh, InstancedMesh, Mesh, SkinnedMesh } from 'three';
import { partsOf } from './BatchList.js';

/**
 * What is wrong with a mesh that three could not draw, or that is nowhere; null if nothing. Such a mesh is no obstacle,
 * and must not reach the draw: three throws at some, and all others would go undrawn with them.
 */
export function faultOf(mesh: Mesh): string | null {
  const { geometry, material } = mesh;
  if (material === null || material === undefined) return 'has no material';
  const attributes = geometry?.attributes;
  if (attributes === undefined) return 'has no geometry';
  const { position } = attributes;
  if (!position) return 'has no attribute "position"';
  if (position.count === 0 || geometry.index?.count === 0) return 'has an empty geometry';
  const morphs = geometry.morphAttributes.position;
  if (
    morphs !== undefined &&
    morphs.length > 0 &&
    mesh.morphTargetInfluences === undefined &&
    !(mesh as InstancedMesh).morphTexture
  ) {
    return 'has morph targets and no "morphTargetInfluences"; call its updateMorphTargets()';
  }
  if ((mesh as SkinnedMesh).isSkinnedMesh) {
    if (!(mesh as SkinnedMesh).skeleton) return 'has no skeleton; call its bind()';
    if (!attributes.skinIndex || !attributes.skinWeight) {
      return 'has no attributes "skinIndex" and "skinWeight"';
    }
  }
  if ((mesh as InstancedMesh).isInstancedMesh && !(mesh as InstancedMesh).instanceMatrix) {
    return 'has no "instanceMatrix"';
  }
  if ((mesh as BatchedMesh).isBatchedMesh && wasDisposed(mesh)) return 'was disposed';
  return faultOfMatrix(mesh.matrixWorld.elements);
}

/** Worked out here: a number returned from three would be an object, for every mesh in every walk. */
function faultOfMatrix(m: readonly number[]): string | null {
  const determinant =
    m[0]! * (m[5]! * m[10]! - m[6]! * m[9]!) -
    m[4]! * (m[1]! * m[10]! - m[2]! * m[9]!) +
    m[8]! * (m[1]! * m[6]! - m[2]! * m[5]!);
  const place = m[12]! + m[13]! + m[14]!;
  // Both are 0 times them only if they are finite.
  if (!(0 * determinant * place === 0)) return 'has a world matrix that is not finite';
  return determinant === 0 ? 'has a singular world matrix (a scale of 0)' : null;
}

function wasDisposed(batch: Mesh): boolean {
  return '_matricesTexture' in batch && batch._matricesTexture === null && partsOf(batch) === null;
}
