import {
  BatchedMesh,
  BufferAttribute,
  BufferGeometry,
  Group,
  InstancedMesh,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Layers,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  Scene,
  Vector3,
} from 'three';
import { positionLocal } from 'three/tsl';
import { MeshBasicNodeMaterial, StorageBufferAttribute } from 'three/webgpu';
import { describe, expect, it } from 'vitest';
import { seeded } from '../../e2e/support/axisScenes.js';
import { Selection } from '../../src/collider/Selection.js';
import { TriangleIndex } from '../../src/collider/TriangleIndex.js';
import { verticesOf } from '../../src/collider/verticesOf.js';
import { terrain } from '../support/terrain.js';

const CELLS = 150; // 45,000 triangles
const SIZE = 40;
const material = new MeshBasicMaterial();

/** The triangles of a geometry that a box meets, as three's renderer would number them. */
function inBox(geometry: BufferGeometry, box: ArrayLike<number>): number[] {
  const { position } = geometry.attributes;
  const { index } = geometry;
  const count = (index ?? position!).count / 3;
  const found = [];
  for (let t = 0; t < count; t++) {
    const corners = [0, 1, 2].map((k) => (index === null ? 3 * t + k : index.getX(3 * t + k)));
    const meets = (['getX', 'getY', 'getZ'] as const).every((get, axis) => {
      const along = corners.map((corner) => position![get](corner));
      return Math.min(...along) <= box[axis + 3]! && Math.max(...along) >= box[axis]!;
    });
    if (meets) found.push(t);
  }
  return found;
}

function indexed(geometry: BufferGeometry): TriangleIndex {
  const index = new TriangleIndex(geometry, verticesOf(geometry)!);
  for (let slice = 0; slice < 1e5 && !index.done; slice++) index.work(0);
  return index;
}

function interleaved(geometry: BufferGeometry): BufferGeometry {
  const { array, count } = geometry.attributes.position!;
  const data = new Float32Array(8 * count);
  for (let i = 0; i < count; i++) data.set(array.slice(3 * i, 3 * i + 3), 8 * i + 2);
  const buffer = new InterleavedBuffer(data, 8);
  return new BufferGeometry()
    .setAttribute('position', new InterleavedBufferAttribute(buffer, 3, 2))
    .setIndex(geometry.index);
}

function quantized(geometry: BufferGeometry): BufferGeometry {
  const { array } = geometry.attributes.position!;
  const steps = Int16Array.from(array, (v) => Math.round((v / SIZE) * 32767));
  const attribute = new BufferAttribute(steps, 3, true);
  return new BufferGeometry().setAttribute('position', attribute).setIndex(geometry.index);
}

describe('an index of triangles', () => {
  const kinds: [string, (random: () => number) => BufferGeometry, boolean][] = [
    ['a level in order', () => terrain(CELLS, SIZE), false],
    ['a shuffled one', (random) => terrain(CELLS, SIZE, random), true],
    ['one without indices', () => terrain(CELLS, SIZE).toNonIndexed(), false],
    ['a shuffled one without', (random) => terrain(CELLS, SIZE, random).toNonIndexed(), true],
    ['interleaved places', () => interleaved(terrain(CELLS, SIZE)), false],
    ['normalized ones', () => quantized(terrain(CELLS, SIZE)), false],
  ];
  it.each(kinds)(
    'should find all triangles in a box, and few others, of %s (seed 3)',
    (_, make, own) => {
      const random = seeded(3);
      const geometry = make(random);
      const index = indexed(geometry);
      expect(index.ordered).toBe(own);
      const bytes = index.bytes / (2 * CELLS * CELLS);
      expect(bytes).toBeLessThan(own ? 5 : 1);
      const target = new Uint32Array(2 * CELLS * CELLS + 64);
      const wide = geometry.attributes.position!.normalized ? 1 / SIZE : 1;
      for (let i = 0; i < 10; i++) {
        const x = (random() - 0.5) * SIZE;
        const z = (random() - 0.5) * SIZE;
        const box = Float64Array.of(x - 2, -2, z - 2, x + 2, 2, z + 2).map((v) => v * wide);
        const expected = inBox(geometry, box);
        const from = Math.floor(random() * 10_000);
        const count = index.gather(box, from, 40_000, target, 7);
        const found = [...target.subarray(7, count)];
        expect(found).toEqual([...new Set(found)].sort((a, b) => a - b));
        const part = expected.filter((t) => t >= from && t < 40_000);
        const has = new Set(found);
        expect(part.filter((t) => !has.has(t))).toEqual([]);
        expect(found.length).toBeLessThan(6 * expected.length + 1000);
        expect(index.gather(box, 0, Infinity, target.subarray(0, 64), 1)).toBe(-1);
      }
    },
  );

  it('should pass over triangles that are nowhere', () => {
    const geometry = terrain(CELLS, SIZE);
    geometry.attributes.position!.setXYZ(0, NaN, NaN, NaN);
    geometry.index!.setX(60_000, 4e9);
    const target = new Uint32Array(45_100);
    const index = indexed(geometry);
    expect(
      index.gather(Float64Array.of(-20, -2, -20, -19, 2, -19), 0, 1e6, target, 0),
    ).toBeGreaterThan(10);
  });
});

