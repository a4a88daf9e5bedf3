import type { WebGLRenderer } from 'three';
import { WebGPURenderer } from 'three/webgpu';
import type { CubeCollider as WebGLCubeCollider } from 'three-cube-collider';
import { CubeCollider } from 'three-cube-collider/webgpu';
import type { Rendering } from '../rendering.js';
import { FieldView } from '../overlays/FieldView.js';
import { translate } from './translate.js';

/** @param forceWebGL on the WebGL 2 fallback, though there be WebGPU */
export async function createWebGPURendering(
  canvas: HTMLCanvasElement,
  antialias: boolean,
  forceWebGL: boolean,
): Promise<Rendering> {
  const renderer = new WebGPURenderer({ canvas, antialias, forceWebGL });
  await renderer.init();
  const { isWebGPUBackend } = renderer.backend as { isWebGPUBackend?: boolean };
  return {
    renderer: renderer as unknown as WebGLRenderer,
    backend: isWebGPUBackend === true ? 'WebGPU' : 'WebGPURenderer on WebGL 2',
    software: false,
    canWait: false,
    createCollider: (options) =>
      new CubeCollider({ ...options, readback: 'async' }) as unknown as WebGLCubeCollider,
    createView: (collider) => new FieldView(collider),
    translate,
  };
}
