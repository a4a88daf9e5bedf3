import type { Vector3 } from 'three';
import type { AxisMaxima } from '../cube/AxisMaxima.js';
import { redStep } from '../cube/axisRed.js';
import { DEFAULTS } from '../defaults.js';

/** Standing still, vertical moves below this many steps of red are rounding. */
const STILL_STEPS = 2;
/** Deepest that a frame's gravity presses into the ground it stands on, as a part of rMax: what 53 Hz would. */
const PRESS_RATIO = 0.01;

/** The vertical half of the paper's drawing loop (§2.1): falling, standing, jumping, bumping the head. World Y is up. */
export class Fall {
  /** Seconds since the ground last pushed; Infinity before it did and after a jump. */
  airTime = Infinity;

  /** @param velocity the character's, m/s; its y is kept here */
  constructor(readonly velocity: Vector3) {}

  /**
   * Whether the ground pushed within the last 0.1 s (`DEFAULTS.character.coyoteTime`) and no jump has left it since.
   *
   * Mend: the paper's test alone flickers. Standing, the sphere sinks by g·dt²/2 a frame, which at 240 Hz is less than
   * half a step of the 8-bit red, and says nothing.
   */
  get grounded(): boolean {
    return this.airTime <= DEFAULTS.character.coyoteTime;
  }

  /**
   * Gathers speed for `dt` seconds.
   *
   * @param rMax the sphere's radius, metres
   * @returns the vertical travel, metres
   */
  travel(dt: number, gravity: number, terminalSpeed: number, rMax: number): number {
    const before = this.velocity.y;
    this.velocity.y = Math.max(before - gravity * dt, -terminalSpeed);
    // Mend of "vy = vy + G.dt; dyg = vy.dt": down is -Y, and the mean of both speeds makes a jump's arc the same at
    // every frame rate.
    const gained = 0.5 * (this.velocity.y - before) * dt;
    // Mend: on the ground, slow frames press no deeper; deep enough, a slope shows on a side face and creeps.
    return before * dt + (this.airTime === 0 ? Math.max(gained, -PRESS_RATIO * rMax) : gained);
  }

  /**
   * Finds ground and ceiling after a response.
   *
   * @param push vertical part of the response's displacement, metres
   * @param from the sphere's middle before the sub-step
   * @param to the same after the response
   * @param dt seconds of the sub-step
   */
  touch(push: number, from: Vector3, to: Vector3, dt: number): void {
    this.airTime += dt;
    if (push > 0 && this.velocity.y <= 0) {
      // Mend of "if (dy<0)": pushed up is on the ground, unless it is still rising from it.
      this.airTime = 0;
      // Mend of "vy=0": downhill it keeps the slope's speed, up to 45°, or it would hop down every slope.
      const x = to.x - from.x;
      const z = to.z - from.z;
      const down = Math.min(Math.max(0, from.y - to.y), Math.sqrt(x * x + z * z));
      this.velocity.y = dt > 0 ? -down / dt : 0;
    } else if (push < 0 && this.velocity.y > 0) {
      // Mend: a ceiling ends a jump.
      this.velocity.y = 0;
    }
  }

  /**
   * Mend: standing still, a vertical move of less than two steps of red is rounding, and would shake the camera.
   *
   * @returns whether a move by `dy` metres is such
   */
  isRounding(dy: number, seen: AxisMaxima): boolean {
    return this.grounded && Math.abs(dy) < STILL_STEPS * redStep(seen.rMin, seen.rMax);
  }

  /** Leaves the ground with the speed that rises `height` metres. */
  jump(height: number, gravity: number): void {
    this.velocity.y = Math.sqrt(2 * gravity * height);
    this.airTime = Infinity;
  }
}
