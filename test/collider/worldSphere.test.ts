import {
  BatchedMesh,
  Bone,
  BoxGeometry,
  BufferAttribute,
  type BufferGeometry,
  CapsuleGeometry,
  DetachedBindMode,
  InstancedMesh,
  LOD,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  Skeleton,
  SkinnedMesh,
  Sphere,
  Vector3,
} from 'three';
import { describe, expect, it } from 'vitest';
import { isLevel, levelShown } from '../../src/collider/levelShown.js';
import { worldSphere } from '../../src/collider/worldSphere.js';
import { seeded } from '../../e2e/support/axisScenes.js';
import { box } from '../support/meshes.js';

const plain = new MeshBasicMaterial();

/** The sphere of a mesh, and whether the user's own stayed away. */
function sphereOf(mesh: Mesh): Sphere {
  const sphere = new Sphere();
  mesh.updateMatrixWorld();
  expect(worldSphere(mesh, sphere)).toBe(true);
  expect((mesh as unknown as InstancedMesh).boundingSphere ?? null).toBe(null);
  return sphere;
}

function skin(random: () => number, detached: boolean): SkinnedMesh {
  const geometry: BufferGeometry = new CapsuleGeometry(0.2, 1, 3, 8);
  const { count } = geometry.attributes.position!;
  const indices = Uint16Array.from({ length: 4 * count }, () => Math.floor(5 * random()));
  const weights = Float32Array.from({ length: 4 * count }, random);
  geometry.setAttribute('skinIndex', new BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new BufferAttribute(weights, 4));
  const mesh = new SkinnedMesh(geometry, plain);
  mesh.normalizeSkinWeights();
  if (detached) mesh.bindMode = DetachedBindMode;
  const bones = Array.from({ length: 5 }, () => new Bone());
  const turn = () => {
    for (const bone of bones) {
      bone.position.set(random(), random(), random());
      bone.quaternion.copy(new Quaternion(random(), random(), random(), random()).normalize());
    }
  };
  for (const bone of bones) mesh.add(bone);
  turn();
  mesh.position.set(3 * random(), 0, 2);
  mesh.rotation.set(random(), random(), random());
  mesh.updateMatrixWorld(true);
  mesh.bind(new Skeleton(bones));
  turn();
  mesh.position.x += 2;
  mesh.scale.set(1 + random(), 1, 0.5);
  return mesh;
}

describe('the sphere around a mesh', () => {
  for (const detached of [false, true]) {
    it(`should hold every vertex of a skin in any pose, ${detached ? 'de' : 'at'}tached (seed 4)`, () => {
      const random = seeded(4);
      for (let trial = 0; trial < 40; trial++) {
        const mesh = skin(random, detached);
        const sphere = sphereOf(mesh);
        const vertex = new Vector3();
        let farthest = 0;
        for (let i = 0; i < mesh.geometry.attributes.position!.count; i++) {
          mesh.getVertexPosition(i, vertex).applyMatrix4(mesh.matrixWorld);
          farthest = Math.max(farthest, vertex.distanceTo(sphere.center));
        }
        expect(farthest).toBeLessThanOrEqual(sphere.radius + 1e-6);
        expect(sphere.radius).toBeLessThan(6 * farthest);
      }
    });
  }

  it('should follow instances and batches that nobody computed anew', () => {
    const forest = new InstancedMesh(new BoxGeometry(), plain, 2);
    const batch = new BatchedMesh(2, 24, 36, plain);
    const which = batch.addGeometry(new BoxGeometry());
    batch.addInstance(which);
    batch.addInstance(which);
    for (const mesh of [forest, batch]) {
      mesh.position.x = 1;
      expect(sphereOf(mesh).center.x).toBeCloseTo(1);
      mesh.setMatrixAt(1, new Matrix4().makeTranslation(8, 0, 0));
      if (mesh === forest) forest.instanceMatrix.needsUpdate = true;
      expect(sphereOf(mesh).center.x).toBeCloseTo(5);
      if (mesh === forest) forest.count = 1;
      else batch.deleteInstance(1);
      expect(sphereOf(mesh).center.x).toBeCloseTo(1);
    }
  });

  it('should be none where nobody knows where the mesh ends', () => {
    const lost = new Mesh(new BoxGeometry(), plain);
    Object.assign(lost.geometry.attributes.position!, { array: null });
    const sphere = new Sphere();
    expect(worldSphere(lost, sphere)).toBe(false);
    const nowhere = box();
    nowhere.matrixWorld.elements[12] = NaN;
    expect(worldSphere(nowhere, sphere)).toBe(false);
  });
});

describe('an LOD', () => {
  it('should show, until it is rendered, what a camera at the centre would get', () => {
    const lod = new LOD();
    const levels = [box(), box(), box()];
    levels.forEach((level, i) => lod.addLevel(level, [0, 5, 20][i]));
    const sign = box();
    lod.add(sign);
    lod.position.x = 7;
    lod.updateMatrixWorld();
    expect(levelShown(lod, new Vector3(6, 0, 0))).toBe(levels[0]);
    expect(levelShown(lod, new Vector3())).toBe(levels[1]);
    expect(levelShown(lod, new Vector3(-90, 0, 0))).toBe(levels[2]);
    expect([...levels, sign].map((child) => isLevel(lod, child))).toEqual([
      true,
      true,
      true,
      false,
    ]);
    // As three leaves them.
    levels[0]!.visible = levels[1]!.visible = false;
    expect(levelShown(lod, new Vector3())).toBe(null);
    for (const level of levels) level.visible = true;
    lod.autoUpdate = false;
    expect(levelShown(lod, new Vector3())).toBe(null);
  });
});
