import { type Camera, Euler, type Object3D, Vector3 } from 'three';
import type { Boom } from './Boom.js';
import { BoomSpring } from './BoomSpring.js';
import type { ControlledCharacter } from './ControlledCharacter.js';
import { nearRadius } from './nearRadius.js';

/** The boom leaves the head this far above the line of sight, radians: the avatar sits below the picture's middle. */
const BOOM_LIFT = 0.22;
/** The camera keeps this far above the plane of the foot, metres. */
const GROUND_CLEARANCE = 0.25;
/** Nearer than this to the head the avatar would fill the picture; from the second on it is all there, metres. */
const AVATAR_NEAR = 0.7;
const AVATAR_WHOLE = 1.3;
/** What the camera's near plane keeps to every surface, metres. */
const WALL_CLEARANCE = 0.05;
/** A rise of the foot that is walked, not teleported, metres in one frame. */
const LARGEST_STEP = 0.6;
/** Rates at which things settle, 1/s, before `smoothing` scales them. */
const STEP_RATE = 14;
const BOOM_RATE = 10;
const TURN_RATE = 12;
const EYE_RATE = 12;
/** An obstacle gone, the boom is out again in a second. */
const RELEASE_RATE = 5;
/** How fast a slope or a lift is told from a step, 1/s. */
const SLOPE_RATE = 8;
/** Lowest the eyes sink, metres. */
const LOWEST_EYE = 0.3;

const _euler = /* @__PURE__ */ new Euler(0, 0, 0, 'YXZ');
const _direction = /* @__PURE__ */ new Vector3();
const UP = /* @__PURE__ */ new Vector3(0, 1, 0);

/** Part of the way to go in `delta` seconds at `rate` 1/s: the same after a second at any frame rate. */
export function catchUp(rate: number, delta: number): number {
  return rate === Infinity ? 1 : 1 - Math.exp(-rate * delta);
}

/**
 * Puts a camera into a character's head or behind it, and turns its avatar where it walks.
 */
export class CameraRig {
  /** Scales every rate; Infinity takes each motion at once. */
  smoothing = 1;
  /** Keeps the boom out of walls; null lets it through. */
  boom: Boom | null = null;
  /** Metres from the head to the camera, as it was placed last. */
  length = 0;

  /** Length that the boom would have without obstacles; 0 in the head, NaN before the first frame, which does not glide. */
  #boom = NaN;
  readonly #spring = new BoomSpring();
  /** What is left to climb of the steps walked, metres. */
  #lag = 0;
  /** Speed at which slopes and lifts have raised it lately, m/s. */
  #rise = 0;
  /** How far the eyes have sunk with the body, metres. */
  #sunk = 0;
  #tallest = 0;
  /** Height of the eyes above the foot once they have sunk or risen, metres. */
  #eyes = 0;
  #character: ControlledCharacter | null = null;
  #lastY = NaN;
  #lastGrounded = false;
  #facing = NaN;

