import {
  type BatchedMesh,
  Layers,
  type Material,
  Matrix3,
  Matrix4,
  type Mesh,
  type ShaderMaterial,
} from 'three';
import { BatchList } from './BatchList.js';

/** A stand-in for a user's mesh in the collider's own scene. */
export interface ObjectProxy extends Mesh {
  material: Material | Material[];
  /** The user's mesh. */
  readonly source: Mesh;
  /** Its number in the draw, from 1. */
  drawNumber: number;
  /** Which of a batch's instances are drawn; null of all else. */
  readonly batch: BatchList | null;
}

const nothing = () => {};

/** Tells the shared material, which three is about to draw this object with, whose turn it is. */
function announce(
  this: ObjectProxy,
  _renderer: unknown,
  _scene: unknown,
  _camera: unknown,
  _geometry: unknown,
  material: Material,
): void {
  const { object } = (material as ShaderMaterial).uniforms;
  if (object === undefined) return;
  object.value = this.drawNumber;
  // Else three uploads a material's uniforms only where another was drawn before.
  (material as ShaderMaterial).uniformsNeedUpdate = true;
}

/**
 * A mesh that reads everything live from `mesh` (geometry, world matrix, skeleton, morph influences…) but has its own
 * material, layers and per-draw matrices, no parent and no children. The user's object is neither reparented nor
 * written to.
 */
export function createObjectProxy(mesh: Mesh): ObjectProxy {
  const own = <T>(value: T) => ({ value, writable: true, enumerable: true, configurable: true });
  return Object.create(mesh, {
    source: own(mesh),
    drawNumber: own(0),
    batch: own((mesh as BatchedMesh).isBatchedMesh ? new BatchList() : null),
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
    onBeforeRender: own(announce),
    onAfterRender: own(nothing),
    _listeners: own(undefined),
  }) as ObjectProxy;
}
