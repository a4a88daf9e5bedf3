import type { Material, RenderTarget, WebGPURenderer } from 'three/webgpu';
import { ATLAS_ROWS, atlasSize } from '../cube/atlas.js';
import type { AxisMaxima } from '../cube/AxisMaxima.js';
import type { CubeColliderSettings } from '../collider/CubeColliderOptions.js';
import type { CubemapDevice, DeviceClient, Scenery } from '../collider/CubemapDevice.js';
import type { DrawStamp } from '../collider/DrawStamp.js';
import { FaceCameras, MOST_CUBEMAPS } from '../collider/FaceCameras.js';
import type { Solidity } from '../collider/isSolid.js';
import { type AxisReduction, ComputedAxisReduction, DrawnAxisReduction } from './AxisReduction.js';
import { backendOf } from './backendOf.js';
import { watchLoss } from './deviceLoss.js';
import { ClippedScenery } from './ClippedScenery.js';
import { DrawnProxies } from './DrawnProxies.js';
import { NearestQuad } from './NearestQuad.js';
import { NodeCollisionMaterials } from './NodeCollisionMaterials.js';
import { NodeRendererState } from './NodeRendererState.js';
import { giveOwnSkeleton } from './ownSkeleton.js';
import { createReads, type TexelReads } from './TexelReads.js';
import { createFloatTarget } from './texelTargets.js';

/** A collider's part on the GPU of a `WebGPURenderer`, on its WebGPU backend or its WebGL 2 fallback. */
export class WebGPUDevice implements CubemapDevice<WebGPURenderer> {
  /** In the paper's mode too: its reds have the steps of 8 bits. */
  readonly format = 'RGBA32F';
  readonly ids = null;
  /** What scenery is drawn into; its rows count downward. */
  readonly #drawn: RenderTarget;
  readonly #cameras: FaceCameras;
  readonly #materials: NodeCollisionMaterials;
  readonly #nearest: NearestQuad;
  /** The search for the maxima; null if surfaces are read. */
  readonly #axis: AxisReduction | null;
  readonly #resolution: number;
  readonly #state = new NodeRendererState();
  readonly #clipped = new ClippedScenery();
  readonly #proxies = new DrawnProxies();
  readonly #reads: TexelReads;
  readonly #unwatch: () => void;

  constructor(
    readonly renderer: WebGPURenderer,
    settings: CubeColliderSettings,
    client: DeviceClient,
  ) {
    const { resolution, supersample, near, far, output, cubemaps } = settings;
    const fine = resolution * supersample;
    const together = Math.min(cubemaps, MOST_CUBEMAPS);
    // One render's cubemaps after the other are drawn into the same texels.
    const { width, height } = atlasSize(fine, together);
    const { device } = backendOf(renderer);
    this.#drawn = createFloatTarget(width, height, true);
    const upward = device !== undefined;
    this.#nearest = new NearestQuad(resolution, supersample, this.#drawn, cubemaps, upward);
    this.#cameras = new FaceCameras(fine, near, far, together);
    this.#materials = new NodeCollisionMaterials(settings, (source) => this.#proxies.free(source));
    this.#axis = output === 'axis' ? createReduction(resolution, this.atlas, device) : null;
    this.#resolution = resolution;
    this.#reads = createReads(renderer, this.#axis?.result ?? this.atlas, client);
    this.#unwatch = watchLoss(renderer, () => client.lost());
  }

  get atlas(): RenderTarget {
    return this.#nearest.result;
  }

  get data(): Float32Array {
    return this.#reads.data;
  }

  get inFlight(): number {
    return this.#reads.inFlight;
  }

  get readNow(): (() => void) | null {
    return this.#reads.readNow;
  }

  get free(): boolean {
    return this.#reads.free;
  }

  dress(source: Material | Material[], solidity: Solidity): Material | Material[] {
    return this.#materials.for(source, solidity);
  }

  draw(sceneries: readonly Scenery[], drawn: (calls: number) => void): void {
    const { renderer } = this;
    this.#state.enter(renderer);
    try {
      let calls = 0;
      for (let i = 0; i < sceneries.length; i++) calls += this.#render(sceneries[i]!, i);
      this.#axis?.reduce(renderer);
      drawn(calls);
    } finally {
      this.#state.leave(renderer);
    }
  }

  start(stamp: DrawStamp, cubemaps?: number): void {
    const rows = ATLAS_ROWS * this.#resolution;
    this.#reads.start(stamp, cubemaps === undefined ? undefined : cubemaps * rows);
  }

  finish(oldest?: boolean): DrawStamp | null {
    return this.#reads.finish(oldest);
  }

  drop(): void {
    this.#reads.drop();
  }

  decodeMaxima(target: AxisMaxima): void {
    const { data } = this;
    for (let face = 0; face < 6; face++) {
      const at = 4 * face;
      target.set(face, data[at]!, data[at + 1]!, data[at + 2]!, this.#resolution);
    }
  }

  /**
   * By drawing it once. three's `compileAsync` goes on under whatever state the user's renderer has then, so that its
   * programs are others, and fails where the user's own is under way.
   */
  async compile(scenery: Scenery): Promise<boolean> {
    this.draw([inOneFace(scenery)], () => {});
    await backendOf(this.renderer).device?.queue.onSubmittedWorkDone();
    return false;
  }

  dispose(): void {
    this.#unwatch();
    this.#reads.dispose();
    this.#drawn.dispose();
    this.#nearest.dispose();
    this.#axis?.dispose();
    this.#materials.dispose();
    this.#proxies.clear();
  }

  /** @param i number of the render, each of which but the last draws five cubemaps. @returns draw calls */
  #render(scenery: Scenery, i: number): number {
    const { renderer } = this;
    this.#cameras.moveTo(scenery.centers);
    if (scenery.far < Infinity) {
      this.#cameras.reach(scenery.far);
      this.#materials.far = scenery.far;
    }
    this.#arrange(scenery);
    renderer.autoClear = true;
    renderer.setRenderTarget(this.#drawn);
    const before = renderer.info.render.drawCalls;
    renderer.render(scenery.scene, this.#cameras);
    const calls = renderer.info.render.drawCalls - before;
    this.#nearest.reduce(renderer, MOST_CUBEMAPS * i);
    return calls;
  }

  #arrange(scenery: Scenery): void {
    const { scene } = scenery;
    const proxies = scenery.select();
    this.#proxies.note(proxies);
    for (const proxy of proxies) giveOwnSkeleton(proxy);
    scene.children = this.#clipped.arrange(proxies);
    // The clear colour, which is ours here.
    scene.background = null;
  }
}

/** Programs do not depend on the face, and what is huge is drawn whole for once. */
function inOneFace(scenery: Scenery): Scenery {
  const { scene, centers, far } = scenery;
  const select = () => {
    const proxies = scenery.select();
    for (const { layers } of proxies) layers.set(0);
    return proxies;
  };
  return { scene, centers, far, select };
}

function createReduction(
  resolution: number,
  atlas: RenderTarget,
  device: GPUDevice | undefined,
): AxisReduction {
  return device === undefined
    ? new DrawnAxisReduction(resolution, atlas)
    : new ComputedAxisReduction(resolution, atlas);
}
