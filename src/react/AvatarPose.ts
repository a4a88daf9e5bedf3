import { type Object3D, Quaternion, Vector3 } from 'three';
import type { CharacterController } from '../character/CharacterController.js';
import { catchUp } from '../controls/CameraRig.js';

/** How fast it turns to where it walks, 1/s. */
const TURN_RATE = 12;

const Y = /* @__PURE__ */ new Vector3(0, 1, 0);
const _heading = /* @__PURE__ */ new Vector3();
const _upright = /* @__PURE__ */ new Quaternion();
const _turn = /* @__PURE__ */ new Quaternion();

/** Stands an avatar on its character's foot, turned to where it walks; for characters without controls. */
export class AvatarPose {
  #facing = 0;

  /**
   * @param heading the direction it means to walk in, world space; zero takes its velocity
   * @param delta seconds since the last call
   */
  place(avatar: Object3D, character: CharacterController, heading: Vector3, delta: number): void {
    const up = character.up as Vector3;
    // Its soles are on the ground, not on the gap that the body keeps.
    avatar.position.copy(character.position).addScaledVector(up, -character.skin);
    _upright.setFromUnitVectors(Y, up);
    _heading.copy(heading.lengthSq() > 0 ? heading : character.velocity);
    _heading.applyQuaternion(_turn.copy(_upright).invert());
    if (Math.hypot(_heading.x, _heading.z) > 0.1) {
      const turn = Math.atan2(_heading.x, _heading.z) - this.#facing;
      const shortest = turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
      this.#facing += shortest * catchUp(TURN_RATE, delta);
    }
    avatar.quaternion.copy(_upright).multiply(_turn.setFromAxisAngle(Y, this.#facing));
  }
}
