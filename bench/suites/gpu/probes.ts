import type { Vector3 } from 'three';
import type { Backend, Rendering } from '../../../e2e/support/rendering.js';
import { disposeRendering, findTriangles, gpuOf, nameOf, tryRendering } from '../ours.js';
import type { Place } from '../places.js';
import { createCubeCamera } from './cubeCamera.js';
import { createTimer } from './timer.js';

/** One way to see what is around. */
export interface Probe {
  name: string;
  /** Draws, and has the texels once it is done. */
  see(center: Vector3): Promise<void> | void;
  /** Milliseconds that the GPU was at it, or null; itself null where it never tells. */
  timed: ((center: Vector3) => Promise<number | null>) | null;
  dispose(): void;
}

/** As a character at rest has it, metres. */
const FAR = 2.2;

const CUBE_CAMERA = 'CubeCamera, six reads';
const COARSE = 'three-cube-collider, WebGL2, supersample 1';

export const PROBES = [nameOf('WebGL2'), COARSE, nameOf('WebGPU'), nameOf('fallback'), CUBE_CAMERA];

/** @returns null where the browser cannot */
export async function createProbe(name: string, place: Place): Promise<Probe | null> {
  const { scene } = place;
  const backend = (['WebGPU', 'fallback'] as const).find((each) => name === nameOf(each));
  const rendering = await tryRendering(backend ?? 'WebGL2');
  if (rendering === null) return null;
  const timer = backend === undefined ? createTimer(gpuOf(rendering).gl!) : null;
  const { see, release } =
    name === CUBE_CAMERA
      ? createCubeCamera(rendering, scene, FAR)
      : await createOurs(rendering, place, backend, name === COARSE ? 1 : 4);
  return {
    name,
    see,
    timed: timer && ((center) => timer(() => void see(center))),
    dispose() {
      release();
      disposeRendering(rendering);
    },
  };
}

/** Reads at once; where a renderer cannot, as soon as the read has come. */
async function createOurs(
  rendering: Rendering,
  { scene, start }: Place,
  backend: Backend | undefined,
  supersample: 1 | 4,
) {
  const { renderer } = rendering;
  const collider = rendering.collider({ readback: 'sync', far: FAR, supersample });
  await collider.compile(renderer, scene);
  await findTriangles(collider, rendering, scene, start(0));
  return {
    see(center: Vector3): Promise<void> | void {
      collider.position.copy(center);
      if (backend !== undefined) return collider.updateAsync(renderer, scene).then(() => {});
      collider.update(renderer, scene);
    },
    release: () => collider.dispose(),
  };
}
