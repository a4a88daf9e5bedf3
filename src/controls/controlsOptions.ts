import type { ButtonMap, KeyMap } from './actions.js';
import type { Boom } from './Boom.js';
import type { View } from './ControlledCharacter.js';

/** Each field of `CharacterControls` of that name; see there. */
export interface CharacterControlsOptions {
  view?: View;
  walkSpeed?: number;
  runSpeed?: number;
  eyeHeight?: number;
  sensitivity?: number;
  touchSensitivity?: number;
  stickSensitivity?: number;
  turnSpeed?: number;
  invertY?: boolean;
  deadZone?: number;
  touchStick?: boolean;
  turnKeys?: boolean;
  toggleRun?: boolean;
  maxPitch?: number;
  distance?: number;
  minDistance?: number;
  maxDistance?: number;
  boom?: Boom | null;
  pointerLock?: boolean;
  unadjustedMovement?: boolean;
  agility?: number;
  smoothing?: number;
  /** Keys of the actions to change; the others keep theirs. */
  keys?: Partial<KeyMap>;
  /** Gamepad buttons of the actions to change; the others keep theirs. */
  buttons?: Partial<ButtonMap>;
}

export interface CharacterControlsEventMap {
  /** The pointer was captured. */
  lock: object;
  /** The pointer was let go, by Escape or by `unlock`. */
  unlock: object;
  /** The view was switched: by the page, a key or a gamepad. */
  change: { view: View };
}

/** @throws RangeError, TypeError naming the option and what it may be */
export function checkControlsOptions(options: CharacterControlsOptions): void {
  for (const [name, value] of Object.entries(options)) {
    if (typeof value !== 'number') continue;
    const endless = name === 'agility' || name === 'smoothing';
    if (!(value >= 0 && (value < Infinity || endless))) {
      throw new RangeError(
        `CharacterControls: "${name}" must be a number from 0 on (got ${value}).`,
      );
    }
  }
  const { deadZone = 0 } = options;
  if (deadZone >= 1) {
    throw new RangeError(`CharacterControls: "deadZone" must be less than 1 (got ${deadZone}).`);
  }
  checkBoom(options.boom);
}

/** @throws TypeError for what is no boom */
export function checkBoom(boom: Boom | null | undefined): void {
  if (boom === null || boom === undefined || typeof boom.reach === 'function') return;
  throw new TypeError(
    'CharacterControls: "boom" must be a CameraBoom, or have its method reach(); a CubeCollider goes into new CameraBoom(collider).',
  );
}
