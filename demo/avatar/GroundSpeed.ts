import { type Object3D, Vector3 } from 'three';
import type { CharacterController } from 'three-cube-collider';

/** How fast a character walks over what carries it: a rider that stands does not walk. */
export class GroundSpeed {
  #ground: Object3D | null = null;
  /** The foot in the ground's frame, after the last frame. */
  readonly #last = new Vector3();
  readonly #carried = new Vector3();

  /** @returns m/s; in the air and on what is not known the world's */
  update(
    character: Pick<CharacterController, 'velocity' | 'position' | 'ground'>,
    delta: number,
  ): number {
    const { velocity, position } = character;
    const ground = character.ground?.object ?? null;
    const same = ground !== null && ground === this.#ground;
    this.#ground = ground;
    // Where the foot would be had it only been taken along. What it falls is no walk: it is drawn landing a little late.
    const carried = this.#carried.copy(this.#last);
    ground?.localToWorld(carried);
    const way = Math.hypot(position.x - carried.x, position.z - carried.z);
    this.#last.copy(position);
    ground?.worldToLocal(this.#last);
    return same && delta > 0 ? way / delta : Math.hypot(velocity.x, velocity.z);
  }
}
