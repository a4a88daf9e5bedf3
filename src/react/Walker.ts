import type { Camera, Group, Object3D, Vector3 } from 'three';
import type { CharacterCollider } from '../character/CharacterCollider.js';
import { CharacterController } from '../character/CharacterController.js';
import type { CharacterOptions } from '../character/characterOptions.js';
import { CharacterControls } from '../controls/CharacterControls.js';
import type { CharacterControlsOptions } from '../controls/controlsOptions.js';
import { DEFAULTS } from '../defaults.js';
import { AvatarPose } from './AvatarPose.js';
import { KeyWalk, type PressedKeys } from './KeyWalk.js';

/** A collider as React's components make and dispose of it: `CubeCollider` of either entry. */
export interface OwnedCollider extends CharacterCollider {
  /** Frees what it has on the GPU. */
  dispose(): void;
}

/** How long after the last change frames still come where they come on demand, seconds: late cubemaps may change more. */
const WAKEFUL = 0.6;

/** A character that says when it is asked to do something: a canvas that draws on demand may be asleep. */
class WakingCharacter extends CharacterController {
  onAsked: () => void = () => undefined;

  override teleport(position: Vector3): void {
    super.teleport(position);
    this.onAsked();
  }

  override walk(velocity: Vector3): void {
    super.walk(velocity);
    // Asked for again and again, standing still is no reason to stay awake.
    if (velocity.x !== 0 || velocity.y !== 0 || velocity.z !== 0) this.onAsked();
  }

  override move(displacement: Vector3): void {
    super.move(displacement);
    this.onAsked();
  }

  override jump(): boolean {
    this.onAsked();
    return super.jump();
  }

  override crouch(on: boolean): void {
    super.crouch(on);
    this.onAsked();
  }
}

/** What lives across frames of a `<Character>`: its collider, controller, controls and avatar. Knows nothing of React. */
export class Walker {
  readonly collider: OwnedCollider;
  readonly character: CharacterController;
  controls: CharacterControls | null = null;
  /** What drei's `KeyboardControls`, or whatever else, says is pressed. */
  keys: (() => PressedKeys) | null = null;
  /** m/s, of `keys`. */
  walkSpeed: number = DEFAULTS.controls.walkSpeed;
  runSpeed: number = DEFAULTS.controls.runSpeed;

  readonly #avatar: Group;
  readonly #keyWalk = new KeyWalk();
  readonly #pose = new AvatarPose();
  readonly #last: Vector3;
  #draws = 0;
  #still = 0;

  /** @param wake asks for a frame */
  constructor(
    collider: OwnedCollider,
    options: CharacterOptions,
    avatar: Group,
    readonly wake: () => void,
  ) {
    const character = new WakingCharacter(collider, { ...options, avatar });
    this.collider = collider;
    this.character = character;
    this.#avatar = avatar;
    this.#last = character.position.clone();
    character.onAsked = () => {
      this.#still = 0;
      wake();
    };
  }

  /** Listens to `element` and its document, for keys and mouse. */
  connect(camera: Camera, element: HTMLElement, options: CharacterControlsOptions): () => void {
    const controls = new CharacterControls(this.character, camera, element, options);
    this.controls = controls;
    return () => {
      controls.dispose();
      if (this.controls === controls) this.controls = null;
    };
  }

  /**
   * One frame: reads the input, moves the character, places avatar and camera.
   *
   * @param delta seconds since the last frame; the first after a sleep may be long
   * @returns whether another frame should follow
   */
  frame(renderer: unknown, scene: Object3D, camera: Camera, delta: number): boolean {
    const { character, controls } = this;
    const dt = Math.min(delta, DEFAULTS.character.maxDelta);
    if (controls !== null) {
      controls.object = camera;
      controls.update(dt);
    } else if (this.keys !== null) {
      this.#keyWalk.update(character, this.keys(), camera, this.walkSpeed, this.runSpeed, dt);
    }
    character.update(renderer, scene, delta);
    if (controls !== null) controls.follow(dt);
    else this.#pose.place(this.#avatar, character, this.#keyWalk.velocity, dt);
    return this.#isAwake(dt);
  }

  dispose(): void {
    this.controls?.dispose();
    this.character.dispose();
    this.collider.dispose();
  }

  #isAwake(dt: number): boolean {
    const { position, ready, stats } = this.character;
    const moved = !position.equals(this.#last);
    const waits = !ready || stats.draws !== this.#draws || this.#keyWalk.walks;
    this.#still = moved || waits ? 0 : this.#still + dt;
    this.#last.copy(position);
    this.#draws = stats.draws;
    return this.#still < WAKEFUL;
  }
}