/** What a selection draws of a scene once it has looked long enough. */
function selecting(...objects: Object3D[]) {
  const scene = new Scene().add(...objects);
  const selection = new Selection();
  const rules = { layers: new Layers(), filter: null, excluded: new Set<Object3D>() };
  const center = new Vector3();
  const select = (far = 2) => {
    selection.select(scene, center, far, rules, (source) => source);
    return selection.proxies;
  };
  /** Frames until everything of it is known. */
  const settle = (frames = 3000) => {
    for (let i = 0; i < frames && select()[0]!.geometry === (objects[0] as Mesh).geometry; i++);
    return select()[0]!;
  };
  return { scene, selection, center, select, settle };
}

/** The corners of the triangles that a proxy draws of its first material, in order. */
function drawn({ geometry, material }: Mesh, which = 0): number[] {
  const { index, drawRange, groups } = geometry;
  const corners = [];
  const parts = Array.isArray(material)
    ? groups.filter(({ materialIndex }) => materialIndex === which)
    : [drawRange];
  for (const { start, count } of parts) {
    for (let i = start; i < Math.min(start + count, index!.count); i++)
      corners.push(index!.getX(i));
  }
  return corners;
}

describe('a huge mesh', () => {
  it('should be drawn whole until its triangles are known, then in reach alone', () => {
    const mesh = new Mesh(terrain(CELLS, SIZE), material);
    const { select, settle, center, selection } = selecting(mesh);
    expect(select()[0]!.geometry).toBe(mesh.geometry);
    const proxy = settle();
    expect(proxy.geometry).not.toBe(mesh.geometry);
    expect(proxy.geometry.attributes).toBe(mesh.geometry.attributes);
    expect(proxy.source).toBe(mesh);
    expect(drawn(proxy).length / 3).toBeLessThan((2 * CELLS * CELLS) / 10);
    const { version } = proxy.geometry.index!;
    center.x = 0.1;
    select();
    // A small way needs nothing new, a long one does; so does a mesh that moves instead.
    expect(proxy.geometry.index!.version).toBe(version);
    for (const move of [
      () => (center.x = 8),
      () => mesh.position.setX(-5),
      () => mesh.scale.setScalar(2),
    ]) {
      move();
      select();
      mesh.updateMatrixWorld();
      const local = mesh.worldToLocal(center.clone());
      const reach = 2 / mesh.scale.x;
      const box = [local.x - reach, -9, local.z - reach, local.x + reach, 9, local.z + reach];
      const needed = inBox(mesh.geometry, box).flatMap((t) =>
        [0, 1, 2].map((k) => mesh.geometry.index!.getX(3 * t + k)),
      );
      const has = new Set(drawn(proxy));
      expect(needed.length).toBeGreaterThan(100);
      expect(needed.filter((corner) => !has.has(corner))).toEqual([]);
    }
    // All of it is within reach: there is nothing to leave out.
    expect(select(1000)[0]!.geometry).toBe(mesh.geometry);
    expect(select()[0]!.geometry).toBe(proxy.geometry);
    selection.clear();
    expect(proxy.geometry.attributes).toEqual({});
    expect(mesh.geometry.attributes.position).toBeDefined();
  });

  it('should keep its draw range and its groups, each with its material', () => {
    const glass = new MeshBasicMaterial({ transparent: true });
    const geometry = terrain(CELLS, SIZE);
    const half = 3 * CELLS * CELLS;
    geometry.addGroup(0, half, 1);
    geometry.addGroup(half, Infinity, 0);
    const mesh = new Mesh<BufferGeometry, MeshBasicMaterial | MeshBasicMaterial[]>(geometry, [
      material,
      glass,
    ]);
    const { select, settle } = selecting(mesh);
    const proxy = settle();
    const { index } = geometry;
    const numbers = new Map<string, number>();
    for (let i = 0; i < index!.count; i += 3) {
      numbers.set([0, 1, 2].map((k) => index!.getX(i + k)).join(), i);
    }
    const places = (which = 0) => {
      const corners = drawn(proxy, which);
      return corners
        .filter((_, i) => i % 3 === 0)
        .map((_, i) => numbers.get(corners.slice(3 * i, 3 * i + 3).join())!);
    };
    expect(places(0).length).toBeGreaterThan(100);
    expect(places(0).every((place) => place >= half)).toBe(true);
    expect(places(1).length).toBeGreaterThan(100);
    expect(places(1).every((place) => place < half)).toBe(true);
    geometry.groups[0]!.materialIndex = 0;
    select();
    expect(places(1)).toEqual([]);
    mesh.material = material;
    geometry.setDrawRange(half, 300 * 3);
    select();
    const few = places();
    expect(few.every((place) => place >= half && place < half + 900)).toBe(true);
    // A range that starts within a triangle makes other ones.
    geometry.setDrawRange(half + 1, Infinity);
    expect(select()[0]!.geometry).toBe(geometry);
  });

  const edits: [string, (mesh: Mesh) => void][] = [
    ['its places', ({ geometry }) => (geometry.attributes.position!.needsUpdate = true)],
    ['its index', ({ geometry }) => (geometry.index!.needsUpdate = true)],
    [
      'the attribute',
      ({ geometry }) => geometry.setAttribute('position', geometry.attributes.position!.clone()),
    ],
    ['the index object', ({ geometry }) => geometry.setIndex(geometry.index!.clone())],
    ['all of it', (mesh) => (mesh.geometry = terrain(CELLS, SIZE))],
  ];
  it.each(edits)(
    'should be drawn whole again at once, when %s was edited, and then be known anew',
    (_, edit) => {
      const mesh = new Mesh(terrain(CELLS, SIZE), material);
      const { select, settle } = selecting(mesh);
      const before = settle().geometry;
      edit(mesh);
      expect(select()[0]!.geometry).toBe(mesh.geometry);
      const after = settle().geometry;
      expect(after).not.toBe(mesh.geometry);
      expect(after).not.toBe(before);
      expect(before.attributes).toEqual({});
    },
  );

  it('should not be looked through while it is edited all the time', () => {
    const mesh = new Mesh(terrain(CELLS, SIZE), material);
    const { select, settle } = selecting(mesh);
    settle();
    const { index } = mesh.geometry;
    let read = 0;
    const { array } = index!;
    index!.array = new Proxy(array, {
      get: (target, key) => (typeof key === 'string' && read++, Reflect.get(target, key)),
      getPrototypeOf: (target) => Reflect.getPrototypeOf(target),
    });
    read = 0;
    for (let i = 0; i < 50; i++) {
      mesh.geometry.attributes.position!.needsUpdate = true;
      select();
    }
    expect(read).toBeLessThan(1000);
  });

  it('should be drawn whole where its vertices move on the GPU, or cannot be read', () => {
    const geometry = terrain(CELLS, SIZE);
    const morphed = geometry.clone();
    morphed.morphAttributes.position = [morphed.attributes.position!.clone() as BufferAttribute];
    const batch = new BatchedMesh(
      1,
      geometry.attributes.position!.count,
      geometry.index!.count,
      material,
    );
    batch.addInstance(batch.addGeometry(geometry));
    const uploaded = geometry.clone();
    Object.assign(uploaded.attributes.position!, { array: null });
    uploaded.boundingSphere =
      geometry.boundingSphere ?? (geometry.computeBoundingSphere(), geometry.boundingSphere);
    const displaced = new MeshBasicMaterial();
    Object.assign(displaced, { displacementMap: {} });
    const custom = new MeshBasicMaterial();
    custom.onBeforeCompile = () => {};
    const nodes = new MeshBasicNodeMaterial();
    nodes.positionNode = positionLocal.mul(2);
    const computed = geometry.clone();
    const positions = geometry.attributes.position!;
    computed.setAttribute(
      'position',
      new StorageBufferAttribute(positions.array.slice() as never, 3),
    );
    const meshes = [
      new InstancedMesh(geometry, material, 1),
      new Mesh(morphed, material),
      batch,
      new Mesh(uploaded, material),
      new Mesh(geometry, displaced),
      new Mesh(geometry, custom),
      new Mesh(geometry, nodes),
      new Mesh(computed, material),
      new Mesh(terrain(15, SIZE), material), // not large
    ];
    const plain = new Mesh(geometry, material);
    const { settle, select } = selecting(plain, ...meshes);
    expect(settle().geometry).not.toBe(geometry);
    for (let i = 0; i < 100; i++) select();
    expect(select().map(({ geometry, source }) => geometry === source.geometry)).toEqual([
      false,
      ...meshes.map(() => true),
    ]);
  });

  it('should give back what it took when it is out of reach for long, or gone', () => {
    const mesh = new Mesh(terrain(CELLS, SIZE), material);
    const { select, settle, center, scene } = selecting(mesh);
    const { geometry } = settle();
    center.y = 100;
    for (let i = 0; i < 8; i++) select();
    expect(geometry.attributes).not.toEqual({});
    select();
    expect(geometry.attributes).toEqual({});
    center.y = 0;
    // Known already: it is not drawn whole again.
    const again = select()[0]!.geometry;
    expect(again).not.toBe(mesh.geometry);
    scene.remove(mesh);
    scene.add(new Group());
    for (let i = 0; i < 9; i++) select();
    expect(again.attributes).toEqual({});
  });
});
