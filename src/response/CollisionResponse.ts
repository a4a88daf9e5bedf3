import type { Vector3 } from 'three';
import type { AxisMaxima } from '../cube/AxisMaxima.js';

/**
 * What a character asks of a response: how to get out of what it has run into.
 *
 * This is the seam between "what is near" and "what to do about it". Bring your own to change how pushes add up;
 * `AxisResponse` is the paper's.
 */
export interface CollisionResponse {
  /**
   * The displacement that takes the sphere of radius `maxima.rMax` around `center` out of what `maxima` saw.
   *
   * Called once or more a frame: allocate nothing, and keep no reference to the arguments.
   *
   * @param maxima newest cubemap, maybe drawn around another centre (`maxima.center`)
   * @param center where the sphere is now, world space, metres
   * @param target overwritten with the displacement, world axes, metres
   * @returns `target`
   */
  respond(maxima: AxisMaxima, center: Vector3, target: Vector3): Vector3;
}
