import { type Object3D, Vector3 } from 'three';
import type { CharacterController, ControlledCharacter } from 'three-cube-collider';
import { SHAPE } from '../../bench/rivals/shape.js';
import type { Walker } from '../../bench/rivals/Walker.js';
import type { Rival } from './contestants.js';

/** What the demo asks of who walks. */
export type RaceCharacter = ControlledCharacter &
  Pick<CharacterController, 'ready' | 'ground' | 'crouched'>;

/** A rival as `CharacterControls` drive it. It knows no ground by name, no crouching and no platforms. */
export class RivalCharacter implements RaceCharacter {
  readonly position = new Vector3();
  readonly velocity = new Vector3();
  readonly avatar: Object3D;
  readonly body = { height: SHAPE.height };
  readonly skin: number;
  readonly ready = true;
  readonly ground = null;
  readonly crouched = false;
  readonly #walker: Walker;
  readonly #longest: number;
  readonly #wish = new Vector3();
  #jump = false;

  constructor(walker: Walker, { longest, skin }: Rival, avatar: Object3D) {
    this.#walker = walker;
    this.#longest = longest;
    this.skin = skin;
    this.avatar = avatar;
  }

  get grounded(): boolean {
    return this.#walker.grounded;
  }

  walk(velocity: Vector3): void {
    this.#wish.copy(velocity);
  }

  jump(): void {
    this.#jump = true;
  }

  /** Puts the foot somewhere, at rest. */
  place(foot: Vector3): void {
    this.#walker.place(foot);
    this.position.copy(foot);
    this.velocity.set(0, 0, 0);
    this.#wish.set(0, 0, 0);
    this.#jump = false;
  }

  update(delta: number): void {
    const dt = Math.min(delta, this.#longest);
    if (!(dt > 0)) return;
    this.#walker.frame(this.#wish, this.#jump, dt);
    this.#jump = false;
    const { foot } = this.#walker;
    this.velocity.subVectors(foot, this.position).divideScalar(dt);
    this.position.copy(foot);
    if (!this.grounded) return;
    // A step climbed in one frame is no speed; a slope of 45° is.
    const most = Math.hypot(this.velocity.x, this.velocity.z);
    this.velocity.y = Math.min(most, Math.max(-most, this.velocity.y));
  }
}
