import { type BatchedMesh, type InstancedMesh, Material, type Mesh, type SkinnedMesh } from 'three';
import { partsOf } from './BatchList.js';
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
  if ((mesh as BatchedMesh).isBatchedMesh && partsOf(mesh) === null) return false;
  const { material } = mesh;
  if (!Array.isArray(material)) return keepsShape(material);
  for (let i = 0; i < material.length; i++) {
    if (isSolid(material[i]) && !keepsShape(material[i]!)) return false;
  }
  return true;
}

/**
 * A number that changes with a batch's matrices and with which instances it shows, of which geometry. three tells none
 * of it openly (and unsays at the user's next render that visibility changed); -1 where it keeps them otherwise than
 * today.
 */
export function batchVersion(mesh: Mesh): number {
  const parts = partsOf(mesh);
  if (parts === null) return -1;
  const { _instanceInfo: instances } = parts;
  let number = parts._matricesTexture!.version + instances.length;
  for (let i = 0; i < instances.length; i++) {
    const { visible, active, geometryIndex } = instances[i]!;
    // Kept to 30 bits, which every engine holds without an object.
    number = (31 * number + (active && visible ? 1 + geometryIndex : 0)) & 0x3fffffff;
  }
  return number;
}

function keepsShape(material: Material): boolean {
  const { isShaderMaterial, displacementMap } = material as {
    isShaderMaterial?: boolean;
    displacementMap?: unknown;
  };
  if (isShaderMaterial === true || (displacementMap ?? null) !== null) return false;
  return material.onBeforeCompile === Material.prototype.onBeforeCompile;
}
