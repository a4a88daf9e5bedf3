import { type Scene, Vector3, type WebGLRenderer } from 'three';
import { CharacterController, type CubeCollider, CubeColliderGroup } from 'three-cube-collider';
import type { Backend, Rendering } from '../../e2e/support/rendering.js';
import { Inputs } from '../walk/Inputs.js';
import { SHAPE } from '../rivals/shape.js';
import { MeshBvhWalker } from '../rivals/MeshBvhWalker.js';
import { OctreeWalker } from '../rivals/OctreeWalker.js';
import { RapierWalker } from '../rivals/RapierWalker.js';
import type { Walker } from '../rivals/Walker.js';
import { BACKENDS, disposeRendering, nameOf, tryRendering } from './ours.js';
import { FRAME, later, mean, nextFrame, rotated } from './pace.js';
import { type Place, terrainPlace } from './places.js';
import { Rows } from './Rows.js';
import type { SuiteOptions, SuiteRow } from './suite.js';
import { watchTasks } from './watchTasks.js';

/** Characters. */
const COUNTS = [1, 10, 100];
/** As many draw each for themselves: of more the GPU's memory would be the figure. */
const MOST_ALONE = 10;
/** Texels per face edge of a crowd that makes do with fewer. */
const COARSE = 16;
/** Metres between two at the beginning. */
const APART = 3;
const SETTLING = 300;
/** How long a read is waited for at most, milliseconds. */
const PATIENCE = 2000;

/** A crowd, moved as one. */
interface Crowd {
  name: string;
  /** To where it begins, and to rest. */
  place(): Promise<void>;
  /** On from there. @returns main-thread milliseconds of each frame, what is left for later included */
  walk(inputs: readonly Inputs[], frames: number): Promise<number[]>;
  /** More figures of the last walk. */
  figures(): Record<string, number>;
  dispose(): void;
}

/** What many characters in one level cost a frame. */
export default async function crowd(
  { quick, repeats }: SuiteOptions,
  tell: (line: string) => void,
): Promise<SuiteRow[]> {
  const rows = new Rows();
  const place = terrainPlace('10k triangles', 10_000);
  const frames = 30;
  for (const count of quick ? COUNTS.slice(0, 2) : COUNTS) {
    const where = count === 1 ? '1 character' : `${count} characters`;
    const crowds = await enter(place, count, (name, note) =>
      rows.add(where, name, 'a character, ms', undefined, note),
    );
    const inputs = (round: number) =>
      Array.from({ length: count }, (_, i) => new Inputs(1 + i + round * count, new Vector3()));
    for (const each of crowds) {
      await each.place();
      await each.walk(inputs(0), 15);
    }
    for (let round = 1; round <= (quick ? 2 : Math.max(5, repeats)); round++) {
      for (const each of rotated(crowds, round)) {
        const times = await each.walk(inputs(round), frames);
        rows.add(where, each.name, 'a character, ms', mean(times) / count);
        rows.add(where, each.name, 'a frame, ms', mean(times));
        for (const [name, value] of Object.entries(each.figures())) {
          rows.add(where, each.name, name, value);
        }
        tell(`${where}, ${each.name}: ${mean(times).toFixed(2)} ms a frame`);
      }
    }
    for (const each of crowds) each.dispose();
  }
  return rows.all;
}

async function enter(
  place: Place,
  count: number,
  cannot: (name: string, why: string) => void,
): Promise<Crowd[]> {
  const crowds: Crowd[] = [];
  for (const backend of BACKENDS) {
    const rendering = await tryRendering(backend);
    if (rendering === null) cannot(nameOf(backend), 'not in this browser');
    else crowds.push(await enterOurs(rendering, place, count, true));
  }
  const coarse = await tryRendering('WebGL2');
  if (coarse !== null) crowds.push(await enterOurs(coarse, place, count, true, COARSE));
  const alone = await tryRendering('WebGL2');
  if (count === 1 || alone === null) {
    if (alone) disposeRendering(alone);
  } else if (count > MOST_ALONE) {
    cannot(aloneOf('WebGL2'), 'left out');
    disposeRendering(alone);
  } else {
    crowds.push(await enterOurs(alone, place, count, false));
  }
  crowds.push(
    enterRivals('Octree', count, new OctreeWalker(place.geometry), (first) => new OctreeWalker(first)),
    enterRivals('three-mesh-bvh', count, new MeshBvhWalker(place.geometry), (first) => new MeshBvhWalker(first)),
  ); // prettier-ignore
  const first = await RapierWalker.create(place.geometry);
  const guests: RapierWalker[] = [];
  for (let i = 1; i < count; i++) guests.push(await RapierWalker.create(first));
  crowds.push(enterRivals('Rapier', count, first, () => guests.pop()!));
  return crowds;
}

const aloneOf = (backend: Backend) => `${nameOf(backend)}, without a group`;
const coarseOf = (backend: Backend) => `${nameOf(backend)}, resolution ${COARSE}`;

