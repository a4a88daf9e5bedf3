import { type Object3D, WebGLRenderer } from 'three';
import { CubeCollider, type CubeColliderOptions } from 'three-cube-collider';
import { CubemapView } from './overlays/CubemapView.js';
import type { Parameters } from './parameters.js';

/** Shows what a collider sees. */
export interface ColliderView {
  visible: boolean;
  /** Width, CSS pixels; of what is drawn from now on. */
  size: number;
  /** Another one, from now on. */
  show(collider: CubeCollider): void;
  /** Once a frame, after the picture. */
  render(renderer: WebGLRenderer): void;
}

/** All that differs from renderer to renderer; the demo calls what both have by the names of `WebGLRenderer`. */
export interface Rendering {
  readonly renderer: WebGLRenderer;
  /** What draws, for people. */
  readonly backend: string;
  /** Whether the processor draws, for want of a GPU, as far as a browser tells. */
  readonly software: boolean;
  /** Whether a read can be waited for. */
  readonly canWait: boolean;
  createCollider(options: CubeColliderOptions): CubeCollider;
  createView(collider: CubeCollider): ColliderView;
  /** Gives shaders in GLSL their like in the renderer's own language. */
  translate(root: Object3D): void;
}

export function createWebGLRendering(canvas: HTMLCanvasElement, antialias: boolean): Rendering {
  const renderer = new WebGLRenderer({ canvas, antialias });
  return {
    renderer,
    backend: 'WebGL 2',
    software: isSoftware(renderer.getContext()),
    canWait: true,
    createCollider: (options) => new CubeCollider(options),
    createView: (collider) => new CubemapView(collider),
    translate: () => {},
  };
}

function isSoftware(gl: WebGLRenderingContextBase): boolean {
  const names = gl.getExtension('WEBGL_debug_renderer_info');
  const name = names === null ? '' : String(gl.getParameter(names.UNMASKED_RENDERER_WEBGL));
  return /swiftshader|llvmpipe|softpipe|basic render/i.test(name);
}

/** Opens the one that the page's address asks for: three's own at once, the second, as large again, once it is loaded. */
export function openRendering(
  canvas: HTMLCanvasElement,
  { quality, renderer }: Parameters,
  opened: (rendering: Rendering) => void,
  failed: (error: unknown) => void,
): void {
  const antialias = quality !== 'low';
  try {
    if (renderer === 'webgl') opened(createWebGLRendering(canvas, antialias));
    else
      void import('./webgpu/createWebGPURendering.js')
        .then((module) => module.createWebGPURendering(canvas, antialias, renderer === 'fallback'))
        .then(opened)
        .catch(failed);
  } catch (error) {
    failed(error);
  }
}
