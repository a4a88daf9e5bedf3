import type { Object3D, Vector3 } from 'three';

/**
 * What keeps a third-person camera out of walls. `CameraBoom` is one, by a cubemap; a raycaster or a physics engine makes
 * another.
 */
export interface Boom {
  /**
   * How far a ball may go from `pivot` along `direction` until something stops it; asked once a frame. Must allocate
   * nothing and keep neither vector.
   *
   * @param pivot where the boom is held, at the head, world space, metres
   * @param direction unit vector, world space
   * @param distance metres that are wanted
   * @param radius of the ball, metres: the camera's near plane fits into it
   * @returns metres, 0 to `distance`
   */
  reach(pivot: Vector3, direction: Vector3, distance: number, radius: number): number;
  /** Told of the avatar, which is no obstacle, with all below it. */
  ignore?(avatar: Object3D): void;
}
