import { type Material, Object3D, type RenderTarget, Vector3 } from 'three';
import type { AxisMaxima } from '../cube/AxisMaxima.js';
import type { TexelFormat } from '../cube/encoding.js';
import type { SurfaceField } from '../field/SurfaceField.js';
import { Warnings } from '../Warnings.js';
import { type CubeColliderSettings, checkFar } from './CubeColliderOptions.js';
import { type CubeColliderStats, emptyStats } from './CubeColliderStats.js';
import type { CubemapDevice, DeviceClient, DeviceHost, Scenery } from './CubemapDevice.js';
import { DrawStamp } from './DrawStamp.js';
import type { Solidity, TransparentPolicy } from './isSolid.js';
import { NewestRead } from './NewestRead.js';
import type { ObjectProxy } from './objectProxy.js';
import { ObjectWarnings } from './ObjectWarnings.js';
import { PrivateScene } from './PrivateScene.js';
import { SceneIndex } from './SceneIndex.js';
import type { SelectionRules } from './SceneWalk.js';
import { Selection } from './Selection.js';
import { Survey, type SurveyReport } from './Survey.js';

/** How long `compile` looks for the triangles of huge meshes, milliseconds; the rest is found frame by frame. */
const LOOKING = 1000;

const worldPosition = new Vector3();

/**
 * All of a collider but what depends on the renderer, which its `CubemapDevice` does: see `CubeCollider`, of which there
 * is one for each renderer.
 */
export abstract class ColliderBase<Renderer> extends Object3D {
  /** As three's own objects tell it. */
  override readonly type = 'CubeCollider';
  /** Tells it from other objects. */
  readonly isCubeCollider = true;
  /** 'surface' fills `field`, 'axis' fills `maxima`. */
  readonly output: 'surface' | 'axis';
  /** Texels per face edge. */
  readonly resolution: number;
  /** How many times finer along each edge it is drawn than read. */
  readonly supersample: 1 | 2 | 4;
  /** Nearest distance seen along a face's axis, metres. */
  readonly near: number;
  /** The user gave no `far` for surfaces: a character may set it to what its body and speed need. */
  readonly autoFar: boolean;
  /** Paper's mode: distance at which red is 1, metres. */
  readonly rMin: number;
  /** Paper's mode: radius of the sphere, metres. */
  readonly rMax: number;
  /** 'sync' has a field as soon as `update` returns. */
  readonly readback: 'async' | 'sync';
  /** 'both' sides of a triangle are solid, or as 'drawn'. */
  readonly sides: 'both' | 'drawn';
  /** What transparent things are: no obstacles ('ignore'), or 'solid'. */
  readonly transparent: TransparentPolicy;
  /** Called for each mesh within reach; false makes it no obstacle. */
  filter: ((object: Object3D) => boolean) | null;
  /** What it has done so far. */
  readonly stats: CubeColliderStats = emptyStats();

