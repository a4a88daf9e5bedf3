import type { Material, RenderTarget } from 'three';
import type { TexelFormat } from '../cube/encoding.js';
import type { CubemapDevice, DeviceClient, Scenery } from './CubemapDevice.js';
import { DrawStamp } from './DrawStamp.js';
import type { Solidity } from './isSolid.js';

/** One cubemap that was drawn and is on its way. */
class GroupedRead extends DrawStamp {
  /** Number of the read that it is a part of; 0 while it is free. */
  flight = 0;
}

/** What a collider's share of a group's device asks of the group. */
export interface SharedDevice<Renderer> {
  readonly gpu: CubemapDevice<Renderer>;
  ask(member: GroupedDevice<Renderer>): void;
  forget(member: GroupedDevice<Renderer>): void;
  leave(member: GroupedDevice<Renderer>): void;
}

/**
 * A collider's share of the device of its group: what it draws waits for the group's next update, and comes back in a part
 * of the group's read.
 */
export class GroupedDevice<Renderer> implements CubemapDevice<Renderer> {
  readonly readNow = null;
  /** Its part of what the group has read last. */
  data!: Float32Array | Uint8Array;
  ids: Uint32Array | null = null;
  /** What it wants drawn; null while it wants nothing. */
  wanted: Scenery | null = null;
  /** Number of the read that its cubemap, being drawn now, is to be a part of. */
  flight = 0;
  readonly client: DeviceClient;
  readonly #shared: SharedDevice<Renderer>;
  readonly #reads = [new GroupedRead(), new GroupedRead()];
  #drawn: ((calls: number) => void) | null = null;
  #arrived: GroupedRead | null = null;

  constructor(shared: SharedDevice<Renderer>, client: DeviceClient) {
    this.#shared = shared;
    this.client = client;
  }

  get renderer(): Renderer {
    return this.#shared.gpu.renderer;
  }

  get format(): TexelFormat {
    return this.#shared.gpu.format;
  }

  get atlas(): RenderTarget {
    return this.#shared.gpu.atlas;
  }

  get inFlight(): number {
    let count = 0;
    for (const read of this.#reads) if (read.flight !== 0) count++;
    return count;
  }

  get free(): boolean {
    return this.wanted === null && this.inFlight < this.#reads.length;
  }

  dress(source: Material | Material[], solidity: Solidity): Material | Material[] {
    return this.#shared.gpu.dress(source, solidity);
  }

  draw(sceneries: readonly Scenery[], drawn: (calls: number) => void): void {
    this.wanted = sceneries[0]!;
    this.#drawn = drawn;
    this.#shared.ask(this);
  }

  /** The group has drawn what was wanted. @param calls draw calls, of all that was drawn with it */
  afterDraw(flight: number, calls: number): void {
    this.wanted = null;
    this.flight = flight;
    this.#drawn!(calls);
  }

  start(stamp: DrawStamp): void {
    const read = this.#reads.find(({ flight }) => flight === 0)!;
    read.take(stamp);
    read.flight = this.flight;
  }

  /** The group's read of that number has come, and with it this part. */
  arrive(flight: number, data: Float32Array | Uint8Array, ids: Uint32Array | null): void {
    const read = this.#reads.find((each) => each.flight === flight);
    if (read === undefined) return;
    read.flight = 0;
    this.data = data;
    this.ids = ids;
    this.#arrived = read;
    this.client.deliver();
    this.#arrived = null;
  }

  finish(): DrawStamp | null {
    return this.#arrived;
  }

  drop(): void {
    if (this.wanted !== null) this.#shared.forget(this);
    this.wanted = null;
    for (const read of this.#reads) {
      read.flight = 0;
      read.objects.clear();
    }
  }

  decodeMaxima(): void {
    throw new Error('CubeColliderGroup: the paper’s mode is drawn alone.');
  }

  compile(scenery: Scenery): Promise<boolean> {
    return this.#shared.gpu.compile(scenery);
  }

  dispose(): void {
    this.drop();
    this.#shared.leave(this);
  }
}
