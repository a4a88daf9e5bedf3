import type { ReactNode, Ref } from 'react';
import type { Vector3 } from 'three';
import type { CharacterController } from '../character/CharacterController.js';
import type { CharacterEventMap } from '../character/characterEvents.js';
import type { CharacterOptions } from '../character/characterOptions.js';
import type { CubeColliderOptions } from '../collider/CubeColliderOptions.js';
import type { CharacterControlsOptions } from '../controls/controlsOptions.js';
import { DEFAULTS } from '../defaults.js';
import type { PressedKeys } from './KeyWalk.js';
import type { Walker } from './Walker.js';

/** Called with each event of the character of that name; a new function costs nothing. */
export interface CharacterEventProps {
  /** It came down on ground. */
  onLand?: (event: CharacterEventMap['land']) => void;
  /** The ground was left. */
  onLeave?: (event: CharacterEventMap['leave']) => void;
  /** It jumped. */
  onJump?: (event: CharacterEventMap['jump']) => void;
  /** It climbed a step. */
  onStep?: (event: CharacterEventMap['step']) => void;
  /** It touches an object, or a sensor, that it did not touch before. */
  onContact?: (event: CharacterEventMap['contact']) => void;
  /** It touches an object no more. */
  onSeparate?: (event: CharacterEventMap['separate']) => void;
  /** It has no room any more, or has again. */
  onSqueeze?: (event: CharacterEventMap['squeeze']) => void;
  /** It is inside a solid, or out of it again. */
  onInside?: (event: CharacterEventMap['inside']) => void;
  /** It fell below `respawnBelow` and was put back. */
  onRespawn?: (event: CharacterEventMap['respawn']) => void;
}

/**
 * Props of `<Character>`: all options of `CharacterController` but `avatar`, which the children are. `radius`, `height`,
 * `crouchHeight`, `up` and `collider` make a new character where the old one stands; the others are set.
 */
export interface CharacterProps extends Omit<CharacterOptions, 'avatar'>, CharacterEventProps {
  /** Where its foot is put, at first and whenever this changes, world space, metres. Default the origin. */
  position?: Vector3 | readonly [x: number, y: number, z: number];
  /** Options of its collider. */
  collider?: CubeColliderOptions;
  /**
   * Keyboard, mouse and camera by `CharacterControls`: true, or their options. They are `useThree(({ controls }) => controls)`.
   * Default false.
   */
  controls?: boolean | CharacterControlsOptions;
  /**
   * Walks by these keys instead, where the camera looks; whoever else places the camera. drei's `KeyboardControls`:
   * `keys={useKeyboardControls()[1]}`.
   */
  keys?: () => PressedKeys;
  /** Speed of `keys`, m/s. Default 3. */
  walkSpeed?: number;
  /** Speed of `keys` with `run`, m/s. Default 6. */
  runSpeed?: number;
  /** Holds it still. Default false. */
  paused?: boolean;
  /** What is drawn of it: its origin at the foot, looking along +Z. Left out of its own cubemap. It may suspend. */
  children?: ReactNode;
  /** The controller, to `walk`, `jump` and `teleport` it, and to ask. */
  ref?: Ref<CharacterController>;
}

/** The events, and the props that listen to them. */
export const EVENT_PROPS = {
  land: 'onLand',
  leave: 'onLeave',
  jump: 'onJump',
  step: 'onStep',
  contact: 'onContact',
  separate: 'onSeparate',
  squeeze: 'onSqueeze',
  inside: 'onInside',
  respawn: 'onRespawn',
} as const satisfies Record<keyof CharacterEventMap, keyof CharacterEventProps>;

/** What a character is built of. */
const BODY = ['radius', 'height', 'crouchHeight', 'up'] as const;

/** Fields that may be set at any time, with their defaults. */
const LIVE = {
  gravity: DEFAULTS.character.gravity,
  terminalSpeed: DEFAULTS.character.terminalSpeed,
  jumpHeight: DEFAULTS.character.jumpHeight,
  skin: DEFAULTS.character.skin,
  slopeLimit: DEFAULTS.character.slopeLimit,
  stepHeight: DEFAULTS.character.stepHeight,
  snapDistance: DEFAULTS.character.snapDistance,
  coyoteTime: DEFAULTS.character.coyoteTime,
  jumpBuffer: DEFAULTS.character.jumpBuffer,
  airControl: DEFAULTS.character.airControl,
  respawnBelow: null,
} as const;

const NAMES = Object.keys(LIVE) as (keyof typeof LIVE)[];

/** Sets the fields whose props have changed since `before`: what the user set by hand stays. */
export function applyProps(walker: Walker, props: CharacterProps, before: CharacterProps): void {
  const { character } = walker;
  for (const name of NAMES) {
    if (props[name] !== before[name]) {
      Object.assign(character, { [name]: props[name] ?? LIVE[name] });
    }
  }
  if (props.response !== undefined && props.response !== before.response) {
    character.response = props.response;
  }
  walker.keys = props.keys ?? null;
  walker.walkSpeed = props.walkSpeed ?? DEFAULTS.controls.walkSpeed;
  walker.runSpeed = props.runSpeed ?? DEFAULTS.controls.runSpeed;
}

/** The props that a character is built of, those given. */
export function bodyOf(props: CharacterProps): CharacterOptions {
  return pick(props, BODY);
}

/** The props that may change later, those given. */
export function fieldsOf(props: CharacterProps): CharacterOptions {
  return pick(props, [...NAMES, 'response']);
}

function pick(props: CharacterProps, names: readonly (keyof CharacterProps)[]): CharacterOptions {
  const given = names.filter((name) => props[name] !== undefined);
  return Object.fromEntries(given.map((name) => [name, props[name]]));
}
