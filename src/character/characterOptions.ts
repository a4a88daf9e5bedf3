import { type Object3D, Vector3 } from 'three';
import { DEFAULTS } from '../defaults.js';
import type { CollisionResponse } from '../response/CollisionResponse.js';
import type { SlideResponse } from '../response/SlideResponse.js';

/** How a character is built and moves. Metres and seconds; defaults are in `DEFAULTS.character`. */
export interface CharacterOptions {
  /** Radius of the body, > 0. Default 0.35. A collider in the paper's mode wants the same as its `rMax`. */
  radius?: number;
  /** From foot to crown, >= 2 · radius. Default 1.8. `AxisResponse` collides the lowest 2 · radius of it. */
  height?: number;
  /** The same while crouched, >= 2 · radius. Default 1.1, or `height` if that is less. */
  crouchHeight?: number;
  /** Downward acceleration, m/s², >= 0; 0 to swim or fly by `move`. Default 20. */
  gravity?: number;
  /** Fastest fall, m/s, > 0. Default 50. */
  terminalSpeed?: number;
  /** Rise of a jump's foot, >= 0. Default 1.1. */
  jumpHeight?: number;
  /** Gap kept to every surface, 0.005 or more and at most a quarter of `radius`. Default 0.02. */
  skin?: number;
  /** Steepest slope that is walked and stood on, radians, 0 to π/2. Default 50°. */
  slopeLimit?: number;
  /** Highest step climbed without a jump, >= 0. Default 0.4. */
  stepHeight?: number;
  /** How far down it follows ground that it walks off, >= 0. Default 0.4. */
  snapDistance?: number;
  /** How long after it left the ground it may still jump, >= 0. Default 0.1. */
  coyoteTime?: number;
  /** How long a jump asked for before landing is remembered, >= 0. Default 0.1. */
  jumpBuffer?: number;
  /** How fast the speed in the air turns toward the wish, m/s², >= 0. Default 25. */
  airControl?: number;
  /** Which way is up, any length but zero. Default +Y. `AxisResponse` knows +Y alone. */
  up?: Vector3;
  /** Height along `up` below which it is put back to where `teleport` last put it. Default null: never. */
  respawnBelow?: number | null;
  /**
   * Turns contacts into displacements. Default a `SlideResponse`; with a collider in the paper's mode (`output: 'axis'`)
   * an `AxisResponse`.
   */
  response?: CollisionResponse | SlideResponse;
  /** What is drawn of the character: left out of its own cubemap, and moved by controls. Default none. */
  avatar?: Object3D | null;
}

/** All options, given and default, after they have been checked. */
export type CheckedCharacterOptions = Required<Omit<CharacterOptions, 'response'>> & {
  response: CollisionResponse | SlideResponse | null;
};

/**
 * Fills in defaults and checks.
 *
 * @throws RangeError for a number out of its range, TypeError for an unknown option or a wrong type
 */
export function checkCharacterOptions(options: CharacterOptions): CheckedCharacterOptions {
  const d = DEFAULTS.character;
  const {
    radius = d.radius,
    height = d.height,
    crouchHeight = Math.min(Math.max(d.crouchHeight, 2 * radius), height),
    gravity = d.gravity,
    terminalSpeed = d.terminalSpeed,
    jumpHeight = d.jumpHeight,
    skin = d.skin,
    slopeLimit = d.slopeLimit,
    stepHeight = d.stepHeight,
    snapDistance = d.snapDistance,
    coyoteTime = d.coyoteTime,
    jumpBuffer = d.jumpBuffer,
    airControl = d.airControl,
    up = new Vector3(0, 1, 0),
    respawnBelow = null,
    response,
    avatar = null,
    ...unknown
  } = options;
  const [stranger] = Object.keys(unknown);
  if (stranger !== undefined) {
    throw new TypeError(`CharacterController: there is no option "${stranger}".`);
  }
  check('radius', radius, radius > 0, 'must be a length above 0');
  const least = `must be at least twice "radius", ${2 * radius}`;
  check('height', height, height >= 2 * radius, least);
  check('crouchHeight', crouchHeight, crouchHeight >= 2 * radius, least);
  check(
    'crouchHeight',
    crouchHeight,
    crouchHeight <= height,
    `must be at most "height", ${height}`,
  );
  check('gravity', gravity, gravity >= 0, 'must be 0 or more (it points down)');
  check('terminalSpeed', terminalSpeed, terminalSpeed > 0, 'must be above 0');
  check('skin', skin, skin >= 0.005 && skin <= radius / 4, `must be 0.005 to ${radius / 4}`);
  const steepest = slopeLimit >= 0 && slopeLimit < Math.PI / 2;
  check('slopeLimit', slopeLimit, steepest, 'must be an angle in radians, 0 to below π/2');
  const lengths = { jumpHeight, stepHeight, snapDistance, coyoteTime, jumpBuffer, airControl };
  for (const [name, value] of Object.entries(lengths)) {
    check(name, value, value >= 0, 'must be 0 or more');
  }
  if (respawnBelow !== null) check('respawnBelow', respawnBelow, true, 'must be a height or null');
  if (!isFiniteVector(up) || up.x * up.x + up.y * up.y + up.z * up.z === 0) {
    throw new TypeError('CharacterController: "up" must be a Vector3 of finite numbers, not zero.');
  }
  if (response !== undefined && !isResponse(response)) throw new TypeError(RESPONSE_WANTED);
  if (avatar !== null && !avatar.isObject3D) {
    throw new TypeError('CharacterController: "avatar" must be an Object3D.');
  }
  return {
    radius,
    height,
    crouchHeight,
    gravity,
    terminalSpeed,
    jumpHeight,
    skin,
    slopeLimit,
    stepHeight,
    snapDistance,
    coyoteTime,
    jumpBuffer,
    airControl,
    up: new Vector3(up.x, up.y, up.z).normalize(),
    respawnBelow,
    response: response ?? null,
    avatar,
  };
}

export const RESPONSE_WANTED =
  'CharacterController: "response" must be a SlideResponse, or have a respond(maxima, center, target).';

/** Is it one response or the other? */
export function isResponse(response: CollisionResponse | SlideResponse | null): boolean {
  return response !== null && (isSlide(response) || typeof response?.respond === 'function');
}

/** Is it the response over surfels, and not one over the paper's maxima? */
export function isSlide(response: CollisionResponse | SlideResponse): response is SlideResponse {
  return (response as SlideResponse).isSlideResponse === true;
}

function check(name: string, value: number, holds: boolean, wanted: string): void {
  if (!holds || !Number.isFinite(value)) {
    throw new RangeError(`CharacterController: "${name}" ${wanted} (got ${value}).`);
  }
}

/** Is it a vector of finite numbers? One of another copy of three will do. Allocates nothing. */
export function isFiniteVector(vector: Vector3): boolean {
  return Number.isFinite(vector?.x) && Number.isFinite(vector?.y) && Number.isFinite(vector?.z);
}
