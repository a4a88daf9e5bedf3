import type { WebGLRenderer, WebGLRenderTarget } from 'three';
import { atlasSize } from '../cube/atlas.js';
import type { TexelFormat } from '../cube/encoding.js';
import { AxisPass } from './AxisPass.js';
import { CollisionMaterials } from './CollisionMaterials.js';
import type { CubeColliderSettings } from './CubeColliderOptions.js';
import { FaceCameras } from './FaceCameras.js';
import { ReadbackRing } from './ReadbackRing.js';
import { ReadbackScheduler } from './ReadbackScheduler.js';
import { bestTexelFormat, canDraw, createTexelTarget } from './texelTarget.js';

/** Everything a collider keeps on one renderer's GPU. */
export class ColliderResources {
  readonly format: TexelFormat;
  readonly atlas: WebGLRenderTarget;
  readonly cameras: FaceCameras;
  readonly materials: CollisionMaterials;
  /** The search for the maxima; null if surfaces are read. */
  readonly axis: AxisPass | null;
  readonly ring: ReadbackRing;
  /** Pending while programs are being compiled. */
  compiling: Promise<unknown> | null = null;
  /** Finds the moments for asynchronous reads; null if they are synchronous. */
  readonly scheduler: ReadbackScheduler | null;

  constructor(
    readonly renderer: WebGLRenderer,
    settings: CubeColliderSettings,
    /** Called when the context is lost, while deleting what it held is still allowed. */
    readonly onLost: () => void,
  ) {
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const { resolution, near, far, output } = settings;
    const axis = output === 'axis';
    this.format = axis ? 'RGBA8' : usableFormat(gl, settings.format);
    const { width, height } = atlasSize(resolution);
    this.atlas = createTexelTarget(width, height, this.format, true);
    this.cameras = new FaceCameras(resolution, near, far);
    this.materials = new CollisionMaterials({ ...settings, format: this.format });
    this.axis = axis ? new AxisPass(resolution, this.atlas.texture) : null;
    const float = this.format !== 'RGBA8';
    this.ring = axis
      ? new ReadbackRing(gl, 6, 1, false)
      : new ReadbackRing(gl, width, height, float);
    this.scheduler = settings.readback === 'async' ? ReadbackScheduler.of(gl) : null;
    renderer.domElement.addEventListener('webglcontextlost', onLost);
  }

  dispose(): void {
    this.renderer.domElement.removeEventListener('webglcontextlost', this.onLost);
    // three still asks for the programs of materials that it is compiling.
    if (this.compiling !== null) void this.compiling.finally(() => this.#free());
    else this.#free();
  }

  #free(): void {
    this.atlas.dispose();
    this.materials.dispose();
    this.axis?.dispose();
    this.ring.dispose();
  }
}

/** The format asked for, if the context can draw it; else the best that it can. */
function usableFormat(gl: WebGL2RenderingContext, wanted: TexelFormat | 'auto'): TexelFormat {
  return wanted !== 'auto' && canDraw(gl, wanted) ? wanted : bestTexelFormat(gl);
}
