import type { BatchedMesh, InstancedMesh, Mesh, SkinnedMesh } from 'three';
import { partsOf } from './BatchList.js';
import { isSolid, type Solidity } from './isSolid.js';
import { movesVertices } from './materialKind.js';

/**
 * Can only a mesh's world matrix change what is seen of it, but for changes that its attributes' versions tell? Not if
 * a skin, a morph, a compute shader or a shader that is not three's own may move its vertices.
 *
 * @param solidity which of its materials count
 */
export function isRigid(mesh: Mesh, solidity: Solidity = 'opaque'): boolean {
  if ((mesh as SkinnedMesh).isSkinnedMesh) return false;
  if (mesh.morphTargetInfluences !== undefined || (mesh as InstancedMesh).morphTexture) {
    const morphs = mesh.geometry.morphAttributes.position;
    if (morphs !== undefined && morphs.length > 0) return false;
  }
  if ((mesh as BatchedMesh).isBatchedMesh && partsOf(mesh) === null) return false;
  if (isComputed(mesh)) return false;
  const { material } = mesh;
  if (!Array.isArray(material)) return !movesVertices(material);
  for (let i = 0; i < material.length; i++) {
    if (isSolid(material[i], solidity) && movesVertices(material[i]!)) return false;
  }
  return true;
}

/** May a compute shader write where its vertices or its instances are? */
export function isComputed(mesh: Mesh): boolean {
  return (
    isStorage(mesh.geometry.attributes.position) ||
    isStorage((mesh as Partial<InstancedMesh>).instanceMatrix)
  );
}

function isStorage(attribute: object | undefined): boolean {
  const given = attribute as
    | Partial<Record<'isStorageBufferAttribute' | 'isStorageInstancedBufferAttribute', boolean>>
    | undefined;
  return (
    given?.isStorageBufferAttribute === true || given?.isStorageInstancedBufferAttribute === true
  );
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
