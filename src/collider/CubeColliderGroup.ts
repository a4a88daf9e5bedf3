import type { Object3D } from 'three';
import { DEFAULTS } from '../defaults.js';
import { Warnings } from '../Warnings.js';
import type { ColliderBase } from './ColliderBase.js';
import type { CubemapDevice, DeviceClient, DeviceHost } from './CubemapDevice.js';
import { DrawStamp } from './DrawStamp.js';
import { MOST_CUBEMAPS } from './FaceCameras.js';
import { GroupedDevice, type SharedDevice } from './GroupedDevice.js';
import { GroupScenery } from './GroupScenery.js';

/** Options of `CubeColliderGroup`. */
export interface CubeColliderGroupOptions {
  /** Cubemaps drawn and read in one update at most, from 1 to 60. Default 20. */
  size?: number;
}

/** What a group has done so far. */
export interface CubeColliderGroupStats {
  /** Updates that drew. */
  draws: number;
  /** Cubemaps drawn. */
  cubemaps: number;
  /** Reads, of several cubemaps each. */
  reads: number;
  /** Reads that had to be waited for, since they were older than half a second. */
  forced: number;
  /** Milliseconds the page has waited in reads, all together. */
  blocked: number;
  /** Milliseconds it waited in the last one. */
  lastBlocked: number;
  /** Colliders that have asked to be drawn and wait for their turn. */
  waiting: number;
}

/** What must be the same for all: they are drawn into one target, by one set of programs. */
const ALIKE = ['resolution', 'supersample', 'sides'] as const;

/** The cubemaps of one read, in its order. */
class Flight<Renderer> {
  /** Number of the read; 0 while there is none. */
  serial = 0;
  time = 0;
  readonly members: GroupedDevice<Renderer>[] = [];
}

/**
 * Many characters: the cubemaps of their colliders are drawn together, five in a render, into one atlas, and read back in
 * one read. Each keeps its own reach, and asks to be drawn when it needs it; who asked first is drawn first.
 *
 * ```js
 * const group = new CubeColliderGroup();
 * const characters = spawns.map((spawn) => {
 *   const collider = new CubeCollider();
 *   group.add(collider);
 *   const character = new CharacterController(collider);
 *   character.teleport(spawn);
 *   return character;
 * });
 * renderer.setAnimationLoop(() => {
 *   for (const character of characters) character.update(renderer, scene, delta);
 *   group.update(renderer, scene);
 *   renderer.render(scene, camera);
 * });
 * ```
 *
 * It serves colliders of either renderer, of one in a group. Asynchronous reading only.
 */
export class CubeColliderGroup<Renderer> {
  /** Cubemaps drawn and read in one update at most. */
  readonly size: number;
  /** What it has done so far. */
  readonly stats: CubeColliderGroupStats = {
    draws: 0,
    cubemaps: 0,
    reads: 0,
    forced: 0,
    blocked: 0,
    lastBlocked: 0,
    waiting: 0,
  };