  readonly #settings: CubeColliderSettings;
  readonly #excluded = new Set<Object3D>();
  readonly #warnings = new Warnings('CubeCollider');
  readonly #objectWarnings = new ObjectWarnings(this.#warnings);
  readonly #index = new SceneIndex((sensor) => this.#objectWarnings.sensor(sensor));
  readonly #selection = new Selection(this.#index);
  readonly #survey = new Survey(this.#index);
  readonly #scene = new PrivateScene();
  readonly #newest: NewestRead;
  #gpu: CubemapDevice<Renderer> | null = null;
  #host: DeviceHost<Renderer> | null = null;
  #far: number;
  #updates = 0;
  #urgent = false;
  #waiters: (() => void)[] = [];
  #disposed = false;
  readonly #stamp = new DrawStamp();
  readonly #rules: SelectionRules;
  readonly #dress = (source: Material | Material[], solidity: Solidity) =>
    this.#gpu!.dress(source, solidity);
  /** Where and when the draw under way is, and whether it is read at once. */
  readonly #center = new Vector3();
  #time = 0;
  #now = false;
  readonly #scenery: Scenery;
  readonly #sceneries: readonly Scenery[];
  /** The user's scene, from when it is to be drawn until it is. */
  #selected: Object3D | null = null;
  readonly #drawn = (calls: number) => this.#afterDraw(calls);
  readonly #client: DeviceClient = {
    deliver: () => this.#deliver(),
    // The first field is worth a wait for what is queued behind it.
    urgent: () => this.#urgent || (this.#newest.field ?? this.#newest.maxima) === null,
    lost: () => this.#release(),
  };

  /** @param settings checked already */
  protected constructor(settings: CubeColliderSettings) {
    super();
    this.#settings = settings;
    this.output = settings.output;
    this.resolution = settings.resolution;
    this.supersample = settings.supersample;
    this.near = settings.near;
    this.#far = settings.far;
    this.autoFar = settings.autoFar;
    this.rMin = settings.rMin;
    this.rMax = settings.rMax;
    this.readback = settings.readback;
    this.sides = settings.sides;
    this.transparent = settings.transparent;
    this.#rules = {
      layers: this.layers,
      excluded: this.#excluded,
      transparent: settings.transparent,
      filter: (object) => this.#passes(object),
      faulty: (mesh, fault) => this.#objectWarnings.obstacle(mesh, fault),
    };
    this.filter = settings.filter;
    this.#newest = new NewestRead(settings, this.stats);
    this.#scenery = {
      scene: this.#scene,
      centers: [this.#center],
      far: settings.far,
      select: () => this.#select(),
    };
    this.#sceneries = [this.#scenery];
  }

  /**
   * Reach of the next draw, metres; a field knows its own.
   *
   * @throws RangeError where it is set to what is not finite or not greater than `near`
   */
  get far(): number {
    return this.#far;
  }

  set far(far: number) {
    this.#far = checkFar(far, this.near, this.output === 'axis' ? this.rMax : 0);
  }

  /** The newest surfaces, or null before the first. It is overwritten two fields later; copy what must last. */
  get field(): SurfaceField | null {
    return this.#newest.field;
  }

  /** The paper's mode: the newest maxima, or null before the first. Overwritten by the next. */
  get maxima(): AxisMaxima | null {
    return this.#newest.maxima;
  }

  /**
   * The atlas that is read: 3×2 tiles of resolution² texels, the nearest ones where `supersample` draws finer; null
   * before the first update.
   */
  get renderTarget(): RenderTarget | null {
    return this.#gpu?.atlas ?? null;
  }

  /** How texels are stored; the paper's mode is always RGBA8. Null before the first update, if left to 'auto'. */
  get format(): TexelFormat | null {
    if (this.#gpu !== null) return this.#gpu.format;
    if (this.output === 'axis') return 'RGBA8';
    return this.#settings.format === 'auto' ? null : this.#settings.format;
  }

  /** Objects left out with all below them. */
  get excluded(): ReadonlySet<Object3D> {
    return this.#excluded;
  }

  /** Leaves `object` and what is below it out of the cubemap. */
  exclude(object: Object3D): void {
    this.#excluded.add(object);
  }

  /** Takes `object` back in. */
  include(object: Object3D): void {
    this.#excluded.delete(object);
  }

  /**
   * Draws the cubemap around this object's world position and starts its read-back; with 'sync' finishes it too. Call
   * it at the start of a frame, before the scene is rendered.
   *
   * @param patient never to wait for a read because of the way made since the last one came (`slack`), as a
   *   `CharacterController` asks, which goes no farther than its fields vouch for. Default false
   * @returns whether it drew; not while two reads are on their way, nor where it warns
   */
  update(renderer: Renderer, scene: Object3D, patient = false): boolean {
    if (!this.#usable(renderer, scene)) return false;
    this.#updates++;
    const gpu = this.#resources(renderer);
    const center = worldPosition.setFromMatrixPosition(this.matrixWorld);
    if (this.readback === 'sync') {
      this.#draw(gpu, scene, center, true);
    } else if (
      gpu.readNow !== null &&
      this.#newest.runsOut(patient ? null : center, this.#updates, gpu.inFlight > 0)
    ) {
      // One wait, for what is here and now; the reads on their way are older.
      this.stats.forced++;
      gpu.drop();
      this.#draw(gpu, scene, center, true);
      this.#settle();
    } else if (gpu.free) {
      this.#draw(gpu, scene, center, false);
    } else {
      this.stats.skipped++;
      return false;
    }
    return true;
  }

  /**
   * `update`, resolved once what it drew has been read: for tests, tools and loading screens. Unless the read-back is
   * 'sync' it does not block, however far the collider has moved.
   *
   * @returns the field; null in the paper's mode (whose `maxima` are then fresh), where `update` could not draw, and
   *   where `invalidate`, `dispose` or a lost context came between
   */
  async updateAsync(renderer: Renderer, scene: Object3D): Promise<SurfaceField | null> {
    if (!this.#usable(renderer, scene)) return null;
    if (this.readback === 'sync') {
      this.update(renderer, scene);
    } else {
      this.#updates++;
      const gpu = this.#resources(renderer);
      // Reads on their way are of no more use: what is asked for is newer.
      gpu.drop();
      this.#draw(gpu, scene, worldPosition.setFromMatrixPosition(this.matrixWorld), false);
      this.#urgent = true;
      this.#host?.drawNow();
      await new Promise<void>((resolve) => this.#waiters.push(resolve));
    }
    return this.#newest.field;
  }

  /**
   * Looks at what is solid around the last draw, by the same rules and within the same reach, and brings the world
   * matrices of what is near up to date; draws nothing. Whoever keeps a field for many frames asks this in each: it
   * costs what is near, and an eighth of the scene's other objects, whatever their triangles.
   *
   * Without a draw, or after `invalidate`, everything is `changed`. What cannot be surveyed (no scene, disposed) it
   * warns of once, and reports nothing.
   *
   * @returns the same object each time
   */
  survey(scene: Object3D): Readonly<SurveyReport> {
    if (!this.#alive() || !this.#isScene(scene, 'survey(scene)')) return this.#survey.nothing();
    this.updateWorldMatrix(true, false);
    const center = worldPosition.setFromMatrixPosition(this.matrixWorld);
    try {
      this.#selection.prepare();
      return this.#survey.look(scene, center, this.#reach, this.#rules);
    } catch (error) {
      this.#warnings.once(`the scene cannot be surveyed: ${String(error)}`, 'survey');
      return this.#survey.nothing();
    }
  }

  /**
   * Compiles the programs for what is in `scene`, and looks for where the triangles of its huge meshes are, up to a second,
   * in slices between which the page goes on: so that the first `update` neither stutters nor draws all of them.
   */
  async compile(renderer: Renderer, scene: Object3D): Promise<void> {
    if (!this.#usable(renderer, scene)) return;
    const gpu = this.#resources(renderer);
    const center = worldPosition.setFromMatrixPosition(this.matrixWorld).clone();
    // Again, where a material could not be wrapped and something plainer takes its place.
    while (this.#gpu === gpu && (await this.#compileOnce(gpu, scene, center)));
    const end = performance.now() + LOOKING;
    while (this.#gpu === gpu && this.#selection.prepare() && performance.now() < end) {
      await new Promise((resolve) => setTimeout(resolve));
    }
  }

  /** @returns whether some programs turned out not to work */
  #compileOnce(gpu: CubemapDevice<Renderer>, scene: Object3D, center: Vector3): Promise<boolean> {
    // In a group a draw may be waiting for its turn.
    const waiting = { scene: this.#selected, center: this.#center.clone(), far: this.#scenery.far };
    this.#selected = scene;
    this.#center.copy(center);
    this.#scenery.far = Infinity;
    const compiled = gpu.compile(this.#scenery);
    this.#selected = waiting.scene;
    this.#center.copy(waiting.center);
    this.#scenery.far = waiting.far;
    this.#selection.forget();
    return compiled;
  }

  /** Forgets every field, those on their way included: after a teleport, or when scenery changed at a stroke. */
  invalidate(): void {
    this.#newest.forget(this.#updates);
    this.#survey.forget();
    this.#gpu?.drop();
    this.#settle();
  }

  /** For `CubeColliderGroup`: who draws it from now on; null for itself. It begins anew. */
  drawnBy(host: DeviceHost<Renderer> | null): void {
    this.#release();
    this.#host = host;
  }

  /** For `CubeColliderGroup`: a device that draws as this collider's own would, but as many cubemaps at once. */
  createSharedDevice(
    renderer: Renderer,
    near: number,
    cubemaps: number,
    client: DeviceClient,
  ): CubemapDevice<Renderer> {
    const settings = { ...this.#settings, near, cubemaps };
    return this.createDevice(renderer, settings, client, this.#warnings);
  }

  /** Frees everything on the GPU. Afterwards `update` does nothing. */
  override dispose(): void {
    this.#release();
    this.#disposed = true;
  }

  /** Copies the newest read and decodes it. */
  #deliver(): void {
    const gpu = this.#gpu;
    if (gpu === null) return;
    const start = performance.now();
    const stamp = gpu.finish();
    this.#blocked(start);
    if (stamp !== null) this.#publish(gpu, stamp);
    this.#settle();
  }

  #publish(gpu: CubemapDevice<Renderer>, stamp: DrawStamp): void {
    const start = performance.now();
    this.#newest.publish(gpu, stamp, this.#updates);
    this.stats.decoding += performance.now() - start;
  }

  /** Select, draw, and read (`now`, or start to): what was drawn last is still bound then. */
  #draw(gpu: CubemapDevice<Renderer>, scene: Object3D, center: Vector3, now: boolean): void {
    this.#now = now;
    this.#selected = scene;
    this.#center.copy(center);
    this.#scenery.far = this.#far;
    const { stats } = this;
    const start = performance.now();
    // What is done meanwhile and counted on its own.
    const others = stats.selecting + stats.blocked + stats.decoding;
    gpu.draw(this.#sceneries, this.#drawn);
    const counted = stats.selecting + stats.blocked + stats.decoding - others;
    if (this.#host === null) stats.submitting += performance.now() - start - counted;
  }

  #afterDraw(calls: number): void {
    const gpu = this.#gpu!;
    this.#selected = null;
    this.stats.drawCalls = calls;
    this.stats.draws++;
    this.stats.far = this.#scenery.far;
    this.#survey.note(this.#selection.proxies, this.#center, this.#drawReach);
    const stamp = this.#stampNow();
    if (!this.#now) {
      gpu.start(stamp);
      return;
    }
    const start = performance.now();
    gpu.readNow!();
    this.#blocked(start);
    this.#publish(gpu, stamp);
  }

  /** Within what the next draw selects, metres. */
  get #reach(): number {
    return this.output === 'axis' ? this.rMax : this.#far;
  }

  /** Within what the draw under way selects, metres. */
  get #drawReach(): number {
    const { far } = this.#scenery;
    return this.output === 'axis' && far < Infinity ? this.rMax : far;
  }

  #select(): readonly ObjectProxy[] {
    const { proxies } = this.#selection;
    this.#time = performance.now();
    this.#selection.select(
      this.#selected!,
      this.#center,
      this.#drawReach,
      this.#rules,
      this.#dress,
    );
    this.#scene.children = proxies;
    this.stats.objects = proxies.length;
    this.stats.selecting += performance.now() - this.#time;
    return proxies;
  }

  /** The user's filter; one that throws is no reason to let the character through. */
  #passes(object: Object3D): boolean {
    if (this.filter === null) return true;
    try {
      return this.filter(object) !== false;
    } catch (error) {
      this.#warnings.once(`"filter" threw ${String(error)}; the object counts as solid.`, 'filter');
      return true;
    }
  }

  #stampNow(): DrawStamp {
    const stamp = this.#stamp;
    stamp.center.copy(this.#center);
    stamp.far = this.#scenery.far;
    if (this.output === 'surface') {
      this.stats.deforming = stamp.objects.take(this.#selection.proxies);
    }
    stamp.time = this.#time;
    stamp.serial = this.stats.draws;
    stamp.update = this.#updates;
    return stamp;
  }

  #blocked(start: number): void {
    this.stats.lastBlocked = performance.now() - start;
    this.stats.blocked += this.stats.lastBlocked;
  }

  #settle(): void {
    this.#urgent = false;
    for (const resolve of this.#waiters) resolve();
    this.#waiters.length = 0;
  }

  /** May it draw? Else it has said once why not. Brings the world matrix up to date. */
  #usable(renderer: Renderer, scene: Object3D): boolean {
    if (!this.#alive()) return false;
    const fault = this.faultOf(renderer);
    if (fault !== null) {
      if (fault !== '') this.#warnings.once(`${fault} It keeps its last field.`);
    } else if (this.#isScene(scene, 'update(renderer, scene)')) {
      this.updateWorldMatrix(true, false);
      const { x, y, z } = worldPosition.setFromMatrixPosition(this.matrixWorld);
      if (Number.isFinite(x + y + z)) return true;
      this.#warnings.once(
        'its position is not finite; place it before updating. It keeps its last field.',
      );
    }
    return false;
  }

  #alive(): boolean {
    if (this.#disposed) this.#warnings.once('it was disposed; make a new one.');
    return !this.#disposed;
  }

  #isScene(scene: Object3D | undefined, call: string): boolean {
    if (scene?.isObject3D) return true;
    this.#warnings.once(`${call} needs a scene. It keeps its last field.`);
    return false;
  }

  /** Lets go of all that is on a GPU: disposed, another renderer, or the context lost (the next update begins anew). */
  readonly #release = (): void => {
    this.invalidate();
    this.#selected = null;
    this.#selection.clear();
    this.#survey.clear();
    this.#index.clear();
    this.#newest.clear();
    this.#stamp.objects.clear();
    this.#gpu?.dispose();
    this.#gpu = null;
  };

  #resources(renderer: Renderer): CubemapDevice<Renderer> {
    if (this.#gpu !== null && this.#gpu.renderer !== renderer) this.#release();
    if (this.#gpu === null) {
      this.#gpu =
        this.#host === null
          ? this.createDevice(renderer, this.#settings, this.#client, this.#warnings)
          : this.#host.deviceFor(this, renderer, this.#client);
      const { format } = this.#settings;
      if (this.output === 'surface' && format !== 'auto' && format !== this.#gpu.format) {
        this.#warnings.once(
          `"format" ${format} cannot be drawn here; ${this.#gpu.format} is taken. Leave it at 'auto'.`,
        );
      }
    }
    return this.#gpu;
  }

  /** Why a renderer cannot be drawn with, as a sentence; empty while it cannot yet or no more, null if it can. */
  protected abstract faultOf(renderer: Renderer): string | null;

  /** What it needs on a renderer's GPU. */
  protected abstract createDevice(
    renderer: Renderer,
    settings: CubeColliderSettings,
    client: DeviceClient,
    warnings: Warnings,
  ): CubemapDevice<Renderer>;
}