  /**
   * Places the camera.
   *
   * @param distance wanted from the head, metres; 0 in first person
   * @param eyeHeight above the foot, standing, metres
   * @param yaw about +Y, 0 looks along -Z, radians @param pitch up, radians
   */
  place(
    camera: Camera,
    character: ControlledCharacter,
    distance: number,
    eyeHeight: number,
    yaw: number,
    pitch: number,
    delta: number,
  ): void {
    const foot = character.position;
    this.#climb(foot.y, character, delta);
    eyeHeight = this.#sink(character, eyeHeight, delta);
    this.#boom = Number.isNaN(this.#boom) ? distance : this.#boom;
    this.#boom += (distance - this.#boom) * catchUp(BOOM_RATE * this.smoothing, delta);
    if (Math.abs(distance - this.#boom) < 1e-3) this.#boom = distance;

    const pivot = camera.position.copy(foot);
    pivot.y += eyeHeight + this.#lag;
    this.length = this.#boom;
    if (this.#boom > 0) {
      // Looking up would swing the boom into the ground: it stops there and only the camera tilts on.
      const drop = Math.max(eyeHeight - GROUND_CLEARANCE, 0) / this.#boom;
      const lowest = drop < 1 ? Math.asin(drop) : 0.5;
      _euler.set(Math.min(pitch - BOOM_LIFT, lowest), yaw, 0);
      _direction.set(0, 0, 1).applyEuler(_euler);
      if (this.boom !== null) this.#shorten(this.boom, camera, foot, distance, delta);
      pivot.addScaledVector(_direction, this.length);
    } else {
      this.#spring.reset();
    }
    camera.quaternion.setFromEuler(_euler.set(pitch, yaw, 0));
  }

  /**
   * Stands the avatar on the foot, turned to where the character walks.
   *
   * @param heading the direction it means to walk in, world space; its length does not matter, zero keeps the last
   */
  pose(
    avatar: Object3D,
    character: ControlledCharacter,
    heading: Vector3,
    yaw: number,
    delta: number,
  ): void {
    avatar.visible = this.length > AVATAR_NEAR;
    avatar.position.copy(character.position);
    // Its soles are on the ground, not on the gap that the body keeps.
    avatar.position.y += this.#lag - (character.skin ?? 0);
    if (Number.isNaN(this.#facing)) this.#facing = yaw + Math.PI;
    if (heading.x !== 0 || heading.z !== 0) {
      const turn = Math.atan2(heading.x, heading.z) - this.#facing;
      const shortest = turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
      this.#facing += shortest * catchUp(TURN_RATE * this.smoothing, delta);
    }
    avatar.rotation.set(0, this.#facing, 0);
  }

  /** How much of the avatar should be seen: 0 where the camera is in it, 1 from a little farther on. */
  get avatarOpacity(): number {
    const part = (this.length - AVATAR_NEAR) / (AVATAR_WHOLE - AVATAR_NEAR);
    return Math.max(0, Math.min(1, part));
  }

  /** Cuts the boom to what is free. The pivot stands in `camera.position`, the way in `_direction`. */
  #shorten(boom: Boom, camera: Camera, foot: Vector3, distance: number, delta: number): void {
    const pivot = camera.position;
    const radius = nearRadius(camera) + WALL_CLEARANCE;
    const eased = pivot.y - (foot.y + this.#eyes);
    if (eased > 0) {
      // On the way down, or into a crouch, the head is eased from above: up there may be a ceiling.
      pivot.y -= eased;
      pivot.y += boom.reach(pivot, UP, eased, radius);
    }
    // On its way out it is asked for all of its way: it may have to look farther first.
    const most = Math.max(this.#boom, distance);
    const free = boom.reach(pivot, _direction, most, radius);
    this.length = this.#spring.update(this.#boom, free, RELEASE_RATE * this.smoothing, delta);
  }

  /** The eyes sink with a body that crouches, and rise with it again. Returns their height above the foot, metres. */
  #sink(character: ControlledCharacter, eyeHeight: number, delta: number): number {
    if (character !== this.#character) {
      this.#character = character;
      this.#tallest = 0;
    }
    const height = character.body?.height ?? 0;
    this.#tallest = Math.max(this.#tallest, height);
    const wanted = this.#tallest - height;
    this.#sunk += (wanted - this.#sunk) * catchUp(EYE_RATE * this.smoothing, delta);
    if (Math.abs(wanted - this.#sunk) < 1e-3) this.#sunk = wanted;
    this.#eyes = wanted === 0 ? eyeHeight : Math.max(eyeHeight - wanted, LOWEST_EYE);
    return this.#sunk === 0 ? eyeHeight : Math.max(eyeHeight - this.#sunk, LOWEST_EYE);
  }

  /**
   * A step is climbed at once by the body; the eye takes a moment. Slopes and lifts are followed without that delay, or
   * the avatar would wade in them; falls and jumps are not smoothed, they would lag.
   */
  #climb(y: number, { grounded, velocity }: ControlledCharacter, delta: number): void {
    const rise = y - this.#lastY;
    const small = Math.abs(rise) < LARGEST_STEP;
    if (grounded && this.#lastGrounded && small) {
      this.#rise += (velocity.y - this.#rise) * catchUp(SLOPE_RATE * this.smoothing, delta);
      this.#lag -= rise - this.#rise * delta;
    } else {
      this.#rise = 0;
      if (!small) this.#lag = 0;
    }
    this.#lag -= this.#lag * catchUp(STEP_RATE * this.smoothing, delta);
    this.#lag = Math.max(-LARGEST_STEP, Math.min(LARGEST_STEP, this.#lag));
    this.#lastY = y;
    this.#lastGrounded = grounded;
  }
}
