import type { Object3D, Vector3 } from 'three';
import type { Contact } from './Contact.js';

/** Events of a `CharacterController`. The objects in them are overwritten later: copy what must last. */
export interface CharacterEventMap {
  /** It came down on ground: `speed` of the fall, m/s. */
  land: { speed: number };
  /** The ground was left, by a jump or by walking off it. */
  leave: object;
  /** It jumped. */
  jump: object;
  /** It climbed a step `height` metres high. */
  step: { height: number };
  /** It touches an object that it did not touch before; `contact` is null for a sensor. */
  contact: { object: Object3D; contact: Contact | null; sensor: boolean };
  /** It touches an object no more. */
  separate: { object: Object3D; sensor: boolean };
  /** It has no room for its body any more (true), or has again (false). */
  squeeze: { squeezed: boolean };
  /** It is inside a solid (true), whence it goes back to where it was free last; or out of it again. */
  inside: { inside: boolean };
  /** It fell below `respawnBelow` and was put back to `position`. */
  respawn: { position: Vector3 };
}

/** Any of them, as it is sent. */
export type CharacterEvent = {
  [Type in keyof CharacterEventMap]: { type: Type } & CharacterEventMap[Type];
}[keyof CharacterEventMap];
