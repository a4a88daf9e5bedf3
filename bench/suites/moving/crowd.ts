import {
  Bone,
  Box3,
  BufferAttribute,
  type BufferGeometry,
  CylinderGeometry,
  Mesh,
  MeshBasicMaterial,
  Scene,
  Skeleton,
  SkinnedMesh,
  Sphere,
  Vector3,
} from 'three';
import { SkinnedMeshBVH, StaticGeometryGenerator } from 'three-mesh-bvh';
import { RapierWalker } from '../../rivals/RapierWalker.js';
import { FRAME } from '../pace.js';
import { floor } from './floor.js';
import type { MovingCase, MovingRival } from './MovingCase.js';
import { capsuleBox, pushOut, rebuiltOctree, SUB_STEPS } from './pushOut.js';

const BONES = 8;
const AROUND = 25;
const ALONG = 40;
const TRIANGLES = 2 * AROUND * ALONG;
const HEIGHT = 1.7;
/** From one to the next, metres: shoulder to shoulder around the character. */
const APART = 1.2;
/** Most triangles of which a rebuild is timed. */
const REBUILT = 10_000;

/** Figures of 2000 triangles that sway on eight bones each, in ranks around the character. */
export function crowd(triangles: number): MovingCase {
  const figures = people(Math.round(triangles / TRIANGLES));
  const scene = new Scene().add(floor(), ...figures);
  const foot = new Vector3(0, 0.05, 0);
  scene.updateMatrixWorld();
  const rebuilds = triangles <= REBUILT;
  return {
    name: `skinned crowd, ${triangles / 1000}k triangles`,
    scene,
    foot,
    move(frame) {
      figures.forEach(({ skeleton }, i) => {
        for (const [j, bone] of skeleton.bones.entries()) {
          bone.rotation.z = 0.04 * Math.sin(0.1 * frame + i + 0.5 * j);
        }
      });
    },
    rivals: () => [
      refitted(figures, foot),
      refittedNear(figures, foot),
      ...(rebuilds ? [rebuiltOctree(foot, () => posed(scene)), rebuiltRapier(scene, foot)] : []),
    ],
    cannot: rebuilds ? {} : { Octree: 'cannot but be rebuilt', Rapier: 'cannot but be rebuilt' },
  };
}

/** `SkinnedMeshBVH` as it is meant to be: refitted after each pose. */
function refitted(figures: SkinnedMesh[], foot: Vector3): MovingRival {
  const trees = figures.map((mesh) => new SkinnedMeshBVH(mesh, { indirect: true }));
  return {
    name: 'three-mesh-bvh',
    frame() {
      for (const tree of trees) tree.refit();
      for (let i = 0; i < SUB_STEPS; i++) {
        for (const [j, tree] of trees.entries()) pushOut(tree, figures[j]!, foot);
      }
    },
    dispose() {
      // nothing but memory
    },
  };
}

/** At its best: a page that keeps account of who is near may leave the others as they are. */
function refittedNear(figures: SkinnedMesh[], foot: Vector3): MovingRival {
  const trees = figures.map((mesh) => new SkinnedMeshBVH(mesh, { indirect: true }));
  const sphere = new Sphere();
  const box = capsuleBox(foot, new Box3());
  return {
    name: 'three-mesh-bvh, near ones only',
    frame() {
      const near: number[] = [];
      for (const [i, { geometry, matrixWorld }] of figures.entries()) {
        sphere.copy(geometry.boundingSphere!).applyMatrix4(matrixWorld);
        if (sphere.intersectsBox(box)) near.push(i);
      }
      for (const i of near) trees[i]!.refit();
      for (let step = 0; step < SUB_STEPS; step++) {
        for (const i of near) pushOut(trees[i]!, figures[i]!, foot);
      }
    },
    dispose() {
      // nothing but memory
    },
  };
}

function rebuiltRapier(scene: Scene, foot: Vector3): MovingRival {
  const still = new Vector3();
  return {
    name: 'Rapier',
    note: 'rebuilt in each frame',
    async frame() {
      const walker = await RapierWalker.create(posed(scene)[0]!.geometry);
      walker.place(foot);
      walker.frame(still, false, FRAME);
      walker.dispose();
    },
    dispose() {
      // nothing is kept
    },
  };
}

/** All of a scene as it is drawn just now, in one mesh. */
function posed(scene: Scene): Mesh[] {
  const generator = new StaticGeometryGenerator(scene);
  generator.attributes = ['position'];
  generator.useGroups = false;
  return [new Mesh(generator.generate())];
}

function people(count: number): SkinnedMesh[] {
  const geometry = figure();
  const places: Vector3[] = [];
  const ranks = Math.ceil(Math.sqrt(count)) + 1;
  for (let i = -ranks; i <= ranks; i++) {
    for (let j = -ranks; j <= ranks; j++) {
      if (i !== 0 || j !== 0) places.push(new Vector3(APART * i, 0, APART * j));
    }
  }
  places.sort((a, b) => a.lengthSq() - b.lengthSq());
  return places.slice(0, count).map((place) => {
    const mesh = new SkinnedMesh(geometry, new MeshBasicMaterial());
    const bones = Array.from({ length: BONES }, () => new Bone());
    bones.forEach((bone, i) => {
      bone.position.y = i === 0 ? 0 : HEIGHT / BONES;
      if (i > 0) bones[i - 1]!.add(bone);
    });
    mesh.add(bones[0]!);
    mesh.position.copy(place);
    mesh.updateMatrixWorld();
    mesh.bind(new Skeleton(bones));
    return mesh;
  });
}

/** A tube on its foot, each ring of it between two bones. */
function figure(): BufferGeometry {
  const geometry = new CylinderGeometry(0.2, 0.25, HEIGHT, AROUND, ALONG, true);
  geometry.translate(0, HEIGHT / 2, 0);
  const position = geometry.attributes.position!;
  const index = new Uint16Array(4 * position.count);
  const weight = new Float32Array(4 * position.count);
  for (let i = 0; i < position.count; i++) {
    const at = Math.min((position.getY(i) / HEIGHT) * BONES, BONES - 1);
    const bone = Math.max(0, Math.min(Math.floor(at), BONES - 2));
    index.set([bone, bone + 1], 4 * i);
    weight.set([1 - (at - bone), at - bone], 4 * i);
  }
  geometry.setAttribute('skinIndex', new BufferAttribute(index, 4));
  geometry.setAttribute('skinWeight', new BufferAttribute(weight, 4));
  geometry.computeBoundingSphere();
  return geometry;
}
