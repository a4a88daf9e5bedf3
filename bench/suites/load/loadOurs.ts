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
import { endOfChains, watchTasks } from '../watchTasks.js';
import type { Loaded } from './Loaded.js';

const START = new Vector3(0.571, 1, 0);
/** Longest that a first step is waited for, milliseconds. */
const PATIENCE = 120_000;

/**
 * From a renderer and a scene to the first step, programs compiled.
 *
 * @param drawn whether the page has drawn the scene before; else its vertices, which go to the GPU but once, do so with
 *   the first cubemap
 * @returns null where the browser has no such backend
 */
export function loadOurs(
  backend: Backend,
  geometry: BufferGeometry,
  drawn = true,
): Promise<Loaded | null> {
  return onPage(backend, geometry, drawn, step);
}

/** Bytes that it keeps once all triangles are found; null where the browser does not say. */
export function weighOurs(backend: Backend, geometry: BufferGeometry): Promise<number | null> {
  return onPage(backend, geometry, true, async (rendering, scene) => {
    const before = await heapBytes();
    const collider = rendering.collider();
    const character = new CharacterController(collider);
    character.teleport(START);
    // Again, with what is drawn once the triangles are found.
    for (let i = 0; i < 2; i++) {
      await findTriangles(collider, rendering, scene, START);
      character.update(rendering.renderer, scene, FRAME);
    }
    const after = await heapBytes();
    character.dispose();
    collider.dispose();
    return before === null || after === null ? null : after - before;
  });
}

async function onPage<T>(
  backend: Backend,
  geometry: BufferGeometry,
  draws: boolean,
  live: (rendering: Rendering, scene: Scene) => Promise<T>,
): Promise<T | null> {
  const rendering = await tryRendering(backend);
  if (rendering === null) return null;
  const scene = new Scene().add(new Mesh(geometry, new MeshBasicMaterial()));
  if (draws) {
    const camera = new PerspectiveCamera(70, 1, 0.1, 200);
    camera.position.set(0, 2, 0);
    await drawPage(rendering, scene, camera);
  }
  const result = await live(rendering, scene);
  await drained(rendering);
  disposeRendering(rendering);
  return result;
}

async function step(rendering: Rendering, scene: Scene): Promise<Loaded> {
  const { renderer } = rendering;
  let blocking = 0;
  let longest = 0;
  const note = (milliseconds: number) => {
    blocking += milliseconds;
    longest = Math.max(longest, milliseconds);
  };
  const unwatch = watchTasks(note, {
    frames: rendering.backend === 'WebGL2',
    chains: true,
  });
  const begin = performance.now();
  const collider = rendering.collider();
  const character = new CharacterController(collider);
  character.teleport(START);
  const compiled = collider.compile(renderer, scene);
  await endOfChains();
  note(performance.now() - begin);
  await compiled;
  // Another task: what hangs on the last one of compiling is in the times already.
  await later();
  const { stats } = character;
  while (stats.steps === stats.held && performance.now() < begin + PATIENCE) {
    await nextFrame();
    const start = performance.now();
    character.update(renderer, scene, FRAME);
    note(performance.now() - start);
  }
  const first = performance.now() - begin;
  unwatch();
  const waited = collider.stats.blocked;
  character.dispose();
  collider.dispose();
  return { blocking, longest, waited, first };
}
