import type { Object3D, Scene, WebGLRenderer } from 'three';
import type { CharacterCollider, Survey } from '../../src/character/CharacterCollider.js';
import type { SurfaceField } from '../../src/field/SurfaceField.js';
import { copyField } from './copyField.js';

/** As many as the product has on their way at once. */
const IN_FLIGHT = 2;

/**
 * A collider whose fields arrive a fixed number of frames after they were drawn: the latency of an asynchronous
 * read-back, to the frame the same in every run. It draws with a 'sync' one and keeps what that sees until it is due.
 *
 * Harder than the real thing: it never waits for a read when the reach is about to run out.
 */
export class HeldBackCollider implements CharacterCollider<WebGLRenderer, Scene> {
  readonly readback = 'async';
  readonly output = 'surface';
  readonly maxima = null;
  field: SurfaceField | null = null;
  readonly #inner: CharacterCollider<WebGLRenderer, Scene>;
  readonly #late: number;
  readonly #pending: { field: SurfaceField; due: number }[] = [];
  /** Copies nobody may still look at: a published one is reused two fields later, as the product does. */
  readonly #spare: SurfaceField[] = [];
  readonly #published: SurfaceField[] = [];
  #frame = 0;

  /** @param late frames from a draw to the frame that can use it, 1 or more */
  constructor(inner: CharacterCollider<WebGLRenderer, Scene>, late: number) {
    this.#inner = inner;
    this.#late = late;
  }

  get position() {
    return this.#inner.position;
  }

  get autoFar(): boolean {
    return this.#inner.autoFar;
  }

  get far(): number {
    return this.#inner.far;
  }

  set far(far: number) {
    this.#inner.far = far;
  }

  /** Begins a frame: what is due arrives. */
  frame(): void {
    this.#frame++;
    while (this.#pending.length > 0 && this.#pending[0]!.due <= this.#frame) {
      this.field = this.#pending.shift()!.field;
      this.#published.push(this.field);
      if (this.#published.length > 2) this.#spare.push(this.#published.shift()!);
    }
  }

  update(renderer: WebGLRenderer, scene: Scene): boolean {
    if (this.#pending.length >= IN_FLIGHT) return false;
    this.#inner.update(renderer, scene);
    const drawn = this.#inner.field;
    if (drawn === null) return false;
    const field = copyField(drawn, this.#spare.pop() ?? null);
    this.#pending.push({ field, due: this.#frame + this.#late });
    return true;
  }

  survey(scene: Scene): Readonly<Survey> {
    return this.#inner.survey(scene);
  }

  invalidate(): void {
    for (const { field } of this.#pending) this.#spare.push(field);
    this.#pending.length = 0;
    this.field = null;
    this.#inner.invalidate();
  }

  exclude(object: Object3D): void {
    this.#inner.exclude(object);
  }

  include(object: Object3D): void {
    this.#inner.include(object);
  }
}
