import { Vector3 } from 'three';
import { AxisMaxima } from '../cube/AxisMaxima.js';
import { DEFAULTS } from '../defaults.js';
import { clipWish } from '../response/clipWish.js';
import type { CollisionResponse } from '../response/CollisionResponse.js';
import type { Warnings } from '../Warnings.js';
import type { CharacterCollider } from './CharacterCollider.js';
import type { CharacterState } from './CharacterState.js';
import { Fall } from './Fall.js';
import type { Motion } from './Motion.js';
import { drawnAt, surroundings, vouchedTravel, vouchesFor } from './surroundings.js';

/** Most sub-steps a frame; with a 'sync' collider each of them draws. */
const MAX_SUB_STEPS = 4;
/** Steps in a row without vouching surfaces after which it says so. */
const PATIENCE = 60;
/** Longest travel of a sub-step while there are sub-steps left, as a part of rMax - rMin. */
const SUB_STEP_RATIO = 0.5;

/**
 * The paper's drawing loop (§2.1) for a sphere of `radius` standing on the foot: fall, move, draw the cubemap there, push
 * out, stop falling if pushed up.
 *
 * Mends, each marked where it is made: one Y-up sign convention; the sphere and the user share one place; travel is cut
 * into sub-steps and never outruns what the last cubemap can vouch for, so a slow frame slows a fall or a run down
 * instead of letting it through a wall (at most 0.9·(rMax - rMin) a sub-step, four a frame: 38 m/s at 60 Hz, 12 m/s at
 * 20 Hz with the defaults); ceilings stop a jump; delta is bounded.
 */
export class AxisMotion<R, S> implements Motion<R, S> {
  readonly #state: CharacterState;
  readonly #collider: CharacterCollider<R, S>;
  readonly #response: CollisionResponse;
  readonly #warnings: Warnings;
  /** What a surface field is reduced to. */
  readonly #scratch: AxisMaxima;
  /** The sphere's middle while it moves, world space. */
  readonly #center = new Vector3();
  readonly #start = new Vector3();
  /** `center` before a sub-step. */
  readonly #from = new Vector3();
  /** A sub-step's travel without falling. */
  readonly #wanted = new Vector3();
  readonly #travel = new Vector3();
  readonly #push = new Vector3();
  readonly #fall: Fall;
  #unvouched = 0;

  constructor(
    state: CharacterState,
    collider: CharacterCollider<R, S>,
    response: CollisionResponse,
    warnings: Warnings,
  ) {
    this.#state = state;
    this.#collider = collider;
    this.#response = response;
    this.#warnings = warnings;
    const { radius } = state;
    this.#scratch = new AxisMaxima(radius * DEFAULTS.collider.rMinRatio, radius);
    this.#fall = new Fall(state.velocity);
  }

