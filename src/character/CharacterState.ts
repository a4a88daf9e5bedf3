import { type EventDispatcher, Vector3 } from 'three';
import type { CharacterEventMap } from './characterEvents.js';

/** What may be changed of a character at any time; see `CharacterOptions`. */
export interface CharacterSettings {
  gravity: number;
  terminalSpeed: number;
  jumpHeight: number;
  skin: number;
  slopeLimit: number;
  stepHeight: number;
  snapDistance: number;
  coyoteTime: number;
  jumpBuffer: number;
  airControl: number;
}

/** What a character is and wants: shared by the controller, which users see, and the motion, which moves it. */
export class CharacterState {
  /** Middle of the foot, for drawing, world space, metres. */
  readonly position = new Vector3();
  /** Middle of the foot after the last step, world space, metres. */
  readonly foot = new Vector3();
  /** m/s, world axes. */
  readonly velocity = new Vector3();
  /** Wanted velocity, m/s, world axes. */
  readonly walk = new Vector3();
  /** Wanted displacement, once, metres, world axes. */
  readonly move = new Vector3();
  /** From foot to crown now, metres: less while crouched. */
  height: number;
  /** Whether to crouch; if not, it stands up as soon as there is room. */
  crouch = false;

  constructor(
    readonly settings: CharacterSettings,
    readonly events: EventDispatcher<CharacterEventMap>,
    readonly radius: number,
    readonly fullHeight: number,
    readonly crouchHeight: number,
    /** Unit vector, world axes. */
    readonly up: Vector3,
  ) {
    this.height = fullHeight;
  }
}
