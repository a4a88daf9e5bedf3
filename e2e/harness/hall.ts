import {
  type BatchedMesh,
  BufferAttribute,
  BufferGeometry,
  type InstancedMesh,
  Matrix4,
  type Mesh,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { CharacterController, CubeCollider } from 'three-cube-collider';
import { Judge } from '../../bench/walk/Judge.js';
import { createHall } from '../../demo/hall/createHall.js';

const DT = 1 / 60;
/** Frames between two judgements of what moves. */
const EVERY = 8;
const SPEED = 3;

/** What a walk came to. */
export interface Outcome {
  /** The foot at the end, in the hall's own frame. */
  end: number[];
  /** The greatest depth in what is drawn, and the greatest gap to it that was seen while standing on it, metres. */
  deepest: number;
  highest: number;
  /** Names of all that it stood on and touched. */
  grounds: string[];
  touched: string[];
  /** Numbers of the instances touched. */
  instances: number[];
}

/** The demo's hall without the level, and a character in it. Nothing is drawn but cubemaps, read at once. */
async function makeWorld() {
  const renderer = new WebGLRenderer();
  renderer.setSize(16, 16);
  const level = (await new GLTFLoader().loadAsync('/level.glb')).scene;
  const scene = new Scene();
  const hall = createHall(level);
  scene.add(hall.root);
  scene.updateMatrixWorld();
  const character = new CharacterController<WebGLRenderer, Scene>(
    new CubeCollider({ readback: 'sync' }),
  );
  const wish = new Vector3();
  /** The place of the creature's skin that it is seen to slip from. */
  let held: { at: number; part: number; place: Vector3; first: Vector3 | null } | null = null;

  /** What is drawn of each exhibit at this moment, as exact triangles. */
  const drawn = {
    grove: () => instancesOf(hall.grove.object),
    rubble: () => batchOf(hall.rubble.stones),
    creature: () =>
      verticesOf(hall.creature.object, (mesh, i, at) => mesh.getVertexPosition(i, at)),
    morphFloor: () =>
      verticesOf(hall.morphFloor.object as Mesh, (mesh, i, at) => mesh.getVertexPosition(i, at)),
    waves: () =>
      verticesOf(hall.waves.object as Mesh, (mesh, i, at) => {
        at.fromBufferAttribute(mesh.geometry.attributes.position!, i);
        return at.setY(hall.waves.height(at.x, at.z, hall.time) - mesh.position.y);
      }),
    wall: () =>
      verticesOf(hall.wall.sheet, (mesh, i, at) => {
        at.fromBufferAttribute(mesh.geometry.attributes.position!, i);
        return at.setZ(hall.wall.bulge(at.x, at.y, hall.time));
      }),
  };
  /** Those that never move are judged by one. */
  const still = new Map<keyof typeof drawn, Judge>();

  function judgeOf(exhibit: keyof typeof drawn): Judge {
    const moves = exhibit !== 'grove' && exhibit !== 'rubble';
    const judge = still.get(exhibit) ?? new Judge(drawn[exhibit]());
    if (!moves) still.set(exhibit, judge);
    return judge;
  }

  function frame(): void {
    hall.update(DT, character.position);
    character.walk(wish);
    character.update(renderer, scene, DT);
  }

  return {
    hall,
    character,
    /** Puts it on its feet somewhere in the hall. */
    put(x: number, y: number, z: number, time = hall.time): void {
      hall.time = time;
      hall.update(0, hall.entry);
      wish.set(0, 0, 0);
      held = null;
      character.teleport(hall.root.localToWorld(new Vector3(x, y, z)));
      for (let i = 0; i < 30 && !character.grounded; i++) frame();
    },
    /**
     * Walks for so many seconds toward where `toward` says, in the hall's frame, and stands where it says nothing.
     */
    walk(
      seconds: number,
      toward: () => { x: number; z: number } | null,
      exhibit?: keyof typeof drawn,
    ): Outcome {
      const grounds = new Set<string>();
      const touched = new Set<string>();
      const instances = new Set<number>();
      let deepest = -Infinity;
      let highest = -Infinity;
      const local = new Vector3();
      for (let i = 1; i <= Math.round(seconds / DT); i++) {
        const goal = toward();
        hall.root.worldToLocal(local.copy(character.position));
        if (goal === null) wish.set(0, 0, 0);
        else wish.set(goal.x - local.x, 0, goal.z - local.z).setLength(SPEED);
        frame();
        grounds.add(character.ground?.object?.name ?? '');
        for (const { object, instance } of character.contacts) {
          touched.add(object?.name ?? '');
          if (instance >= 0) instances.add(instance);
        }
        if (exhibit === undefined || i % EVERY > 0) continue;
        const depth = judgeOf(exhibit).penetration(character.body.position);
        deepest = Math.max(deepest, depth);
        const stands = character.ground?.object?.name === NAMES[exhibit];
        if (stands) highest = Math.max(highest, -depth);
      }
      return {
        end: hall.root.worldToLocal(local.copy(character.position)).toArray(),
        deepest,
        highest,
        grounds: [...grounds],
        touched: [...touched],
        instances: [...instances],
      };
    },
    /** Where it has got to on the creature's skin since the last call, metres along the ground; 0 at first. */
    slip(): number {
      scene.updateMatrixWorld();
      const { bones, boneInverses } = hall.creature.object.skeleton;
      const foot = character.position;
      if (held === null) {
        // Between two joints, as a vertex of the skin would hang on them.
        const at = bones.findIndex((bone, i) => {
          const next = bones[i + 1]?.worldToLocal(foot.clone()).z ?? 0;
          return next < 0 && bone.worldToLocal(foot.clone()).z >= 0;
        });
        const before = bones[at]!.worldToLocal(foot.clone());
        const after = bones[at + 1]!.worldToLocal(foot.clone());
        const part = before.z / (before.z - after.z);
        const rest = boneInverses.map((inverse) => inverse.clone().invert());
        const place = before.applyMatrix4(rest[at]!).lerp(after.applyMatrix4(rest[at + 1]!), part);
        held = { at, part, place, first: null };
      }
      const { at, part, place } = held;
      const [from, to] = [at, at + 1].map((i) =>
        place.clone().applyMatrix4(boneInverses[i]!).applyMatrix4(bones[i]!.matrixWorld),
      );
      const away = from!.lerp(to!, part).sub(foot).setY(0);
      held.first ??= away.clone();
      return away.distanceTo(held.first);
    },
    /** A place of the creature's back, in the hall's frame. */
    joint(along: number): Vector3 {
      scene.updateMatrixWorld();
      return hall.root.worldToLocal(hall.creature.joint(along).getWorldPosition(new Vector3()));
    },
  };
}

const NAMES = {
  grove: 'grove',
  rubble: 'rubble',
  creature: 'creature',
  morphFloor: 'morph floor',
  waves: 'waves',
  wall: 'bulging wall',
};

/** A mesh's triangles in world space, each vertex where `place` says, in the mesh's own frame. */
function verticesOf<M extends Mesh>(
  mesh: M,
  place: (mesh: M, vertex: number, target: Vector3) => Vector3,
): BufferGeometry {
  mesh.updateWorldMatrix(true, true);
  const { count } = mesh.geometry.attributes.position!;
  const positions = new Float32Array(3 * count);
  const at = new Vector3();
  for (let i = 0; i < count; i++) {
    place(mesh, i, at)
      .applyMatrix4(mesh.matrixWorld)
      .toArray(positions, 3 * i);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  return geometry.setIndex(mesh.geometry.index);
}

function instancesOf(mesh: InstancedMesh): BufferGeometry {
  const triangles: number[] = [];
  const matrix = new Matrix4();
  for (let i = 0; i < mesh.count; i++) {
    mesh.getMatrixAt(i, matrix);
    addTriangles(triangles, mesh.geometry, matrix.premultiply(mesh.matrixWorld));
  }
  return soup(triangles);
}

/** three keeps a batch's stones one behind the other, without an index. */
function batchOf(mesh: BatchedMesh): BufferGeometry {
  const triangles: number[] = [];
  const matrix = new Matrix4();
  for (let i = 0; i < mesh.instanceCount; i++) {
    const range = mesh.getGeometryRangeAt(mesh.getGeometryIdAt(i))!;
    mesh.getMatrixAt(i, matrix);
    matrix.premultiply(mesh.matrixWorld);
    addTriangles(triangles, mesh.geometry, matrix, range.start, range.count);
  }
  return soup(triangles);
}

function addTriangles(
  target: number[],
  { index, attributes }: BufferGeometry,
  matrix: Matrix4,
  start = 0,
  count = index?.count ?? attributes.position!.count,
): void {
  for (let i = start; i < start + count; i++) {
    corner.fromBufferAttribute(attributes.position!, index?.getX(i) ?? i).applyMatrix4(matrix);
    target.push(corner.x, corner.y, corner.z);
  }
}

function soup(triangles: number[]): BufferGeometry {
  const geometry = new BufferGeometry();
  return geometry.setAttribute('position', new BufferAttribute(new Float32Array(triangles), 3));
}

const corner = new Vector3();

declare global {
  interface Window {
    hallWorld: Awaited<ReturnType<typeof makeWorld>>;
  }
}

/** Leaves a world in `window.hallWorld`. */
export default async function hall(): Promise<void> {
  window.hallWorld = await makeWorld();
}
