import type { Object3D, Vector3 } from 'three';

/** What controls ask of a character. `CharacterController` is one; anything else that walks may be. */
export interface ControlledCharacter {
  /** Middle of the foot, for drawing, world space, metres. */
  readonly position: Vector3;
  /** World space, m/s. */
  readonly velocity: Vector3;
  /** Whether it stands on something. */
  readonly grounded: boolean;
  /** What is drawn of it in third person: its origin at the foot, looking along its own +Z as glTF has it. */
  readonly avatar?: Object3D | null;
  /** The body that collides: the eyes sink as far as it is shorter now, metres, than it has been. */
  readonly body?: { readonly height: number };
  /** Gap kept between the foot and the ground, metres: the avatar is drawn that much lower. Default 0. */
  readonly skin?: number;
  /** Sets the wanted horizontal velocity, m/s; holds until changed. */
  walk(velocity: Vector3): void;
  /** Asks for a jump. */
  jump(): void;
  /** Crouches, or stands up as soon as there is room. */
  crouch?(on: boolean): void;
}

/** Where the camera is: in the head, or behind it. */
export type View = 'first' | 'third';
