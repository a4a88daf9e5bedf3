import { Layers, type Material, Matrix3, Matrix4, type Mesh } from 'three';

/** A stand-in for a user's mesh in the collider's own scene. */
export interface ObjectProxy extends Mesh {
  material: Material | Material[];
}

const nothing = () => {};

/**
 * A mesh that reads everything live from `mesh` (geometry, world matrix, skeleton, morph influences…) but has its own
 * material, layers and per-draw matrices, no parent and no children. The user's object is neither reparented nor
 * written to.
 */
export function createObjectProxy(mesh: Mesh): ObjectProxy {
  const own = <T>(value: T) => ({ value, writable: true, enumerable: true, configurable: true });
  return Object.create(mesh, {
    parent: own(null),
    children: own([]),
    visible: own(true),
    // Selected already, and three would test our array camera, not one face.
    frustumCulled: own(false),
    layers: own(new Layers()),
    modelViewMatrix: own(new Matrix4()),
    normalMatrix: own(new Matrix3()),
    material: own(null),
    renderOrder: own(0),
    castShadow: own(false),
    receiveShadow: own(false),
    // The user's hooks set up their own materials; ours need none of it.
    onBeforeRender: own(nothing),
    onAfterRender: own(nothing),
    _listeners: own(undefined),
  }) as ObjectProxy;
}
