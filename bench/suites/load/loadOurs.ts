import {
  type BufferGeometry,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Scene,
  Vector3,
} from 'three';
import { CharacterController } from 'three-cube-collider';
import type { Backend, Rendering } from '../../../e2e/support/rendering.js';
import { heapBytes } from '../heap.js';
import { disposeRendering, drained, drawPage, findTriangles, tryRendering } from '../ours.js';
import { FRAME, later, nextFrame } from '../pace.js';
import { fresh } from '../places.js';
import { endOfChains, watchTasks } from '../watchTasks.js';
import type { Loaded } from './Loaded.js';

const START = new Vector3(0.571, 1, 0);
/** Longest that a first step is waited for, milliseconds. */
const PATIENCE = 120_000;

interface Life {
  blocking: number;
  waited: number;
  first: number;
  heap: number | null;
}

/**
 * From a renderer and a scene to the first step, programs compiled: twice. On a page that has drawn the scene before, and
 * on one that has not, where its vertices, which go to the GPU but once, do so with the first cubemap.
 *
 * @returns null where the browser has no such backend
 */
export async function loadOurs(backend: Backend, geometry: BufferGeometry): Promise<Loaded | null> {
  const drawn = await live(backend, geometry, true);
  const undrawn = drawn && (await live(backend, fresh(geometry), false));
  return undrawn && { ...drawn, withUpload: undrawn.blocking };
}

async function live(
  backend: Backend,
  geometry: BufferGeometry,
  draws: boolean,
): Promise<Life | null> {
  const rendering = await tryRendering(backend);
  if (rendering === null) return null;
  const scene = new Scene().add(new Mesh(geometry, new MeshBasicMaterial()));
  if (draws) {
    const camera = new PerspectiveCamera(70, 1, 0.1, 200);
    camera.position.set(0, 2, 0);
    await drawPage(rendering, scene, camera);
  }
  const life = await step(rendering, scene, draws);
  await drained(rendering);
  disposeRendering(rendering);
  return life;
}

async function step(rendering: Rendering, scene: Scene, weighs: boolean): Promise<Life> {
  const { renderer } = rendering;
  const before = weighs ? await heapBytes() : null;
  let blocking = 0;
  const unwatch = watchTasks((milliseconds) => (blocking += milliseconds), {
    frames: rendering.backend === 'WebGL2',
    chains: true,
  });
  const begin = performance.now();
  const collider = rendering.collider();
  const character = new CharacterController(collider);
  character.teleport(START);
  const compiled = collider.compile(renderer, scene);
  await endOfChains();
  blocking += performance.now() - begin;
  await compiled;
  // Another task: what hangs on the last one of compiling is in the times already.
  await later();
  const { stats } = character;
  while (stats.steps === stats.held && performance.now() < begin + PATIENCE) {
    await nextFrame();
    const start = performance.now();
    character.update(renderer, scene, FRAME);
    blocking += performance.now() - start;
  }
  const first = performance.now() - begin;
  unwatch();
  const waited = collider.stats.blocked;
  let heap: number | null = null;
  if (before !== null) {
    await findTriangles(collider, rendering, scene, START);
    character.update(renderer, scene, FRAME);
    const after = await heapBytes();
    heap = after === null ? null : after - before;
  }
  character.dispose();
  collider.dispose();
  return { blocking, waited, first, heap };
}
