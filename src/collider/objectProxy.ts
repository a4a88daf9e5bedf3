import {
  type BatchedMesh,
  type BufferGeometry,
  type Camera,
  type Group,
  Layers,
  type Material,
  Matrix3,
  Matrix4,
  type Mesh,
  type Scene,
  type ShaderMaterial,
  type WebGLRenderer,
} from 'three';
import { BatchList } from './BatchList.js';
import { isDerived } from './derivedMaterial.js';
import type { Solidity } from './isSolid.js';

/** A stand-in for a user's mesh in the collider's own scene. */
export interface ObjectProxy extends Mesh {
  material: Material | Material[];
  /** The user's mesh. */
  readonly source: Mesh;
  /** Its number in the draw, from 1. */
  drawNumber: number;
  /** Which of a batch's instances are drawn; null of all else. */
  readonly batch: BatchList | null;
  /** The user's scene. */
  scene: Scene;
  /** How it was judged when it was selected. */
  solidity: Solidity;
}

/** Tells the material, which three is about to draw this object with, whose turn it is. */
function announce(
  this: ObjectProxy,
  renderer: WebGLRenderer,
  _scene: unknown,
  camera: Camera,
  geometry: BufferGeometry,
  material: Material,
  group: Group,
): void {
  if (isDerived(material)) {
    material.beforeTurn(this, renderer, camera, geometry, group);
    return;
  }
  // Node materials ask the object themselves.
  const object = (material as Partial<ShaderMaterial>).uniforms?.object;
  if (object === undefined) return;
  object.value = this.drawNumber;
  // Else three uploads a material's uniforms only where another was drawn before.
  (material as ShaderMaterial).uniformsNeedUpdate = true;
}

/** The user's hooks, for the materials that need them. */
function conclude(
  this: ObjectProxy,
  renderer: WebGLRenderer,
  _scene: unknown,
  camera: Camera,
  geometry: BufferGeometry,
  material: Material,
  group: Group,
): void {
  if (isDerived(material)) {
    material.afterTurn(this, renderer, camera, geometry, group);
  }
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
    scene: own(null),
    solidity: own('opaque'),
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
    // The user's hooks set up their own materials; most of ours need none of it.
    onBeforeRender: own(announce),
    onAfterRender: own(conclude),
    _listeners: own(undefined),
  }) as ObjectProxy;
}
