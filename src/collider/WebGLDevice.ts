import type { Material, WebGLRenderer, WebGLRenderTarget } from 'three';
import { ATLAS_ROWS, atlasSize } from '../cube/atlas.js';
import type { AxisMaxima } from '../cube/AxisMaxima.js';
import { hasIdTexture, type TexelFormat } from '../cube/encoding.js';
import type { Warnings } from '../Warnings.js';
import { AxisPass } from './AxisPass.js';
import { CollisionMaterials } from './CollisionMaterials.js';
import type { CubeColliderSettings } from './CubeColliderOptions.js';
import type { CubemapDevice, DeviceClient, Scenery } from './CubemapDevice.js';
import type { DrawStamp } from './DrawStamp.js';
import { FaceCameras, MOST_CUBEMAPS } from './FaceCameras.js';
import type { Solidity } from './isSolid.js';
import { NearestPass } from './NearestPass.js';
import { isSignalled, ReadbackRing } from './ReadbackRing.js';
import { type ReadbackClient, ReadbackScheduler } from './ReadbackScheduler.js';
import { RendererState } from './RendererState.js';
import { bestTexelFormat, canDraw, clearTexels, createTexelTarget } from './texelTarget.js';

/** Longest that programs are waited for, milliseconds. */
const COMPILING = 5000;

/** A collider's part on the GPU of a `WebGLRenderer`. */
export class WebGLDevice implements CubemapDevice<WebGLRenderer> {
  readonly format: TexelFormat;
  readonly atlas: WebGLRenderTarget;
  /** What scenery is drawn into; the atlas itself, unless it is drawn finer. */
  readonly #drawn: WebGLRenderTarget;
  /** Of one cubemap, as read. */
  readonly #rows: number;
  readonly #cameras: FaceCameras;
  readonly #materials: CollisionMaterials;
  /** The search for the maxima; null if surfaces are read. */
  readonly #axis: AxisPass | null;
  /** Keeps the nearest of what is drawn finer; null if it is not. */
  readonly #nearest: NearestPass | null;
  readonly #state = new RendererState();
  readonly #ring: ReadbackRing;
  /** Finds the moments for asynchronous reads; null if they are synchronous. */
  readonly #scheduler: ReadbackScheduler | null;
  readonly #waiting: ReadbackClient;
  readonly #lost: () => void;
  /** Pending while programs are being compiled. */
  #compiling: Promise<unknown> | null = null;
  #disposed = false;

  constructor(
    readonly renderer: WebGLRenderer,
    settings: CubeColliderSettings,
    client: DeviceClient,
    warnings: Warnings,
  ) {
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const { resolution, supersample, near, far, output, cubemaps } = settings;
    const fine = resolution * supersample;
    const together = Math.min(cubemaps, MOST_CUBEMAPS);
    const axis = output === 'axis';
    this.format = axis ? 'RGBA8' : usableFormat(gl, settings.format);
    const ids = !axis && hasIdTexture(this.format);
    const { width, height } = atlasSize(resolution, cubemaps);
    // Drawn finer, one render's cubemaps after the other are drawn into the same texels.
    const drawn = supersample > 1 ? atlasSize(fine, together) : { width, height };
    this.#drawn = createTexelTarget(drawn.width, drawn.height, this.format, true, ids);
    this.#nearest =
      supersample > 1
        ? new NearestPass(resolution, supersample, this.format, this.#drawn, cubemaps)
        : null;
    this.atlas = this.#nearest?.result ?? this.#drawn;
    this.#rows = ATLAS_ROWS * resolution;
    this.#cameras = new FaceCameras(fine, near, far, together);
    this.#materials = new CollisionMaterials(
      { ...settings, resolution: fine, format: this.format },
      renderer,
      warnings,
    );
    this.#axis = axis ? new AxisPass(resolution, this.atlas.texture) : null;
    const float = this.format !== 'RGBA8';
    this.#ring = axis
      ? new ReadbackRing(gl, 6, 1, false)
      : new ReadbackRing(gl, width, height, float, ids);
    this.#scheduler = settings.readback === 'async' ? ReadbackScheduler.of(gl) : null;
    this.#waiting = {
      deliver: () => client.deliver(),
      urgent: () => client.urgent() && this.#ring.fenced,
    };
    this.#lost = () => client.lost();
    renderer.domElement.addEventListener('webglcontextlost', this.#lost);
  }

  get data(): Float32Array | Uint8Array {
    return this.#ring.data;
  }

  get ids(): Uint32Array | null {
    return this.#ring.ids;
  }

