import type { BufferAttribute, Texture, WebGPURenderer } from 'three/webgpu';

/** What three keeps of a texture or an attribute on either backend. */
interface BackendData {
  texture?: GPUTexture;
  buffer?: GPUBuffer;
  textureGPU?: WebGLTexture;
}

/** What is used of three's backends, which their types do not tell. */
export interface Backend {
  readonly isWebGPUBackend?: boolean;
  /** WebGPU's. */
  readonly device?: GPUDevice;
  /** The WebGL 2 fallback's. */
  readonly gl?: WebGL2RenderingContext;
  readonly state?: {
    bindFramebuffer(target: number, framebuffer: WebGLFramebuffer | null): void;
  };
  get(object: Texture | BufferAttribute): BackendData;
}

/** Of a renderer that was initialised. */
export function backendOf(renderer: WebGPURenderer): Backend {
  return renderer.backend as unknown as Backend;
}
