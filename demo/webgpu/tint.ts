import { type Color, Vector3 } from 'three';
import { uniform } from 'three/tsl';

/** A colour in the working space, as three numbers. */
export function tint({ r, g, b }: Color) {
  return uniform(new Vector3(r, g, b));
}
