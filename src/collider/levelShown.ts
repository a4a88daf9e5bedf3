import type { LOD, Object3D, Vector3 } from 'three';

/**
 * Which level an `LOD` shows that three has never updated: before its first render all of them are visible. It is the
 * one that a camera at `center` (world space) would get.
 *
 * @returns null where what is visible is what is shown: after that render, or where the user updates it
 */
export function levelShown(lod: LOD, center: Vector3): Object3D | null {
  if (!lod.autoUpdate) return null;
  const { levels } = lod;
  let visible = 0;
  for (let i = 0; i < levels.length; i++) if (levels[i]!.object.visible) visible++;
  if (visible < 2) return null;
  const { elements } = lod.matrixWorld;
  const x = elements[12]! - center.x;
  const y = elements[13]! - center.y;
  const z = elements[14]! - center.z;
  return lod.getObjectForDistance(Math.sqrt(x * x + y * y + z * z));
}

/** Is `child` a level of `lod`? It may have other children, which show at any distance. */
export function isLevel(lod: LOD, child: Object3D): boolean {
  const { levels } = lod;
  for (let i = 0; i < levels.length; i++) if (levels[i]!.object === child) return true;
  return false;
}
