import type { WebGLRenderer, WebGLRenderTarget } from 'three';
import { atlasSize } from '../cube/atlas.js';
import { hasIdTexture, type TexelFormat } from '../cube/encoding.js';
import type { Warnings } from '../Warnings.js';
import { AxisPass } from './AxisPass.js';
import { CollisionMaterials } from './CollisionMaterials.js';
import type { CubeColliderSettings } from './CubeColliderOptions.js';
import { FaceCameras } from './FaceCameras.js';
import { NearestPass } from './NearestPass.js';
import { ReadbackRing } from './ReadbackRing.js';
import { ReadbackScheduler } from './ReadbackScheduler.js';
import { bestTexelFormat, canDraw, createTexelTarget } from './texelTarget.js';

/** Everything a collider keeps on one renderer's GPU. */
export class ColliderResources {
  readonly format: TexelFormat;
  /** What scenery is drawn into; the atlas itself, unless it is drawn finer. */
  readonly drawn: WebGLRenderTarget;
  /** What surfaces are read from. */
  readonly atlas: WebGLRenderTarget;
  readonly cameras: FaceCameras;
  readonly materials: CollisionMaterials;
  /** The search for the maxima; null if surfaces are read. */
  readonly axis: AxisPass | null;
  /** Keeps the nearest of what is drawn finer; null if it is not. */
  readonly nearest: NearestPass | null;
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
    warnings: Warnings,
  ) {
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const { resolution, supersample, near, far, output } = settings;
    const fine = resolution * supersample;
    const axis = output === 'axis';
    this.format = axis ? 'RGBA8' : usableFormat(gl, settings.format);
    const ids = !axis && hasIdTexture(this.format);
    const { width, height } = atlasSize(resolution);
    this.drawn = createTexelTarget(
      supersample * width,
      supersample * height,
      this.format,
      true,
      ids,
    );
    this.nearest =
      supersample > 1 ? new NearestPass(resolution, supersample, this.format, this.drawn) : null;
    this.atlas = this.nearest?.result ?? this.drawn;
    this.cameras = new FaceCameras(fine, near, far);
    this.materials = new CollisionMaterials(
      { ...settings, resolution: fine, format: this.format },
      renderer,
      warnings,
    );
    this.axis = axis ? new AxisPass(resolution, this.atlas.texture) : null;
    const float = this.format !== 'RGBA8';
    this.ring = axis
      ? new ReadbackRing(gl, 6, 1, false)
      : new ReadbackRing(gl, width, height, float, ids);
    this.scheduler = settings.readback === 'async' ? ReadbackScheduler.of(gl) : null;
    renderer.domElement.addEventListener('webglcontextlost', onLost);
  }

  /** How far the next draw sees, metres. */
  reach(far: number): void {
    this.cameras.reach(far);
    this.materials.far = far;
  }

  dispose(): void {
    this.renderer.domElement.removeEventListener('webglcontextlost', this.onLost);
    // three still asks for the programs of materials that it is compiling.
    if (this.compiling !== null) void this.compiling.finally(() => this.#free());
    else this.#free();
  }

  #free(): void {
    this.drawn.dispose();
    this.nearest?.dispose();
    this.materials.dispose();
    this.axis?.dispose();
    this.ring.dispose();
  }
}

/** The format asked for, if the context can draw it; else the best that it can. */
function usableFormat(gl: WebGL2RenderingContext, wanted: TexelFormat | 'auto'): TexelFormat {
  return wanted !== 'auto' && canDraw(gl, wanted) ? wanted : bestTexelFormat(gl);
}
