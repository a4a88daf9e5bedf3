import type { RenderTarget, StorageBufferAttribute, WebGPURenderer } from 'three/webgpu';
import type { DeviceClient } from '../collider/CubemapDevice.js';
import type { DrawStamp } from '../collider/DrawStamp.js';
import { ReadbackRing } from '../collider/ReadbackRing.js';
import { type ReadbackClient, ReadbackScheduler } from '../collider/ReadbackScheduler.js';
import { backendOf } from './backendOf.js';
import { MappedRing } from './MappedRing.js';

/** Reads a target of float texels, on either backend, or a buffer of them, on WebGPU. */
export interface TexelReads {
  readonly data: Float32Array;
  readonly inFlight: number;
  readonly free: boolean;
  /**
   * Starts to read what was just drawn into the target.
   *
   * @param rows how many of the target's, from the first on; all, if left out
   */
  start(stamp: DrawStamp, rows?: number): void;
  /** Reads it at once, waiting for the GPU; null where that cannot be done. */
  readonly readNow: (() => void) | null;
  /** @param oldest not the newest that has come, dropping the others */
  finish(oldest?: boolean): DrawStamp | null;
  drop(): void;
  dispose(): void;
}

export function createReads(
  renderer: WebGPURenderer,
  source: RenderTarget | StorageBufferAttribute,
  client: DeviceClient,
): TexelReads {
  return backendOf(renderer).isWebGPUBackend === true
    ? new MappedReads(renderer, source, client)
    : new FallbackReads(renderer, source as RenderTarget, client);
}

/** WebGPU: never blocks. */
class MappedReads implements TexelReads {
  readonly readNow = null;
  readonly data: Float32Array;
  readonly #ring: MappedRing;
  readonly #source: () => GPUTexture | GPUBuffer;

  constructor(
    renderer: WebGPURenderer,
    source: RenderTarget | StorageBufferAttribute,
    client: DeviceClient,
  ) {
    const backend = backendOf(renderer);
    const arrived = () => client.deliver();
    if ('texture' in source) {
      const { width, height, texture } = source;
      this.#ring = new MappedRing(backend.device!, width, height, arrived);
      this.#source = () => backend.get(texture).texture!;
    } else {
      this.#ring = new MappedRing(backend.device!, source.count, 1, arrived);
      this.#source = () => backend.get(source).buffer!;
    }
    this.data = this.#ring.data;
  }

  get inFlight(): number {
    return this.#ring.inFlight;
  }

  get free(): boolean {
    return this.#ring.free;
  }

  start(stamp: DrawStamp, rows?: number): void {
    this.#ring.start(this.#source(), stamp, rows);
  }

  finish(oldest?: boolean): DrawStamp | null {
    return this.#ring.finish(oldest);
  }

  drop(): void {
    this.#ring.drop();
  }

  dispose(): void {
    this.#ring.dispose();
  }
}

/** The WebGL 2 fallback: as for `WebGLRenderer`, once the GPU has nothing queued. */
class FallbackReads implements TexelReads {
  readonly data: Float32Array;
  readonly #ring: ReadbackRing;
  readonly #scheduler: ReadbackScheduler;
  readonly #waiting: ReadbackClient;
  readonly #renderer: WebGPURenderer;
  readonly #target: RenderTarget;
  #framebuffer: WebGLFramebuffer | null = null;

  constructor(renderer: WebGPURenderer, target: RenderTarget, client: DeviceClient) {
    const gl = backendOf(renderer).gl!;
    this.#renderer = renderer;
    this.#target = target;
    this.#ring = new ReadbackRing(gl, target.width, target.height, true);
    this.#scheduler = ReadbackScheduler.of(gl);
    this.#waiting = {
      deliver: () => client.deliver(),
      urgent: () => client.urgent() && this.#ring.fenced,
    };
    this.data = this.#ring.data as Float32Array;
  }

  get inFlight(): number {
    return this.#ring.inFlight;
  }

  get free(): boolean {
    return this.#ring.free;
  }

  start(stamp: DrawStamp, rows?: number): void {
    this.#read(() => this.#ring.start(stamp, rows));
    this.#scheduler.wait(this.#waiting);
  }

  /** On a page that keeps its GPU busy the queue never drains, and no read would ever come. */
  readonly readNow = (): void => this.#read(() => this.#ring.readNow());

  finish(oldest?: boolean): DrawStamp | null {
    return this.#ring.finish(oldest);
  }

  drop(): void {
    this.#ring.drop();
    this.#scheduler.cancel(this.#waiting);
  }

  dispose(): void {
    this.drop();
    this.#ring.dispose();
    backendOf(this.#renderer).gl!.deleteFramebuffer(this.#framebuffer);
  }

  #read(read: () => void): void {
    const { gl, state } = backendOf(this.#renderer) as Required<ReturnType<typeof backendOf>>;
    // By three's own hand: it remembers what is bound.
    state.bindFramebuffer(gl.READ_FRAMEBUFFER, this.#attached(gl, state));
    read();
    state.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
  }

  #attached(
    gl: WebGL2RenderingContext,
    state: { bindFramebuffer(target: number, framebuffer: WebGLFramebuffer | null): void },
  ): WebGLFramebuffer {
    if (this.#framebuffer !== null) return this.#framebuffer;
    const framebuffer = gl.createFramebuffer();
    const { textureGPU } = backendOf(this.#renderer).get(this.#target.texture);
    state.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(
      gl.READ_FRAMEBUFFER,
      gl.COLOR_ATTACHMENT0,
      gl.TEXTURE_2D,
      textureGPU!,
      0,
    );
    return (this.#framebuffer = framebuffer);
  }
}
