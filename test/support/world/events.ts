import type { Object3D } from 'three';
import type { CharacterController } from '../../../src/character/CharacterController.js';

const TYPES = [
  'land',
  'leave',
  'jump',
  'step',
  'contact',
  'separate',
  'squeeze',
  'inside',
  'respawn',
] as const;

/** What may be told with an event; which of it depends on its type. */
export interface Heard {
  speed?: number;
  height?: number;
  squeezed?: boolean;
  inside?: boolean;
  object?: Object3D;
  sensor?: boolean;
}

/** Everything a character says from now on, by type. */
export function listen(character: CharacterController): Record<(typeof TYPES)[number], Heard[]> {
  return Object.fromEntries(
    TYPES.map((type) => {
      const heard: Heard[] = [];
      character.addEventListener(type, (event) => heard.push({ ...(event as Heard) }));
      return [type, heard];
    }),
  ) as Record<(typeof TYPES)[number], Heard[]>;
}
