import type { Material, RenderTarget, Scene, Vector3 } from 'three';
import type { AxisMaxima } from '../cube/AxisMaxima.js';
import type { TexelFormat } from '../cube/encoding.js';
import type { DrawStamp } from './DrawStamp.js';
import type { Solidity } from './isSolid.js';
import type { ObjectProxy } from './objectProxy.js';

/** What a device asks of the collider whose cubemaps it draws. */
export interface DeviceClient {
  /** A read has come: `finish` costs nothing now. */
  deliver(): void;
  /** Is somebody waiting for the read, so that it may cost something? */
  urgent(): boolean;
  /** The GPU is lost: let go of the device, while deleting what it held is still allowed. */
  lost(): void;
}

/** Who draws several colliders' cubemaps together. */
export interface DeviceHost<Renderer> {
  /** The part of its device that a collider's cubemaps have. */
  deviceFor(collider: object, renderer: Renderer, client: DeviceClient): CubemapDevice<Renderer>;
  /** Draws what waits for it. */
  drawNow(): void;
}

/** What one render shows: the scenery of a cubemap, or of up to five. */
export interface Scenery {
  /** To be rendered: holds the proxies that `select` leaves. */
  readonly scene: Scene;
  /** Of each cubemap, world space. */
  readonly centers: readonly Vector3[];
  /**
   * Reach, metres; whoever draws it among others may set it higher before `select`. Infinity where everything is to be
   * prepared, and nothing seen.
   */
  far: number;
  /** Selects and dresses the proxies anew. */
  select(): readonly ObjectProxy[];
}

/**
 * Everything a collider keeps on one renderer's GPU, and all that differs from renderer to renderer: how a cubemap is
 * drawn there, and how its texels come back. There is one for `WebGLRenderer` and one for `WebGPURenderer`; the rest of
 * the package knows neither.
 */
export interface CubemapDevice<Renderer> {
  readonly renderer: Renderer;
  /** How texels are stored. */
  readonly format: TexelFormat;
  /** The atlas that is read. */
  readonly atlas: RenderTarget;
  /** The texels read last, 4 numbers each, bottom row first. In the paper's mode, red, column and row of six maxima. */
  readonly data: Float32Array | Uint8Array;
  /** The ids read last, 4 numbers a texel; null of formats that hold them in the texels. */
  readonly ids: Uint32Array | null;
  /** Reads on their way. */
  readonly inFlight: number;
  /** Whether one more may be started. */
  readonly free: boolean;

  /** The material to draw a user's with. @param solidity which of several are obstacles */
  dress(source: Material | Material[], solidity: Solidity): Material | Material[];
  /**
   * Draws cubemaps, a render for each scenery, and finds the maxima in the paper's mode. The renderer is as it was
   * afterwards.
   *
   * @param sceneries one; of several cubemaps, all but the last with the centres of five
   * @param drawn called while what was drawn can be read, by `start` or `readNow`, with the number of draw calls
   */
  draw(sceneries: readonly Scenery[], drawn: (calls: number) => void): void;
  /**
   * Starts to read what was just drawn; takes the stamp's table of objects.
   *
   * @param cubemaps how many of the atlas's, from the first on
   */
  start(stamp: DrawStamp, cubemaps?: number): void;
  /** Reads what was just drawn, waiting for it; null where a renderer cannot wait. */
  readonly readNow: (() => void) | null;
  /**
   * Makes `data` and `ids` those of the newest read on its way, and drops the older ones.
   *
   * @param oldest those of the oldest instead, dropping none
   * @returns what was drawn then, or null if no read is on its way
   */
  finish(oldest?: boolean): DrawStamp | null;
  /** Forgets the reads on their way. */
  drop(): void;
  /** In the paper's mode: decodes `data`. */
  decodeMaxima(target: AxisMaxima): void;
  /**
   * Prepares the programs for what `scenery` shows, as far as may be without drawing it.
   *
   * @returns whether some turned out not to work, so that it is to be done again
   */
  compile(scenery: Scenery): Promise<boolean>;
  dispose(): void;
}