  readonly #warnings = new Warnings('CubeColliderGroup');
  /** With each, whether it is updated by nobody but the group. */
  readonly #colliders = new Map<ColliderBase<Renderer>, boolean>();
  #gpu: CubemapDevice<Renderer> | null = null;
  readonly #members = new Set<GroupedDevice<Renderer>>();
  /** Who wants to be drawn, in the order in which they asked. */
  readonly #queue: GroupedDevice<Renderer>[] = [];
  readonly #flights = [new Flight<Renderer>(), new Flight<Renderer>()];
  readonly #sceneries: GroupScenery[];
  /** Those of them that are drawn now. */
  readonly #drawn: GroupScenery[] = [];
  readonly #stamp = new DrawStamp();
  #flight!: Flight<Renderer>;
  #serial = 0;
  /** Of each cubemap of the atlas. */
  readonly #data: (Float32Array | Uint8Array)[] = [];
  readonly #ids: (Uint32Array | null)[] = [];
  #updating = false;
  #disposed = false;
  readonly #client: DeviceClient = {
    deliver: () => this.#deliver(),
    urgent: () => this.#isUrgent(),
    lost: () => this.#release(),
  };
  readonly #afterDraw = (calls: number) => this.#takeOff(calls);
  readonly #host: DeviceHost<Renderer> = {
    deviceFor: (collider, renderer, client) =>
      this.#join(collider as ColliderBase<Renderer>, renderer, client),
    drawNow: () => this.#draw(),
  };
  readonly #shared: SharedDevice<Renderer>;

  /** @throws RangeError for a size that is no integer from 1 to 60 */
  constructor({ size = DEFAULTS.group.size }: CubeColliderGroupOptions = {}) {
    if (!Number.isInteger(size) || size < 1 || size > 60) {
      throw new RangeError(
        `CubeColliderGroup: "size" must be an integer from 1 to 60 (got ${size}).`,
      );
    }
    this.size = size;
    this.#sceneries = Array.from(
      { length: Math.ceil(size / MOST_CUBEMAPS) },
      () => new GroupScenery(),
    );
    const group = () => this.#gpu!;
    this.#shared = {
      get gpu() {
        return group();
      },
      ask: (member) => this.#queue.push(member),
      forget: (member) => this.#forget(member),
      leave: (member) => this.#members.delete(member),
    };
  }

  /** The colliders that it draws. */
  get colliders(): Iterable<ColliderBase<Renderer>> {
    return this.#colliders.keys();
  }

  /**
   * From now on `collider.update` asks this group to draw; a collider that nobody updates is drawn in every update of the
   * group. It begins anew, without a field.
   *
   * @throws TypeError for a collider that is read 'sync', is the paper's, or differs from those here in `resolution`,
   *   `supersample` or `sides`
   */
  add(collider: ColliderBase<Renderer>): this {
    if (collider?.isCubeCollider !== true) {
      throw new TypeError('CubeColliderGroup: add(collider) needs a CubeCollider.');
    }
    if (collider.output !== 'surface' || collider.readback !== 'async') {
      throw new TypeError(
        "CubeColliderGroup: its colliders need output: 'surface' and readback: 'async'.",
      );
    }
    const [first] = this.#colliders.keys();
    for (const option of ALIKE) {
      if (first === undefined || first[option] === collider[option]) continue;
      throw new TypeError(
        `CubeColliderGroup: "${option}" must be the same for all colliders of a group (got ${collider[option]}, ${first[option]}).`,
      );
    }
    if (!this.#colliders.has(collider)) {
      this.#colliders.set(collider, true);
      collider.drawnBy(this.#host);
    }
    return this;
  }

  /** Lets `collider` draw for itself again. */
  remove(collider: ColliderBase<Renderer>): this {
    if (this.#colliders.delete(collider)) collider.drawnBy(null);
    return this;
  }

  /**
   * Draws the colliders that have asked for it since, `size` of them at most, and starts their read. Call it once a frame,
   * after the characters' updates and before the scene is rendered.
   *
   * @param scene drawn for colliders that nobody updates; the others have said which
   * @returns whether it drew
   */
  update(renderer: Renderer, scene: Object3D): boolean {
    if (this.#disposed || !renderer || !scene) {
      this.#warnings.once(
        this.#disposed
          ? 'it was disposed; make a new one.'
          : 'update(renderer, scene) needs a renderer and a scene.',
      );
      return false;
    }
    this.#updating = true;
    for (const [collider, alone] of this.#colliders) if (alone) collider.update(renderer, scene);
    this.#updating = false;
    return this.#draw();
  }

  /** Frees everything on the GPU; the colliders draw for themselves again. */
  dispose(): void {
    for (const collider of this.#colliders.keys()) collider.drawnBy(null);
    this.#colliders.clear();
    this.#release();
    this.#disposed = true;
  }

  #join(
    collider: ColliderBase<Renderer>,
    renderer: Renderer,
    client: DeviceClient,
  ): CubemapDevice<Renderer> {
    if (this.#gpu !== null && this.#gpu.renderer !== renderer) this.#release();
    if (this.#gpu === null) {
      // Whose reach is shortest sees nearest.
      const near = Math.min(...[...this.#colliders.keys()].map((each) => each.near));
      this.#gpu = collider.createSharedDevice(renderer, near, this.size, this.#client);
      const { data, ids } = this.#gpu;
      const length = data.length / this.size;
      for (let i = 0; i < this.size; i++) {
        this.#data[i] = data.subarray(i * length, (i + 1) * length);
        this.#ids[i] = ids && ids.subarray(i * length, (i + 1) * length);
      }
    }
    if (!this.#updating) this.#colliders.set(collider, false);
    const member = new GroupedDevice(this.#shared, client);
    this.#members.add(member);
    return member;
  }

  #draw(): boolean {
    const gpu = this.#gpu;
    this.stats.waiting = this.#queue.length;
    if (gpu === null || this.#queue.length === 0) return false;
    if (!gpu.free && !this.#force(gpu)) return false;
    const count = Math.min(this.size, this.#queue.length);
    const flight = this.#flights.find(({ serial }) => serial === 0)!;
    this.#flight = flight;
    this.#drawn.length = flight.members.length = 0;
    for (let i = 0; i < count; i++) {
      const scenery = this.#sceneries[Math.floor(i / MOST_CUBEMAPS)]!;
      if (i % MOST_CUBEMAPS === 0) {
        scenery.clear();
        this.#drawn.push(scenery);
      }
      const member = this.#queue[i]!;
      scenery.add(member.wanted!);
      flight.members.push(member);
    }
    gpu.draw(this.#drawn, this.#afterDraw);
    this.stats.waiting = this.#queue.length;
    return true;
  }

  /** Drawn and still bound: every collider notes what it shows, then all are read together. */
  #takeOff(calls: number): void {
    const flight = this.#flight;
    const count = flight.members.length;
    flight.serial = ++this.#serial;
    flight.time = performance.now();
    this.#queue.splice(0, count);
    for (let i = 0; i < count; i++) flight.members[i]!.afterDraw(flight.serial, calls / count);
    this.#stamp.serial = flight.serial;
    this.#gpu!.start(this.#stamp, count);
    this.stats.draws++;
    this.stats.cubemaps += count;
  }

  /** Gives out every read that has come, the oldest first. */
  #deliver(): void {
    while (this.#deliverOldest());
  }

  #deliverOldest(): boolean {
    const start = performance.now();
    const stamp = this.#gpu?.finish(true) ?? null;
    if (stamp === null) return false;
    this.stats.lastBlocked = performance.now() - start;
    this.stats.blocked += this.stats.lastBlocked;
    this.stats.reads++;
    const flight = this.#flights.find(({ serial }) => serial === stamp.serial)!;
    flight.serial = 0;
    for (let i = 0; i < flight.members.length; i++) {
      flight.members[i]!.arrive(stamp.serial, this.#data[i]!, this.#ids[i]!);
    }
    flight.members.length = 0;
    return true;
  }

  /** On a page that keeps its GPU busy no read is ever free: one is waited for. @returns whether there is room now */
  #force(gpu: CubemapDevice<Renderer>): boolean {
    let oldest = Infinity;
    for (const { serial, time } of this.#flights) if (serial !== 0) oldest = Math.min(oldest, time);
    if (performance.now() - oldest < 1000 * DEFAULTS.collider.maxAge) return false;
    if (!this.#deliverOldest()) return false;
    this.stats.forced++;
    return gpu.free;
  }

  #isUrgent(): boolean {
    for (const { members } of this.#flights) {
      for (let i = 0; i < members.length; i++) if (members[i]!.client.urgent()) return true;
    }
    return false;
  }

  #forget(member: GroupedDevice<Renderer>): void {
    const place = this.#queue.indexOf(member);
    if (place >= 0) this.#queue.splice(place, 1);
  }

  /** Lets go of all that is on a GPU: disposed, another renderer, or the context lost. */
  #release(): void {
    const gpu = this.#gpu;
    if (gpu === null) return;
    for (const { client } of [...this.#members]) client.lost();
    this.#gpu = null;
    gpu.dispose();
    this.#queue.length = this.#data.length = this.#ids.length = 0;
    for (const flight of this.#flights) flight.serial = flight.members.length = 0;
    for (const scenery of this.#sceneries) scenery.release();
  }
}
