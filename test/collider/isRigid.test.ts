import {
  BatchedMesh,
  BoxGeometry,
  BufferAttribute,
  Float32BufferAttribute,
  InstancedMesh,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  RawShaderMaterial,
  ShaderMaterial,
  Texture,
} from 'three';
import { describe, expect, it } from 'vitest';
import { isRigid } from '../../src/collider/isRigid.js';
import { box, skinned } from '../support/meshes.js';

describe('what is rigid', () => {
  const morphing = new BoxGeometry();
  morphing.morphAttributes.position = [new BufferAttribute(new Float32Array(72), 3)];
  const crowd = new InstancedMesh(morphing, new MeshBasicMaterial(), 1);
  crowd.setMorphAt(0, new Mesh(morphing));
  const hooked = new MeshBasicMaterial();
  hooked.onBeforeCompile = () => {};
  const displaced = new MeshStandardMaterial({ displacementMap: new Texture() });
  const strange = new BatchedMesh(1, 24, 36, new MeshBasicMaterial());
  Object.assign(strange, { _instanceInfo: undefined });
  const recoloured = new BoxGeometry();
  recoloured.morphAttributes.color = [new Float32BufferAttribute(72, 3)];

  const soft: [string, Mesh][] = [
    ['a skin', skinned()],
    ['a morph', new Mesh(morphing, new MeshBasicMaterial())],
    ['morphing instances', crowd],
    ['a shader of the user’s', box(new ShaderMaterial())],
    ['a raw shader of the user’s', box(new RawShaderMaterial())],
    ['a hooked material', box(hooked)],
    ['a displaced material', box(displaced)],
    ['one such group of many', box(new MeshBasicMaterial(), hooked)],
    ['a batch whose changes cannot be told', strange],
  ];
  it.each(soft)('should not be %s', (_, mesh) => expect(isRigid(mesh)).toBe(false));

  const glass = new ShaderMaterial({ transparent: true });
  const hard: [string, Mesh][] = [
    ['a mesh', box()],
    ['instances', new InstancedMesh(new BoxGeometry(), new MeshBasicMaterial(), 1)],
    ['a batch', new BatchedMesh(1, 24, 36, new MeshBasicMaterial())],
    ['a morph of colours only', new Mesh(recoloured, new MeshBasicMaterial())],
    ['a mesh of which only a passable group is not', box(new MeshBasicMaterial(), glass)],
  ];
  it.each(hard)('should be %s', (_, mesh) => expect(isRigid(mesh)).toBe(true));
});