  get ready(): boolean {
    spot.copy(this.#state.foot);
    spot.y += this.#radius();
    return vouchesFor(this.#collider, spot, this.#radius());
  }

  get grounded(): boolean {
    return this.#fall.grounded;
  }

  reset(): void {
    this.#rest();
    this.#fall.airTime = Infinity;
  }

  jump(): boolean {
    if (!this.grounded || !this.ready) return false;
    this.#fall.jump(this.#state.settings.jumpHeight, this.#state.settings.gravity);
    return true;
  }

  step(delta: number): void {
    this.#advance(delta);
  }

  /** A 'sync' collider is drawn at each sub-step's place, as the paper does it; an 'async' one once, after the step. */
  update(renderer: R, scene: S, delta: number): void {
    if (this.#collider.readback === 'sync' && this.ready) {
      this.#advance(delta, renderer, scene);
    } else {
      // 'sync' without data: hold, draw here, go on in the next frame.
      this.#advance(delta);
      this.#draw(renderer, scene);
    }
  }

  /** The paper's loop for one frame, in sub-steps; draws at each if given what to draw. */
  #advance(delta: number, renderer?: R, scene?: S): void {
    const { settings, walk, move, velocity, radius } = this.#state;
    this.#place();
    let seen = surroundings(this.#collider, this.#center, this.#scratch);
    if (seen === null) {
      this.#rest();
      if (this.#collider.field !== null && ++this.#unvouched === PATIENCE) {
        this.#warnings.once(
          'the collider has surfaces, but none that vouch for the body, so it never moves: give the collider more ' +
            'reach ("far") or "resolution" for this radius, and no moved parent.',
        );
      }
      return;
    }
    this.#unvouched = 0;
    if (Math.abs(seen.rMax - radius) > radius / 1000) {
      this.#warnings.once(
        `"radius" should equal the collider's rMax; the latter is taken (got ${radius}, ${seen.rMax}).`,
        'radius',
      );
    }
    // Mend: dt is bounded, a page that slept goes on where it was.
    const dt = Math.min(delta, DEFAULTS.character.maxDelta);
    this.#wanted.copy(walk).multiplyScalar(dt).add(move);
    move.set(0, 0, 0);
    const fall = (velocity.y - 0.5 * settings.gravity * dt) * dt;
    const length = this.#travel
      .copy(this.#wanted)
      .setY(this.#wanted.y + fall)
      .length();
    const longest = SUB_STEP_RATIO * (seen.rMax - seen.rMin);
    const steps = Math.min(MAX_SUB_STEPS, Math.max(1, Math.ceil(length / longest)));
    this.#wanted.divideScalar(steps);
    this.#start.copy(this.#center);
    for (let i = 0; i < steps && seen !== null; i++) {
      seen = this.#subStep(seen, dt / steps, renderer, scene);
    }
    if (dt === 0) return;
    velocity.x = (this.#center.x - this.#start.x) / dt;
    velocity.z = (this.#center.z - this.#start.z) / dt;
  }

  /**
   * Moves `center` by a part of the frame's fall and wish, looks, gets out of what it ran into.
   *
   * @returns what it saw last, or null if the data no longer vouch and the rest of the frame must wait
   */
  #subStep(seen: AxisMaxima, dt: number, renderer?: R, scene?: S): AxisMaxima | null {
    const { settings, velocity } = this.#state;
    const from = this.#from.copy(this.#center);
    // Mend: the user's displacement does not push on into a wall that is already touched.
    clipWish(seen, from, this.#travel.copy(this.#wanted));
    const rising = velocity.y;
    this.#travel.y += this.#fall.travel(dt, settings.gravity, settings.terminalSpeed, seen.rMax);
    // Mend: never outrun what the cubemap vouches for. Time waits with it: neither a fall's nor a jump's speed is lost.
    const part = vouchedTravel(this.#collider, seen, from, this.#travel);
    velocity.y = rising + part * (velocity.y - rising);
    this.#center.addScaledVector(this.#travel, part);

    if (renderer !== undefined && scene !== undefined) {
      this.#draw(renderer, scene);
      if (!drawnAt(this.#collider, this.#center, seen.rMax)) {
        this.#warnings.once(
          'the collider did not draw at the character (disposed, context lost, or under a moved parent?); holding still.',
        );
        this.#center.copy(from);
        this.#rest();
        return null;
      }
    }
    const now = surroundings(this.#collider, this.#center, this.#scratch);
    if (now !== null) this.#respond(now, dt);
    // Mend: the paper's sphere never gets the response and drifts from the user; here both share one place.
    this.#settle();
    return now;
  }

  #respond(seen: AxisMaxima, dt: number): void {
    this.#response.respond(seen, this.#center, this.#push);
    this.#center.add(this.#push);
    this.#fall.touch(this.#push.y, this.#from, this.#center, dt);
    const dy = this.#center.y - this.#from.y;
    if (this.#wanted.lengthSq() === 0 && this.#fall.isRounding(dy, seen)) {
      this.#center.y = this.#from.y;
    }
  }

  /** Radius of the colliding sphere: in the paper's mode the collider's rMax, whatever `radius` says. */
  #radius(): number {
    return this.#collider.maxima?.rMax ?? this.#state.radius;
  }

  /** `center` from the foot. */
  #place(): void {
    this.#center.copy(this.#state.foot);
    this.#center.y += this.#radius();
  }

  /** The foot from `center`. */
  #settle(): void {
    this.#state.foot.copy(this.#center);
    this.#state.foot.y -= this.#radius();
    this.#state.position.copy(this.#state.foot);
  }

  #draw(renderer: R, scene: S): void {
    this.#collider.position.copy(this.#center);
    this.#collider.update(renderer, scene);
  }

  #rest(): void {
    this.#state.velocity.set(0, 0, 0);
    this.#state.move.set(0, 0, 0);
  }
}

/** Scratch of `ready`. */
const spot = /* @__PURE__ */ new Vector3();
