import { type Object3D, Vector3 } from 'three';
import type { CharacterController } from 'three-cube-collider';

/** How fast a character walks over what carries it: a rider that stands does not walk. */
export class GroundSpeed {
  #ground: Object3D | null = null;
  /** The foot in the ground's frame, after the last frame. */
  readonly #last = new Vector3();
  readonly #now = new Vector3();

  /** @returns m/s; in the air and on what is not known the world's */
  update(
    character: Pick<CharacterController, 'velocity' | 'position' | 'ground'>,
    delta: number,
  ): number {
    const { velocity, position } = character;
    const ground = character.ground?.object ?? null;
    const same = ground !== null && ground === this.#ground;
    this.#ground = ground;
    this.#now.copy(position);
    ground?.worldToLocal(this.#now);
    const way = this.#now.distanceTo(this.#last);
    this.#last.copy(this.#now);
    return same && delta > 0 ? way / delta : Math.hypot(velocity.x, velocity.z);
  }
}
