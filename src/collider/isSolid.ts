import type { Material, Object3D } from 'three';

/** Are see-through things obstacles? See `CubeColliderOptions.transparent`. */
export type TransparentPolicy = 'ignore' | 'solid';

/**
 * Which of a mesh's materials are obstacles: those that hide what is behind them, all that are shown, or, where
 * `userData.collider` is true, whatever it wears.
 */
export type Solidity = 'opaque' | 'shown' | 'all';

/** How a mesh is judged. */
export function solidityOf(object: Object3D, transparent: TransparentPolicy = 'ignore'): Solidity {
  if (object.userData.collider === true) return 'all';
  return transparent === 'solid' ? 'shown' : 'opaque';
}

/**
 * Is what wears this material an obstacle? By default where it is drawn and not see-through: transparent materials
 * are solid only where an alpha test cuts them out. Wide lines are meshes to three, and no obstacles.
 */
export function isSolid(
  material: Material | null | undefined,
  solidity: Solidity = 'opaque',
): boolean {
  if (!material || (material as { isLineMaterial?: boolean }).isLineMaterial === true) return false;
  if (solidity === 'all') return true;
  if (!material.visible) return false;
  if (solidity === 'shown') return true;
  if (!material.depthWrite) return false;
  return !material.transparent || material.alphaTest > 0 || hasAlphaTestNode(material);
}

function hasAlphaTestNode(material: Material): boolean {
  return !!(material as { alphaTestNode?: unknown }).alphaTestNode;
}
