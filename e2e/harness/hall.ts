import { type Mesh, Scene, Vector3, WebGLRenderer } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { CharacterController, CubeCollider } from 'three-cube-collider';
import { Judge } from '../../bench/rivals/Judge.js';
import { solidGeometry } from '../../bench/rivals/solidGeometry.js';
import { createHall } from '../../demo/hall/createHall.js';
import { drawnVertex } from '../../demo/hall/drawnVertex.js';

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

  const place = drawnVertex(hall);
  const trianglesOf = (mesh: Mesh) => {
    mesh.updateWorldMatrix(true, true);
    return solidGeometry([mesh], place);
  };
  /** What is drawn of each exhibit at this moment, as exact triangles. */
  const drawn = {
    grove: () => trianglesOf(hall.grove.object),
    rubble: () => trianglesOf(hall.rubble.stones),
    creature: () => trianglesOf(hall.creature.object),
    morphFloor: () => trianglesOf(hall.morphFloor.object as Mesh),
    waves: () => trianglesOf(hall.waves.object as Mesh),
    wall: () => trianglesOf(hall.wall.sheet),
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

declare global {
  interface Window {
    hallWorld: Awaited<ReturnType<typeof makeWorld>>;
  }
}

/** Leaves a world in `window.hallWorld`. */
export default async function hall(): Promise<void> {
  window.hallWorld = await makeWorld();
}
