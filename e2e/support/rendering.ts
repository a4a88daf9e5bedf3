import { type Object3D, WebGLRenderer, type WebGLRendererParameters } from 'three';
import { CubeCollider, type CubeColliderOptions } from 'three-cube-collider';

/** With what a test draws: three's two renderers, the second on both of its backends. */
export type Backend = 'WebGL2' | 'WebGPU' | 'fallback';

/** Of whichever renderer; what tests use is the same in both. */
export interface Rendering {
  readonly backend: Backend;
  readonly renderer: WebGLRenderer;
  /** Its collider; 'sync' is left out where it cannot be. */
  collider(options?: CubeColliderOptions): CubeCollider;
  /** A field of what is there now. */
  see(collider: CubeCollider, scene: Object3D): Promise<void>;
}

/** Makes a renderer, and makes sure that it runs on the backend asked for. */
export async function createRendering(
  backend: Backend = 'WebGL2',
  parameters: WebGLRendererParameters = {},
): Promise<Rendering> {
  if (backend === 'WebGL2') {
    const renderer = new WebGLRenderer(parameters);
    return {
      backend,
      renderer,
      collider: (options) => new CubeCollider(options),
      see: async (collider, scene) => {
        await collider.updateAsync(renderer, scene);
      },
    };
  }
  const { WebGPURenderer, CubeCollider: GpuCollider } = await import('./webgpuNames.js');
  const made = new WebGPURenderer({ ...parameters, forceWebGL: backend === 'fallback' } as never);
  await made.init();
  const { isWebGPUBackend = false } = made.backend as { isWebGPUBackend?: boolean };
  if (isWebGPUBackend !== (backend === 'WebGPU')) {
    throw new Error(`Asked for ${backend}, three took ${made.backend.constructor.name}.`);
  }
  const renderer = made as unknown as WebGLRenderer;
  return {
    backend,
    renderer,
    collider: (options) =>
      new GpuCollider({ ...options, readback: 'async' }) as unknown as CubeCollider,
    see: async (collider, scene) => {
      await collider.updateAsync(renderer, scene);
    },
  };
}

/** How many programs a renderer has. */
export function programsOf(renderer: WebGLRenderer): number {
  const { programs, memory } = renderer.info as unknown as {
    programs?: unknown[];
    memory: { programs: number };
  };
  // WebGPU counts a vertex and a fragment program each.
  return programs?.length ?? memory.programs / 2;
}
