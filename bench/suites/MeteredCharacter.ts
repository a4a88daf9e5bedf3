import type { Scene, Vector3, WebGLRenderer } from 'three';
import { CharacterController, type CubeCollider } from 'three-cube-collider';
import type { Backend, Rendering } from '../../e2e/support/rendering.js';
import { SHAPE } from '../rivals/shape.js';
import { disposeRendering, findTriangles, gpuOf, tryRendering } from './ours.js';
import { FRAME, later, mean, nextFrame } from './pace.js';
import { Stopwatch } from './Stopwatch.js';
import { watchTasks } from './watchTasks.js';

/** How long a field is waited for at most, milliseconds: what was dropped never comes. */
const PATIENCE = 2000;

/** Main-thread milliseconds of a frame of ours. */
export interface FrameCost {
  /** The sum of the others. */
  whole: number;
  /** Looking at what is near, with and without a draw. */
  select: number;
  /** Handing the draw to the GPU, and asking for the read. */
  submit: number;
  /** Asking whether the read has come. */
  poll: number;
  /** Copying what has come. */
  read: number;
  /** Making a field of it, and surfels of that. */
  decode: number;
  /** Moving the character. */
  solve: number;
}

/** Names of the parts for readers. */
const PARTS = {
  select: 'select',
  submit: 'submit',
  poll: 'ask for the read',
  read: 'read back',
  decode: 'decode',
  solve: 'solve',
} as const;

/** Means of the parts over a walk, as figures. */
export function partsOf(costs: readonly FrameCost[]): Record<string, number> {
  const figures: Record<string, number> = {};
  for (const [part, name] of Object.entries(PARTS)) {
    figures[`${name}, ms`] = mean(costs.map((cost) => cost[part as keyof FrameCost]));
  }
  return figures;
}

const nothing = (): FrameCost => ({
  whole: 0,
  select: 0,
  submit: 0,
  poll: 0,
  read: 0,
  decode: 0,
  solve: 0,
});

/**
 * Our character as shipped, reading asynchronously, with clocks around it.
 *
 * Times are of the main thread alone: those of calls, and of the callbacks that they leave for later. A frame begins when
 * the field drawn in the last has come, as on a GPU that has the time: so that a software GPU, which works on the same
 * processor, is done by then, and is neither waited for nor in the way. Where the page must wait for the GPU all the same
 * (a read that is forced, a command buffer that is full), that is in the times.
 */
export class MeteredCharacter {
  readonly character: CharacterController<WebGLRenderer, Scene>;
  readonly collider: CubeCollider;
  readonly #rendering: Rendering;
  readonly #scene: Scene;
  readonly #surveying: Stopwatch;
  readonly #drawing: Stopwatch;
  readonly #submitting: Stopwatch;
  #cost = nothing();
  #reads = 0;
  #unwatch: () => void = () => {};

  private constructor(rendering: Rendering, scene: Scene) {
    this.#rendering = rendering;
    this.#scene = scene;
    this.collider = rendering.collider();
    const { radius, height, gravity, jumpHeight } = SHAPE;
    this.character = new CharacterController<WebGLRenderer, Scene>(this.collider, {
      radius,
      height,
      gravity,
      jumpHeight,
    });
    this.#surveying = new Stopwatch().around(this.collider, 'survey');
    this.#drawing = new Stopwatch().around(this.collider, 'update');
    this.#submitting = new Stopwatch().around(rendering.renderer, 'render');
    const { gl, device } = gpuOf(rendering);
    if (gl) this.#submitting.around(gl, 'clearBufferfv', 'readPixels', 'flush');
    if (device) this.#submitting.around(device.queue, 'submit');
  }

  /** Programs compiled, triangles found around where it will stand. @returns null where the browser has no such backend */
  static async create(
    backend: Backend,
    scene: Scene,
    foot: Vector3,
  ): Promise<MeteredCharacter | null> {
    const rendering = await tryRendering(backend);
    if (rendering === null) return null;
    const made = new MeteredCharacter(rendering, scene);
    await made.collider.compile(rendering.renderer, scene);
    await findTriangles(made.collider, rendering, scene, foot);
    return made;
  }

  /** Clocks what is left for later during `walk`, of this character alone. */
  async watched<T>(walk: () => Promise<T>): Promise<T> {
    this.#unwatch = watchTasks((milliseconds) => this.#note(milliseconds), {
      frames: this.#rendering.backend === 'WebGL2',
    });
    try {
      return await walk();
    } finally {
      this.#unwatch();
    }
  }

  /** The page's next frame, and all that follows from it until what it drew has come. */
  async frame(velocity: Vector3, jump: boolean): Promise<FrameCost> {
    await nextFrame();
    const { character, collider } = this;
    const { stats } = collider;
    const { blocked } = stats;
    this.#submitting.take();
    const start = performance.now();
    // Asked whether it is ready it takes over a new field, as it would in its update.
    void character.ready;
    const taken = performance.now();
    character.walk(velocity);
    if (jump) character.jump();
    character.update(this.#rendering.renderer, this.#scene, FRAME);
    const end = performance.now();

    const survey = this.#surveying.take();
    const draw = this.#drawing.take();
    // A forced read is waited for within the draw.
    const waited = stats.blocked - blocked;
    const submit = Math.max(0, this.#submitting.take() - waited);
    const cost = this.#cost;
    cost.decode += taken - start;
    cost.select += survey + draw - submit - waited;
    cost.submit += submit;
    cost.read += waited;
    cost.solve += end - taken - survey - draw;
    cost.whole += end - start;
    this.#reads = stats.reads;
    await this.#arrived();
    this.#cost = nothing();
    return cost;
  }

  /** Milliseconds from the newest field's draw to its arrival, the GPU's work included. */
  get latency(): number {
    return this.collider.stats.latency;
  }

  dispose(): void {
    this.character.dispose();
    this.collider.dispose();
    disposeRendering(this.#rendering);
  }

  /** A callback has come and gone: one that brought a read, or one that asked in vain. */
  #note(milliseconds: number): void {
    const { reads, lastBlocked } = this.collider.stats;
    const cost = this.#cost;
    cost.whole += milliseconds;
    if (reads === this.#reads) {
      cost.poll += milliseconds;
      return;
    }
    this.#reads = reads;
    cost.read += lastBlocked;
    cost.decode += milliseconds - lastBlocked;
  }

  async #arrived(): Promise<void> {
    const { stats } = this.collider;
    const end = performance.now() + PATIENCE;
    while (stats.reads < stats.draws && this.collider.field?.serial !== stats.draws) {
      if (performance.now() > end) return;
      await later(1);
    }
  }
}
