import type { CharacterController } from 'three-cube-collider';
import type { Avatar } from './createAvatar.js';
import { GroundSpeed } from './GroundSpeed.js';

/** Somebody who walks: a character, or a rival's. */
export type Walking = Pick<
  CharacterController,
  'velocity' | 'position' | 'ground' | 'grounded' | 'ready' | 'crouched'
>;

/** @returns to be called once a frame: lets the avatar do what who walks does */
export function followWalker(avatar: Avatar): (walker: Walking, delta: number) => void {
  const groundSpeed = new GroundSpeed();
  return (walker, delta) =>
    avatar.animate(
      delta,
      groundSpeed.update(walker, delta),
      // While it waits for surfaces it stands still, whatever is below.
      walker.grounded || !walker.ready,
      walker.crouched,
      walker.velocity.y,
    );
}
