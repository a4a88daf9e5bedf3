import type { Object3D } from 'three';

const hitByNothing = (): void => {};

/**
 * What only shows something: no obstacle to any collider, whatever its options, hit by no ray, and never culled, since
 * its shape changes.
 *
 * @returns the object
 */
export function makeGhost<T extends Object3D>(object: T): T {
  object.userData.collider = false;
  object.raycast = hitByNothing;
  object.frustumCulled = false;
  return object;
}