/** Where each begins: a square around the middle. */
function startOf(i: number, count: number): Vector3 {
  const edge = Math.ceil(Math.sqrt(count));
  const middle = (edge - 1) / 2;
  return new Vector3(APART * ((i % edge) - middle), 1.3, APART * (Math.floor(i / edge) - middle));
}

/** Ours, in one group or each for itself. @param resolution 32 if left out, the default */
export async function enterOurs(
  rendering: Rendering,
  { scene }: Place,
  count: number,
  grouped: boolean,
  resolution?: number,
): Promise<Crowd> {
  const { renderer, backend } = rendering;
  const group = new CubeColliderGroup<WebGLRenderer>();
  const { radius, height, gravity, jumpHeight } = SHAPE;
  const colliders: CubeCollider[] = [];
  const characters: CharacterController<WebGLRenderer, Scene>[] = [];
  for (let i = 0; i < count; i++) {
    const collider = rendering.collider({ resolution });
    if (grouped) group.add(collider);
    colliders.push(collider);
    characters.push(new CharacterController(collider, { radius, height, gravity, jumpHeight }));
  }
  await colliders[0]!.compile(renderer, scene);

  /** Until all that was drawn has come: a software GPU works on the same processor. */
  const arrived = async () => {
    const end = performance.now() + PATIENCE;
    const waits = () =>
      grouped
        ? group.stats.reads < group.stats.draws
        : colliders.some(({ stats, field }) => stats.reads < stats.draws && field?.serial !== stats.draws);
    while (waits() && performance.now() < end) await later(1);
  }; // prettier-ignore
  const update = () => {
    for (const character of characters) character.update(renderer, scene, FRAME);
    if (grouped) group.update(renderer, scene);
  };
  const counted = () => ({
    cubemaps: colliders.reduce((sum, { stats }) => sum + stats.draws, 0),
    reads: grouped ? group.stats.reads : colliders.reduce((sum, { stats }) => sum + stats.reads, 0),
    held: characters.reduce((sum, { stats }) => sum + stats.held + stats.slowed, 0),
    steps: characters.reduce((sum, { stats }) => sum + stats.steps, 0),
  });
  let before = counted();
  let walked = 1;
  return {
    name: (!grouped ? aloneOf : resolution === COARSE ? coarseOf : nameOf)(backend),
    async place() {
      characters.forEach((character, i) => character.teleport(startOf(i, count)));
      for (let i = 0; i < SETTLING && characters.some(({ grounded }) => !grounded); i++) {
        update();
        await arrived();
      }
    },
    async walk(inputs, frames) {
      before = counted();
      walked = frames;
      let cost = 0;
      const unwatch = watchTasks((milliseconds) => (cost += milliseconds), {
        frames: backend === 'WebGL2',
      });
      const times: number[] = [];
      for (let frame = 0; frame < frames; frame++) {
        await nextFrame();
        const start = performance.now();
        for (let i = 0; i < count; i++) {
          const { velocity, jump } = inputs[i]!.advanceTo(frame * FRAME);
          characters[i]!.walk(velocity);
          if (jump) characters[i]!.jump();
        }
        update();
        cost += performance.now() - start;
        await arrived();
        times.push(cost);
        cost = 0;
      }
      unwatch();
      return times;
    },
    figures() {
      const now = counted();
      return {
        'cubemaps a frame': (now.cubemaps - before.cubemaps) / walked,
        'reads a frame': (now.reads - before.reads) / walked,
        'held or slowed, %': (100 * (now.held - before.held)) / (now.steps - before.steps),
      };
    },
    dispose() {
      for (const character of characters) character.dispose();
      group.dispose();
      for (const collider of colliders) collider.dispose();
      disposeRendering(rendering);
    },
  };
}

/** @param share makes another who walks in the same tree or world */
function enterRivals<W extends Walker>(
  name: string,
  count: number,
  first: W,
  share: (first: W) => W,
): Crowd {
  const walkers = [first, ...Array.from({ length: count - 1 }, () => share(first))];
  return {
    name,
    place() {
      walkers.forEach((walker, i) => walker.place(startOf(i, count)));
      const still = new Vector3();
      for (let i = 0; i < 60; i++) for (const walker of walkers) walker.frame(still, false, FRAME);
      return Promise.resolve();
    },
    async walk(inputs, frames) {
      const times: number[] = [];
      for (let frame = 0; frame < frames; frame++) {
        await nextFrame();
        const start = performance.now();
        for (let i = 0; i < count; i++) {
          const { velocity, jump } = inputs[i]!.advanceTo(frame * FRAME);
          walkers[i]!.frame(velocity, jump, FRAME);
        }
        times.push(performance.now() - start);
      }
      return times;
    },
    figures: () => ({}),
    dispose: () => first.dispose(),
  };
}
