import type { Object3D, Vector3 } from 'three';
import { DEFAULTS } from '../defaults.js';
import { AxisResponse } from '../response/AxisResponse.js';
import type { CollisionResponse } from '../response/CollisionResponse.js';

/** How a character is built and moves. Metres and seconds; defaults are in `DEFAULTS.character`. */
export interface CharacterOptions {
  /** Radius of the body, > 0. Default 0.35. A collider in the paper's mode wants the same as its `rMax`. */
  radius?: number;
  /** From foot to crown, >= 2 · radius. Default 1.8. `AxisResponse` collides the lowest 2 · radius of it. */
  height?: number;
  /** Downward acceleration, m/s², >= 0; 0 to swim or fly by `move`. Default 20. */
  gravity?: number;
  /** Fastest fall, m/s, > 0. Default 50. */
  terminalSpeed?: number;
  /** Rise of a jump's foot, >= 0. Default 1.1. */
  jumpHeight?: number;
  /** Turns contacts into displacements. Default a new `AxisResponse`. */
  response?: CollisionResponse;
  /** What is drawn of the character: left out of its own cubemap, and moved by controls. Default none. */
  avatar?: Object3D | null;
}

/** All options, given and default, after they have been checked. */
export type CheckedCharacterOptions = Required<CharacterOptions>;

/**
 * Fills in defaults and checks.
 *
 * @throws RangeError for a number out of its range, TypeError for what is no `CollisionResponse` or no `Object3D`
 */
export function checkCharacterOptions({
  radius = DEFAULTS.character.radius,
  height = DEFAULTS.character.height,
  gravity = DEFAULTS.character.gravity,
  terminalSpeed = DEFAULTS.character.terminalSpeed,
  jumpHeight = DEFAULTS.character.jumpHeight,
  response = new AxisResponse(),
  avatar = null,
}: CharacterOptions): CheckedCharacterOptions {
  check('radius', radius, radius > 0, 'must be a length above 0');
  check('height', height, height >= 2 * radius, `must be at least twice "radius", ${2 * radius}`);
  check('gravity', gravity, gravity >= 0, 'must be 0 or more (it points down)');
  check('terminalSpeed', terminalSpeed, terminalSpeed > 0, 'must be above 0');
  check('jumpHeight', jumpHeight, jumpHeight >= 0, 'must be 0 or more');
  if (typeof response?.respond !== 'function') {
    throw new TypeError(
      'CharacterController: "response" must have a respond(maxima, center, target).',
    );
  }
  if (avatar !== null && !avatar.isObject3D) {
    throw new TypeError('CharacterController: "avatar" must be an Object3D.');
  }
  return { radius, height, gravity, terminalSpeed, jumpHeight, response, avatar };
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
