import type { Scene, Vector3, WebGLRenderer } from 'three';
import { CharacterController, type CubeCollider } from 'three-cube-collider';
import { type Backend, createRendering, type Rendering } from '../../e2e/support/rendering.js';
import { HeldBackCollider } from './HeldBackCollider.js';
import { SHAPE } from '../rivals/shape.js';
import type { Walker, WalkerCounts } from '../rivals/Walker.js';

export interface CubeWalkerOptions {
  /**
   * Frames that each field is held back; 0 reads 'sync', 'real' reads asynchronously as shipped. With `WebGPURenderer`
   * 'real', or 1: then each frame waits until the fields that are on their way have come.
   */
  latency: number | 'real';
  /** @default 'WebGL2' */
  backend?: Backend;
  /** Further options of the `CubeCollider`. */
  collider?: Record<string, unknown>;
  /** Further options of the `CharacterController`. */
  character?: Record<string, unknown>;
}

/** Ours: the character as shipped, its cubemaps drawn by the GPU. The user's own picture is not drawn. */
export class CubeWalker implements Walker {
  preparation = 0;
  readonly #renderer: WebGLRenderer;
  readonly #scene: Scene;
  readonly #collider: CubeCollider;
  readonly #heldBack: HeldBackCollider | null;
  readonly #character: CharacterController<WebGLRenderer, Scene>;
  readonly #settles: boolean;

  private constructor(
    scene: Scene,
    { backend, renderer, collider: create }: Rendering,
    { latency, collider = {}, character }: CubeWalkerOptions,
  ) {
    this.#scene = scene;
    this.#renderer = renderer;
    renderer.setSize(16, 16);
    const waits = backend !== 'WebGL2';
    if (waits && latency !== 'real' && latency !== 1) {
      throw new Error(`With ${backend} a walk reads 'real' or one frame late, not ${latency}.`);
    }
    const readback = latency === 'real' ? 'async' : 'sync';
    this.#collider = create({ ...collider, output: 'surface', readback });
    this.#settles = waits && latency === 1;
    this.#heldBack =
      waits || latency === 'real' || latency === 0
        ? null
        : new HeldBackCollider(this.#collider, latency);
    const { radius, height, gravity, jumpHeight } = SHAPE;
    this.#character = new CharacterController<WebGLRenderer, Scene>(
      this.#heldBack ?? this.#collider,
      { radius, height, gravity, jumpHeight, ...character },
    );
  }

  /** Compiles the programs too. */
  static async create(scene: Scene, options: CubeWalkerOptions): Promise<CubeWalker> {
    const walker = new CubeWalker(scene, await createRendering(options.backend), options);
    const start = performance.now();
    await walker.#collider.compile(walker.#renderer, scene);
    walker.preparation = performance.now() - start;
    return walker;
  }

  /** To be awaited between frames. */
  async between(): Promise<void> {
    const { stats } = this.#collider;
    // What `invalidate` dropped never comes.
    for (let i = 0; this.#settles && stats.reads < stats.draws && i < 50; i++) {
      if (this.#collider.field?.serial === stats.draws) break;
      await new Promise<void>((resolve) => setTimeout(resolve));
    }
  }

  get foot(): Vector3 {
    return this.#character.body.position;
  }

  get waiting(): number {
    return this.#collider.stats.blocked;
  }

  get grounded(): boolean {
    return this.#character.grounded;
  }

  get ready(): boolean {
    return this.#character.ready;
  }

  place(foot: Vector3): void {
    this.#character.teleport(foot);
  }

  frame(velocity: Vector3, jump: boolean, dt: number): void {
    this.#heldBack?.frame();
    this.#character.walk(velocity);
    if (jump) this.#character.jump();
    this.#character.update(this.#renderer, this.#scene, dt);
  }

  counts(): WalkerCounts {
    const { draws, forced } = this.#collider.stats;
    return { draws, forced, ...stepCounts(this.#character) };
  }

  dispose(): void {
    this.#character.dispose();
    this.#collider.dispose();
    this.#renderer.dispose();
    // WebGPURenderer has none.
    (this.#renderer as Partial<WebGLRenderer>).forceContextLoss?.();
  }
}

/** Of a character that counts its steps; one that does not is judged all the same. */
function stepCounts(character: object): WalkerCounts {
  const { stats } = character as { stats?: { steps: number; held: number; slowed: number } };
  return stats ? { steps: stats.steps, held: stats.held, slowed: stats.slowed } : {};
}
