import type { Camera, Scene, Vector3, WebGLRenderer } from 'three';
import type { CubeCollider } from 'three-cube-collider';
import { type Backend, createRendering, type Rendering } from '../../e2e/support/rendering.js';
import { later } from './pace.js';

export const BACKENDS: readonly Backend[] = ['WebGL2', 'WebGPU', 'fallback'];

/** Surveys in a row without a slice of work after which the triangles are taken for found, and how long one takes. */
const QUIET = 20;
const SLICE = 0.75;

export const nameOf = (backend: Backend) => `three-cube-collider, ${backend}`;

/** What three's renderers keep of the GPU; see `backendOf` of the WebGPU entry. */
export interface GpuParts {
  gl?: WebGL2RenderingContext;
  device?: GPUDevice;
}

export function gpuOf({ backend, renderer }: Rendering): GpuParts {
  if (backend === 'WebGL2') return { gl: renderer.getContext() as WebGL2RenderingContext };
  return (renderer as unknown as { backend: GpuParts }).backend;
}

/** A renderer on that backend; null where the browser has none. */
export async function tryRendering(backend: Backend): Promise<Rendering | null> {
  try {
    const rendering = await createRendering(backend, { antialias: false });
    rendering.renderer.setSize(16, 16);
    return rendering;
  } catch {
    return null;
  }
}

export function disposeRendering({ renderer }: Rendering): void {
  renderer.dispose();
  // WebGPURenderer has none.
  (renderer as Partial<WebGLRenderer>).forceContextLoss?.();
}

/** Until the GPU has done all that it was told. */
export async function drained(rendering: Rendering): Promise<void> {
  const { gl, device } = gpuOf(rendering);
  if (device) await device.queue.onSubmittedWorkDone();
  else gl!.readPixels(0, 0, 1, 1, gl!.RGBA, gl!.UNSIGNED_BYTE, new Uint8Array(4));
}

/** The page's own picture, and everything in it on the GPU. */
export async function drawPage(rendering: Rendering, scene: Scene, camera: Camera): Promise<void> {
  rendering.renderer.render(scene, camera);
  await drained(rendering);
}

/**
 * Draws one cubemap, of huge meshes all triangles; then the collider has found where those are, as it would bit by bit.
 *
 * @param foot of a character around which to draw
 */
export async function findTriangles(
  collider: CubeCollider,
  { renderer }: Rendering,
  scene: Scene,
  foot: Vector3,
): Promise<void> {
  collider.position.copy(foot).y += 0.5;
  await collider.updateAsync(renderer, scene);
  for (let quiet = 0, i = 0; quiet < QUIET; i++) {
    const start = performance.now();
    collider.survey(scene);
    quiet = performance.now() - start < SLICE ? quiet + 1 : 0;
    if (i % 30 === 29) await later();
  }
}
