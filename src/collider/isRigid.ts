import { type BatchedMesh, type InstancedMesh, Material, type Mesh, type SkinnedMesh } from 'three';
import { isSolid } from './isSolid.js';

/**
 * Can only a mesh's world matrix change what is seen of it, but for changes that its attributes' versions tell? Not if
 * a skin, a morph or a shader that is not three's own may move its vertices.
 */
export function isRigid(mesh: Mesh): boolean {
  if ((mesh as SkinnedMesh).isSkinnedMesh) return false;
  if (mesh.morphTargetInfluences !== undefined || (mesh as InstancedMesh).morphTexture) {
    const morphs = mesh.geometry.morphAttributes.position;
    if (morphs !== undefined && morphs.length > 0) return false;
  }
  if ((mesh as BatchedMesh).isBatchedMesh && batchVersion(mesh) < 0) return false;
  const { material } = mesh;
  if (!Array.isArray(material)) return keepsShape(material);
  for (let i = 0; i < material.length; i++) {
    if (isSolid(material[i]) && !keepsShape(material[i]!)) return false;
  }
  return true;
}

/**
 * A number that changes with a batch's matrices and its instances' visibility. three tells neither openly; -1 where it
 * keeps them otherwise than it does today.
 */
export function batchVersion(mesh: Mesh): number {
  const { _matricesTexture: matrices, _visibilityChanged: shown } = mesh as unknown as {
    _matricesTexture?: { version?: number } | null;
    _visibilityChanged?: boolean;
  };
  if (typeof matrices?.version !== 'number' || typeof shown !== 'boolean') return -1;
  return 2 * matrices.version + (shown ? 1 : 0);
}

function keepsShape(material: Material): boolean {
  const { isShaderMaterial, displacementMap } = material as {
    isShaderMaterial?: boolean;
    displacementMap?: unknown;
  };
  if (isShaderMaterial === true || (displacementMap ?? null) !== null) return false;
  return material.onBeforeCompile === Material.prototype.onBeforeCompile;
}