  get inFlight(): number {
    return this.#ring.inFlight;
  }

  get free(): boolean {
    return this.#ring.free;
  }

  dress(source: Material | Material[], solidity: Solidity): Material | Material[] {
    return this.#materials.for(source, solidity);
  }

  draw(sceneries: readonly Scenery[], drawn: (calls: number) => void): void {
    const { renderer } = this;
    this.#state.enter(renderer, this.#materials.shaderFailed);
    try {
      let calls = 0;
      for (let i = 0; i < sceneries.length; i++) calls += this.#render(sceneries[i]!, i);
      this.#axis?.reduce(renderer);
      drawn(calls);
    } finally {
      this.#state.leave(renderer);
    }
  }

  /** @param i number of the render, each of which but the last draws five cubemaps. @returns draw calls */
  #render(scenery: Scenery, i: number): number {
    const { renderer } = this;
    const first = MOST_CUBEMAPS * i;
    this.#cameras.drawInto(this.#nearest === null ? first : 0);
    this.#cameras.moveTo(scenery.centers);
    this.#cameras.reach(scenery.far);
    this.#materials.far = scenery.far;
    let before: number;
    do {
      scenery.select();
      before = renderer.info.render.calls;
      if (this.#nearest !== null || i === 0) clearTexels(renderer, this.#drawn);
      renderer.render(scenery.scene, this.#cameras);
      // At once again, where a material could not be wrapped and something plainer takes its place.
    } while (this.#materials.giveUp());
    const calls = renderer.info.render.calls - before;
    this.#nearest?.reduce(renderer, first);
    return calls;
  }

  start(stamp: DrawStamp, cubemaps?: number): void {
    this.#ring.start(stamp, cubemaps === undefined ? undefined : cubemaps * this.#rows);
    this.#scheduler!.wait(this.#waiting);
  }

  readonly readNow = (): void => this.#ring.readNow();

  finish(oldest?: boolean): DrawStamp | null {
    return this.#ring.finish(oldest);
  }

  drop(): void {
    this.#ring.drop();
    this.#scheduler?.cancel(this.#waiting);
  }

  decodeMaxima(target: AxisMaxima): void {
    this.#axis!.decode(this.#ring.data as Uint8Array, target);
  }

  async compile(scenery: Scenery): Promise<boolean> {
    const { renderer } = this;
    const worn = new Set(scenery.select().flatMap(({ material }) => material));
    this.#state.enter(renderer, this.#materials.shaderFailed);
    try {
      renderer.setRenderTarget(this.#drawn);
      this.#compiling = renderer.compileAsync(scenery.scene, this.#cameras);
      this.#axis?.compile(renderer);
      this.#nearest?.compile(renderer);
    } finally {
      this.#state.leave(renderer);
    }
    await this.#compiling;
    // Where three cannot ask whether a program is ready it takes it for granted: asked too early, the page would stand.
    await drained(renderer.getContext() as WebGL2RenderingContext);
    this.#compiling = null;
    if (this.#disposed) return false;
    this.#state.enter(renderer, this.#materials.shaderFailed);
    try {
      this.#materials.finish(worn);
    } finally {
      this.#state.leave(renderer);
    }
    return this.#materials.giveUp();
  }

  dispose(): void {
    this.#disposed = true;
    this.drop();
    this.renderer.domElement.removeEventListener('webglcontextlost', this.#lost);
    // three still asks for the programs of materials that it is compiling.
    if (this.#compiling !== null) void this.#compiling.finally(() => this.#free());
    else this.#free();
  }

  #free(): void {
    this.#drawn.dispose();
    this.#nearest?.dispose();
    this.#materials.dispose();
    this.#axis?.dispose();
    this.#ring.dispose();
  }
}

/** Resolved, without waiting for it, once the GPU has done all that it was told so far; or has not in a while. */
async function drained(gl: WebGL2RenderingContext): Promise<void> {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (fence === null) return;
  gl.flush();
  const end = performance.now() + COMPILING;
  while (!gl.isContextLost() && !isSignalled(gl, fence) && performance.now() < end) {
    await new Promise((resolve) => setTimeout(resolve, 4));
  }
  gl.deleteSync(fence);
}

/** The format asked for, if the context can draw it; else the best that it can. */
function usableFormat(gl: WebGL2RenderingContext, wanted: TexelFormat | 'auto'): TexelFormat {
  return wanted !== 'auto' && canDraw(gl, wanted) ? wanted : bestTexelFormat(gl);
}
