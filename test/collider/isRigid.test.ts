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
import { positionLocal, vec4 } from 'three/tsl';
import {
  MeshBasicNodeMaterial,
  MeshStandardNodeMaterial,
  StorageBufferAttribute,
  StorageInstancedBufferAttribute,
} from 'three/webgpu';
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
  const node = (nodes: Partial<MeshBasicNodeMaterial>) =>
    box(Object.assign(new MeshBasicNodeMaterial(), nodes));
  const displacedNodes = new MeshStandardNodeMaterial({ displacementMap: new Texture() });
  const computed = box();
  computed.geometry.setAttribute('position', new StorageBufferAttribute(24, 3));
  const placed = new InstancedMesh(new BoxGeometry(), new MeshBasicMaterial(), 2);
  placed.instanceMatrix = new StorageInstancedBufferAttribute(2, 16);

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
    ['a node that places vertices', node({ positionNode: positionLocal })],
    ['a node that projects them', node({ vertexNode: vec4(positionLocal, 1) })],
    ['a node beside the vertices', node({ geometryNode: (() => {}) as never })],
    ['a displaced node material', box(displacedNodes)],
    ['vertices that may be computed', computed],
    ['instances that may be computed', placed],
  ];
  it.each(soft)('should not be %s', (_, mesh) => expect(isRigid(mesh)).toBe(false));

  const glass = new ShaderMaterial({ transparent: true });
  const hard: [string, Mesh][] = [
    ['a mesh', box()],
    ['instances', new InstancedMesh(new BoxGeometry(), new MeshBasicMaterial(), 1)],
    ['a batch', new BatchedMesh(1, 24, 36, new MeshBasicMaterial())],
    ['a morph of colours only', new Mesh(recoloured, new MeshBasicMaterial())],
    ['a node that only colours', node({ colorNode: vec4(1) })],
    ['a mesh of which only a passable group is not', box(new MeshBasicMaterial(), glass)],
  ];
  it.each(hard)('should be %s', (_, mesh) => expect(isRigid(mesh)).toBe(true));
});
