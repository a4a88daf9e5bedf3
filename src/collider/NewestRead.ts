import type { Vector3 } from 'three';
import { AxisMaxima } from '../cube/AxisMaxima.js';
import { decodeSurface } from '../cube/encoding.js';
import { sharedDirections } from '../cube/texelDirections.js';
import { SurfaceField } from '../field/SurfaceField.js';
import type { CubeColliderSettings } from './CubeColliderOptions.js';
import type { CubeColliderStats } from './CubeColliderStats.js';
import type { CubemapDevice } from './CubemapDevice.js';
import type { DrawStamp } from './DrawStamp.js';

/**
 * Updates without any data after which some are waited for, however busy the GPU: half a second, in which it may upload a
 * level and compile for it. A character without a field stands meanwhile.
 */
const PATIENCE = 30;

/** The newest cubemap that came back, decoded, and how far and how long it serves. */
export class NewestRead {
  /** Newest surfaces; null before the first, and always in the paper's mode. */
  field: SurfaceField | null = null;
  /** Newest maxima; null before the first, and always but in the paper's mode. */
  maxima: AxisMaxima | null = null;

  /** Written in turn: the newest stays whole while the next is decoded. */
  readonly #fields: SurfaceField[] = [];
  /** Shared by both. */
  #directions: Float32Array | null = null;
  readonly #axisMaxima: AxisMaxima;
  readonly #settings: CubeColliderSettings;
  readonly #stats: CubeColliderStats;
  #time = 0;
  #update = 0;

  constructor(settings: CubeColliderSettings, stats: CubeColliderStats) {
    this.#settings = settings;
    this.#stats = stats;
    this.#axisMaxima = new AxisMaxima(settings.rMin, settings.rMax);
  }

  /** Decodes what the device has read last. @param update number of the update it arrives in */
  publish(gpu: CubemapDevice<unknown>, stamp: DrawStamp, update: number): void {
    if (this.#settings.output === 'axis') {
      gpu.decodeMaxima(this.#axisMaxima);
      this.#axisMaxima.center.copy(stamp.center);
      this.maxima = this.#axisMaxima;
    } else {
      const { resolution, supersample } = this.#settings;
      this.#directions ??= sharedDirections(resolution);
      const next = (this.#fields[this.#stats.reads % 2] ??= new SurfaceField(
        resolution,
        stamp.far,
        // Drawn finer, each texel of each field has a direction of its own.
        supersample > 1 ? this.#directions.slice() : this.#directions,
      ));
      next.far = stamp.far;
      next.center.copy(stamp.center);
      next.time = stamp.time;
      next.serial = stamp.serial;
      decodeSurface(gpu.format, gpu.data, next, gpu.ids, supersample);
      stamp.objects.handTo(next);
      this.field = next;
    }
    this.#time = stamp.time;
    this.#update = update;
    this.#stats.reads++;
    this.#stats.latency = performance.now() - stamp.time;
    this.#stats.latencyUpdates = update - stamp.update;
  }

  /** Forgets what it has. @param update number of the update it happens in */
  forget(update: number): void {
    this.field = null;
    this.maxima = null;
    this.#update = update;
  }

  /** Lets go of the fields, and with them of the user's objects; whoever still holds one has it whole. */
  clear(): void {
    this.field = null;
    this.maxima = null;
    this.#fields.length = 0;
  }

  /**
   * Must the next be waited for? If the reach or the age of this one is about to run out, or there has been none for
   * too long.
   *
   * @param center where the collider is now, world space; null if its way does not count
   * @param update number of this update
   * @param inFlight whether a newer one is on its way, and late
   */
  runsOut(center: Vector3 | null, update: number, inFlight: boolean): boolean {
    const newest = this.maxima ?? this.field;
    if (newest === null) return update - this.#update > PATIENCE;
    if (center !== null) {
      const { slack, slackRatio, far } = this.#settings;
      const reach = this.field === null ? far : this.field.far;
      if (newest.center.distanceTo(center) > (slack ?? slackRatio * reach)) return true;
    }
    return inFlight && performance.now() - this.#time > 1000 * this.#settings.maxAge;
  }
}
