import {
  BackSide,
  BoxGeometry,
  Group,
  Layers,
  Line,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  Points,
  Scene,
  SphereGeometry,
  Sprite,
  Vector3,
} from 'three';
import { describe, expect, it } from 'vitest';
import { positionLocal } from 'three/tsl';
import { MeshBasicNodeMaterial, StorageBufferAttribute } from 'three/webgpu';
import { seeded } from '../../e2e/support/axisScenes.js';
import type { SelectionRules } from '../../src/collider/SceneWalk.js';
import { Selection } from '../../src/collider/Selection.js';
import { FACES } from '../../src/cube/faces.js';

const geometry = new BoxGeometry();
const origin = new Vector3();
const worn = new MeshBasicMaterial();

function select(scene: Object3D, rules: Partial<SelectionRules> = {}, far = 2, center = origin) {
  const selection = new Selection();
  const all = { layers: new Layers(), filter: null, excluded: new Set<Object3D>(), ...rules };
  selection.select(scene, center, far, all, () => worn);
  return selection.proxies;
}

function sceneOf(...objects: Object3D[]): Scene {
  const scene = new Scene();
  scene.add(...objects);
  return scene;
}

describe('what is solid', () => {
  const named = (
    name: string,
    change: (mesh: Mesh<BoxGeometry, MeshBasicMaterial>) => void = () => {},
  ) => {
    const mesh = new Mesh(geometry, new MeshBasicMaterial());
    mesh.name = name;
    change(mesh);
    return mesh;
  };

  it('should be visible opaque meshes within reach, and nothing else', () => {
    const hidden = new Group();
    hidden.visible = false;
    hidden.add(named('below a hidden one'));
    const ghost = new Group();
    ghost.userData.collider = false;
    ghost.add(named('below an opted-out one'));
    const scene = sceneOf(
      named('solid'),
      named('alpha tested', ({ material }) => {
        material.transparent = true;
        material.alphaTest = 0.5;
      }),
      named('seen from behind', ({ material }) => (material.side = BackSide)),
      named('far', (mesh) => mesh.position.set(5, 0, 0)),
      named('transparent', ({ material }) => (material.transparent = true)),
      named('not writing depth', ({ material }) => (material.depthWrite = false)),
      named('material hidden', ({ material }) => (material.visible = false)),
      named('hidden', (mesh) => (mesh.visible = false)),
      named('on another layer', (mesh) => mesh.layers.set(3)),
      hidden,
      ghost,
      new Line(geometry, worn),
      new Points(geometry),
      new Sprite(),
    );
    expect(select(scene).map(({ name }) => name)).toEqual([
      'solid',
      'alpha tested',
      'seen from behind',
    ]);
    const layers = new Layers();
    layers.set(3);
    expect(select(scene, { layers }).map(({ name }) => name)).toEqual(['on another layer']);
  });

  it('should obey the filter and leave out the excluded with all below them', () => {
    const avatar = new Group();
    avatar.add(named('arm'));
    const scene = sceneOf(named('wall'), named('ghost'), avatar);
    const names = (rules: Partial<SelectionRules>) => select(scene, rules).map(({ name }) => name);
    expect(names({ filter: ({ name }) => name !== 'ghost' })).toEqual(['wall', 'arm']);
    expect(names({ excluded: new Set([avatar]) })).toEqual(['wall', 'ghost']);
  });

  it('should see where things are this frame, before the user renders', () => {
    const lift = named('lift');
    const scene = sceneOf(lift);
    lift.position.set(9, 0, 0);
    expect(select(scene)).toHaveLength(0);
    lift.position.set(1, 0, 0);
    expect(select(scene)).toHaveLength(1);
  });
});

describe('proxies', () => {
  it('should read live from the user’s mesh and never write to it', () => {
    const mesh = new Mesh(geometry, new MeshBasicMaterial());
    const scene = sceneOf(mesh);
    const before = { ...mesh };
    const [proxy] = select(scene);
    expect(proxy!.isMesh).toBe(true);
    expect(proxy!.material).toBe(worn);
    expect(proxy!.matrixWorld).toBe(mesh.matrixWorld);
    expect(proxy!.parent).toBeNull();
    mesh.geometry = new BoxGeometry(2, 2, 2);
    expect(proxy!.geometry).toBe(mesh.geometry);
    expect({ ...mesh, geometry: before.geometry }).toEqual(before);
    expect(scene.children).toEqual([mesh]);
  });

  it('should have a layer for each face that the mesh touches (seed 5)', () => {
    const random = seeded(5);
    const mesh = new Mesh(new SphereGeometry(1, 12, 8), worn);
    const scene = sceneOf(mesh);
    const point = new Vector3();
    let tight = 0;
    for (let i = 0; i < 4000; i++) {
      mesh.position.set(random() - 0.5, random() - 0.5, random() - 0.5).multiplyScalar(6);
      mesh.scale.setScalar(0.05 + random());
      const [proxy] = select(scene, {}, 3);
      const mask = proxy?.layers.mask ?? 0;
      // Points of the sphere within reach: each must lie in a face that is drawn.
      for (let k = 0; k < 20; k++) {
        point.set(random() - 0.5, random() - 0.5, random() - 0.5).normalize();
        point.multiplyScalar(mesh.scale.x).add(mesh.position);
        if (point.length() > 3) continue;
        const axis = [point.x, point.y, point.z].map(Math.abs);
        const largest = axis.indexOf(Math.max(...axis));
        const face = 2 * largest + (point.getComponent(largest) < 0 ? 1 : 0);
        expect(mask & (1 << face), `${FACES[face]!.name} of ${point.toArray()}`).not.toBe(0);
      }
      if (mask !== 0 && mask !== 0b111111) tight++;
    }
    // The mask is worth having: most meshes touch some faces only.
    expect(tight).toBeGreaterThan(2000);
  });

  it('should take objects that are never culled into every face', () => {
    const sky = new Mesh(geometry, worn);
    sky.frustumCulled = false;
    sky.position.set(100, 0, 0);
    expect(select(sceneOf(sky))[0]!.layers.mask).toBe(0b111111);
  });

  it('should take what moves on the GPU into every face that it may have been moved to', () => {
    const node = new Mesh(geometry, new MeshBasicNodeMaterial());
    const computed = new Mesh(geometry.clone(), worn);
    for (const mesh of [node, computed]) mesh.position.set(1.5, 0, 0);
    const masks = () => select(sceneOf(node, computed)).map(({ layers }) => layers.mask);
    expect(masks().map((mask) => mask === 0b111111)).toEqual([false, false]);
    (node.material as MeshBasicNodeMaterial).positionNode = positionLocal.negate();
    const { array } = geometry.attributes.position!;
    computed.geometry.setAttribute('position', new StorageBufferAttribute(array as never, 3));
    expect(masks()).toEqual([0b111111, 0b111111]);
    // How far it may come is the user's to say, as for the renderer.
    node.position.x = computed.position.x = 50;
    expect(masks()).toEqual([]);
    node.frustumCulled = computed.frustumCulled = false;
    expect(masks()).toEqual([0b111111, 0b111111]);
  });

  it('should skip empty geometries and those without positions', () => {
    const empty = new Mesh(geometry.clone(), worn);
    empty.geometry.deleteAttribute('position');
    expect(select(sceneOf(empty))).toHaveLength(0);
  });
});
