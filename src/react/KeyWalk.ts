import { type Camera, Vector3 } from 'three';
import type { CharacterController } from '../character/CharacterController.js';
import { catchUp } from '../controls/CameraRig.js';
import { DEFAULTS } from '../defaults.js';

/**
 * What is pressed, by name: `forward`, `back`, `left`, `right`, `run`, `jump`, `crouch`; `backward`, `leftward` and
 * `rightward` will do, too. As `useKeyboardControls()[1]` of drei gives it.
 */
export type PressedKeys = Readonly<Record<string, boolean | undefined>>;

/** Slower than this a character that stops has stopped, m/s. */
const STANDSTILL = 0.01;

const _forward = /* @__PURE__ */ new Vector3();
const _right = /* @__PURE__ */ new Vector3();
const _wish = /* @__PURE__ */ new Vector3();

/** Walks a character by keys, in the directions in which the camera looks. */
export class KeyWalk {
  /** What it asks for, world space, m/s. */
  readonly velocity = new Vector3();
  #walks = false;
  #jumped = false;
  #crouched = false;

  /** Whether it asks for a walk. */
  get walks(): boolean {
    return this.#walks;
  }

  /** @param delta seconds since the last call */
  update(
    character: CharacterController,
    keys: PressedKeys,
    camera: Camera,
    walkSpeed: number,
    runSpeed: number,
    delta: number,
  ): void {
    const ahead = pressed(keys, 'forward') - (pressed(keys, 'back') || pressed(keys, 'backward'));
    const aside =
      (pressed(keys, 'right') || pressed(keys, 'rightward')) -
      (pressed(keys, 'left') || pressed(keys, 'leftward'));
    const up = character.up as Vector3;
    camera.getWorldDirection(_forward).projectOnPlane(up);
    // Looking straight down, forward is where the camera's top is.
    if (_forward.lengthSq() < 1e-6) _forward.copy(camera.up).projectOnPlane(up);
    _right.crossVectors(_forward.normalize(), up);
    _wish.set(0, 0, 0).addScaledVector(_forward, ahead).addScaledVector(_right, aside);
    _wish.normalize().multiplyScalar(pressed(keys, 'run') ? runSpeed : walkSpeed);

    this.velocity.lerp(_wish, catchUp(DEFAULTS.controls.agility, delta));
    const idle = ahead === 0 && aside === 0;
    if (idle && this.velocity.lengthSq() < STANDSTILL * STANDSTILL) this.velocity.set(0, 0, 0);
    // Told once to stop, it is left alone: others may walk it.
    const walks = !idle || this.velocity.lengthSq() > 0;
    if (walks || this.#walks) character.walk(this.velocity);
    this.#walks = walks;

    const jumps = pressed(keys, 'jump') === 1;
    if (jumps && !this.#jumped) character.jump();
    this.#jumped = jumps;
    const crouches = pressed(keys, 'crouch') === 1;
    if (crouches !== this.#crouched) character.crouch(crouches);
    this.#crouched = crouches;
  }
}

const pressed = (keys: PressedKeys, name: string): number => (keys[name] === true ? 1 : 0);
