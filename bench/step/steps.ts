import { Vector3 } from 'three';
import { seeded } from '../../e2e/support/axisScenes.js';
import { CharacterController } from '../../src/character/CharacterController.js';
import { randomWorld } from '../../test/support/world/randomWorld.js';
import {
  block,
  ground,
  kerb,
  pole,
  spiral,
  stairs,
  wall,
} from '../../test/support/world/scenes.js';
import { World } from '../../test/support/world/World.js';
import { WorldCollider } from '../../test/support/world/WorldCollider.js';
import { Hills } from './Hills.js';

type Drive = (character: CharacterController, frame: number) => void;

interface Case {
  world: () => World;
  /** Where the foot begins. */
  foot?: readonly [number, number, number];
  /** Called before every frame. */
  drive: Drive;
}

const wish = new Vector3();

/** More than any cache holds. */
const LARGE = 16e6;
let large: Float64Array | null = null;

/** Leaves nothing of ours in the processor's caches, as a page's other work does between two frames. */
function emptyCaches(): void {
  large ??= new Float64Array(LARGE);
  for (let i = 0; i < LARGE; i += 8) large[i]!++;
}

/** Presses on that way; never exactly the same, so that no step is passed over as the last one over again. */
const press =
  (x: number, z: number): Drive =>
  (character, frame) =>
    character.walk(wish.set(x + (frame & 1) * 1e-6, 0, z));

/** Turns and jumps at random, at 5 m/s. */
function ramble(seed: number): Drive {
  const random = seeded(seed);
  let yaw = 0;
  return (character, frame) => {
    if (frame % 12 !== 0) return;
    yaw += (random() - 0.5) * 2;
    if (random() < 0.05) yaw += Math.PI;
    character.walk(wish.set(5 * Math.cos(yaw), 0, 5 * Math.sin(yaw)));
    if (random() < 0.15) character.jump();
  };
}

export const CASES: Record<string, Case> = {
  'on a plane': { world: () => new World(ground()), drive: press(3, 1.5) },
  'along a wall': { world: () => new World(ground(), wall(0.5)), drive: press(3, 3) },
  'into a corner': {
    world: () => new World(ground(), wall(0.5), wall(0, 0.5, Math.PI / 2)),
    drive: press(3, 1.5),
  },
  'at a step too high': {
    world: () => new World(ground(), kerb(0.6, 0.5), pole(0, 0.6)),
    drive: press(3, 1.5),
  },
  'under a ceiling': {
    world: () => new World(ground(), block([-3, 1.9, -3], [3, 2, 3]), wall(0.5)),
    drive: press(3, 1.5),
  },
  'up stairs': { world: () => new World(ground(), ...stairs(400, 0.17, 0.29)), drive: press(2, 0) },
  'around a newel': {
    world: () => new World(ground(), ...spiral(9, 0.18)),
    foot: [0, 0.02, 1.4],
    drive: (character, frame) =>
      character.walk(wish.set(3 * Math.cos(frame / 28), 0, -3 * Math.sin(frame / 28))),
  },
  'inside a pillar': {
    world: () => new World(ground(), ...spiral(9, 0.18)),
    drive: press(3, 1.5),
  },
  'over hills': { world: () => new World(new Hills(1.41)), foot: [0.571, 1, 0], drive: ramble(6) },
  'over fine hills': {
    world: () => new World(new Hills(0.14)),
    foot: [0.571, 1, 0],
    drive: ramble(6),
  },
  'through a yard': { world: () => randomWorld(seeded(5)), drive: ramble(6) },
};

/**
 * Times `CharacterController.step` in a frame loop of 60 Hz, and apart from it what a new field costs.
 *
 * @param cold whether each begins with empty caches
 * @returns milliseconds of each
 */
export function measure(
  name: string,
  seconds: number,
  cold = false,
): { steps: number[]; fields: number[] } {
  const { world, foot = [0, 0.02, 0], drive } = CASES[name]!;
  const collider = new WorldCollider(world());
  const character = new CharacterController(collider);
  character.teleport(new Vector3(...foot));
  const steps: number[] = [];
  const fields: number[] = [];
  for (let frame = 0; frame < 60 * seconds; frame++) {
    collider.tick();
    drive(character, frame);
    const { draws } = collider;
    // Draws, if that is due, and does not step.
    character.update({}, {}, 0);
    if (collider.draws > draws) {
      if (cold) emptyCaches();
      const begin = performance.now();
      character.update({}, {}, 0);
      fields.push(performance.now() - begin);
    }
    if (cold) emptyCaches();
    const begin = performance.now();
    character.step(1 / 60);
    steps.push(performance.now() - begin);
  }
  return { steps, fields };
}
