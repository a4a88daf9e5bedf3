import { Vector3, type Object3D } from 'three';
import { AxisMaxima } from '../cube/AxisMaxima.js';
import { DEFAULTS } from '../defaults.js';
import { clipWish } from '../response/clipWish.js';
import type { CollisionResponse } from '../response/CollisionResponse.js';
import { Warnings } from '../Warnings.js';
import type { CharacterCollider } from './CharacterCollider.js';
import {
  checkCharacterOptions,
  isFiniteVector,
  type CharacterOptions,
} from './characterOptions.js';
import { Fall } from './Fall.js';
import { drawnAt, surroundings, vouchedTravel, vouchesFor } from './surroundings.js';

/** Most sub-steps a frame; with a 'sync' collider each of them draws. */
const MAX_SUB_STEPS = 4;
/** Steps in a row without vouching surfaces after which it says so. */
const PATIENCE = 60;
/** Longest travel of a sub-step while there are sub-steps left, as a part of rMax - rMin. */
const SUB_STEP_RATIO = 0.5;

/** The part of a character that collides. */
export interface CharacterBody {
  /** Middle of the foot, world space, metres. To move it, use `teleport`. */
  readonly position: Vector3;
  /** Metres. */
  readonly radius: number;
  /** Metres. */
  readonly height: number;
}

/**
 * A character that walks, falls and jumps among whatever its collider draws.
 *
 * ```js
 * const collider = new CubeCollider({ output: 'axis', rMax: 0.35 });
 * const character = new CharacterController(collider, { radius: 0.35 });
 * character.teleport(new Vector3(0, 1, 0));
 * // each frame
 * character.walk(velocity);
 * character.update(renderer, scene, delta);
 * avatar.position.copy(character.position);
 * ```
 *
 * This is the paper's drawing loop (§2.1) for a sphere of `radius` standing on the foot: fall, move, draw the cubemap
 * there, push out, stop falling if pushed up. Mends, each marked where it is made: one Y-up sign convention; the sphere
 * and the user share one place; travel is cut into sub-steps and never outruns what the last cubemap can vouch for, so
 * a slow frame slows a fall or a run down instead of letting it through a wall (at most 0.9·(rMax - rMin) a sub-step,
 * four a frame: 38 m/s at 60 Hz, 12 m/s at 20 Hz with the defaults); ceilings stop a jump; delta is bounded.
 *
 * Without data (loading, just teleported, context lost) it holds still: it never falls into what it has not seen.
 *
 * `R` and `S`, the renderer and the scene, are only handed on to the collider.
 */
export class CharacterController<R = unknown, S = unknown> {
  readonly collider: CharacterCollider<R, S>;
  /** Middle of the foot, for drawing, world space, metres. To move it, use `teleport`. */
  readonly position = new Vector3();
  readonly body: CharacterBody;
  /** m/s, world axes: x and z as travelled in the last step, y the speed of falling and jumping. */
  readonly velocity = new Vector3();
  /** m/s², downward, >= 0. */
  gravity: number;
  /** Fastest fall, m/s. */
  terminalSpeed: number;
  /** Rise of a jump's foot, metres. */
  jumpHeight: number;
  response: CollisionResponse;
  readonly avatar: Object3D | null;

  readonly #walk = new Vector3();
  readonly #move = new Vector3();
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
  readonly #warnings = new Warnings('CharacterController');
  readonly #fall = new Fall(this.velocity);
  #disposed = false;
  #unvouched = 0;

  /**
   * @param collider drawn and read by `update`; its place is set in world space, so leave it without a moved parent.
   *   One collider serves one character. Not disposed with it.
   * @throws TypeError without a collider, RangeError for options out of range (see `CharacterOptions`)
   */
  constructor(collider: CharacterCollider<R, S>, options: CharacterOptions = {}) {
    if (typeof collider?.update !== 'function') {
      throw new TypeError('CharacterController: "collider" must be a CubeCollider.');
    }
    const { radius, height, gravity, terminalSpeed, jumpHeight, response, avatar } =
      checkCharacterOptions(options);
    this.collider = collider;
    this.body = { position: new Vector3(), radius, height };
    this.gravity = gravity;
    this.terminalSpeed = terminalSpeed;
    this.jumpHeight = jumpHeight;
    this.response = response;
    this.avatar = avatar;
    this.#scratch = new AxisMaxima(radius * DEFAULTS.collider.rMinRatio, radius);
    if (avatar !== null) collider.exclude(avatar);
  }

  /** Whether the collider's newest data can vouch for the body's place. While false, nothing moves. */
  get ready(): boolean {
    spot.copy(this.body.position);
    spot.y += this.#radius();
    return vouchesFor(this.collider, spot, this.#radius());
  }

  /** Whether it stands on something, or did 0.1 s ago (`DEFAULTS.character.coyote`) and has not jumped since. */
  get grounded(): boolean {
    return this.#fall.grounded;
  }

  /**
   * Puts the foot at `position` (world space, metres), at rest, and waits for new data there.
   *
   * What is no Vector3 of finite numbers is passed over, with one warning.
   */
  teleport(position: Vector3): void {
    if (!this.#accepts('teleport', position)) return;
    this.body.position.copy(position);
    this.position.copy(position);
    this.#rest();
    this.#fall.airTime = Infinity;
    this.collider.invalidate();
  }

  /**
   * Sets the wanted horizontal velocity, m/s; its y is ignored. Holds until changed.
   *
   * What is no Vector3 of finite numbers is passed over, with one warning.
   */
  walk(velocity: Vector3): void {
    if (!this.#accepts('walk', velocity)) return;
    this.#walk.set(velocity.x, 0, velocity.z);
  }

  /**
   * Adds to the next step's travel, once: metres, world axes, the paper's user displacement. Several calls add up. What
   * the step could not travel, because of walls or because no data vouch for it, is dropped.
   *
   * What is no Vector3 of finite numbers is passed over, with one warning.
   */
  move(displacement: Vector3): void {
    if (!this.#accepts('move', displacement)) return;
    this.#move.add(displacement);
  }

  /** Jumps `jumpHeight` high if `grounded`. Returns whether it did. */
  jump(): boolean {
    if (!this.grounded || !this.ready) return false;
    this.#fall.jump(this.jumpHeight, this.gravity);
    return true;
  }

  /**
   * Moves on by `delta` seconds against the collider's newest data, drawing nothing: tests, crowds, replays. Holds still
   * while not `ready`; a bad delta warns once and holds.
   */
  step(delta: number): void {
    if (this.#usable(delta)) this.#advance(delta);
  }

  /**
   * The one call in the animation loop: moves on by `delta` seconds and draws the cubemap. A 'sync' collider is drawn at
   * each sub-step's place, as the paper does it; an 'async' one once, after the step, at the body's new place.
   *
   * Never throws for a bad frame: a missing renderer or scene, or a delta that is no number of seconds, warns once and
   * holds still.
   */
  update(renderer: R, scene: S, delta: number): void {
    if (!this.#usable(delta)) return;
    if (!renderer || !scene) {
      this.#warnings.once(
        'update(renderer, scene, delta) needs a renderer and a scene; holding still.',
      );
    } else if (this.collider.readback === 'sync' && this.ready) {
      this.#advance(delta, renderer, scene);
    } else {
      // 'sync' without data: hold, draw here, go on in the next frame.
      this.#advance(delta);
      this.#draw(renderer, scene);
    }
  }

  /** Lets the avatar back into cubemaps. The collider lives on: dispose of it yourself. */
  dispose(): void {
    if (this.#disposed) return;
    this.#disposed = true;
    this.#rest();
    if (this.avatar !== null) this.collider.include(this.avatar);
  }

  /** The paper's loop for one frame, in sub-steps; draws at each if given what to draw. */
  #advance(delta: number, renderer?: R, scene?: S): void {
    this.#place();
    let seen = surroundings(this.collider, this.#center, this.#scratch);
    if (seen === null) {
      this.#rest();
      if (this.collider.field !== null && ++this.#unvouched === PATIENCE) {
        this.#warnings.once(
          'the collider has surfaces, but none that vouch for the body, so it never moves: give the collider more ' +
            'reach ("far") or "resolution" for this radius, and no moved parent.',
        );
      }
      return;
    }
    this.#unvouched = 0;
    if (Math.abs(seen.rMax - this.body.radius) > this.body.radius / 1000) {
      this.#warnings.once(
        `"radius" should equal the collider's rMax; the latter is taken (got ${this.body.radius}, ${seen.rMax}).`,
        'radius',
      );
    }
    // Mend: dt is bounded, a page that slept goes on where it was.
    const dt = Math.min(delta, DEFAULTS.character.maxDelta);
    this.#wanted.copy(this.#walk).multiplyScalar(dt).add(this.#move);
    this.#move.set(0, 0, 0);
    const fall = (this.velocity.y - 0.5 * this.gravity * dt) * dt;
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
    this.velocity.x = (this.#center.x - this.#start.x) / dt;
    this.velocity.z = (this.#center.z - this.#start.z) / dt;
  }

  /**
   * Moves `center` by a part of the frame's fall and wish, looks, gets out of what it ran into.
   *
   * @returns what it saw last, or null if the data no longer vouch and the rest of the frame must wait
   */
  #subStep(seen: AxisMaxima, dt: number, renderer?: R, scene?: S): AxisMaxima | null {
    const from = this.#from.copy(this.#center);
    // Mend: the user's displacement does not push on into a wall that is already touched.
    clipWish(seen, from, this.#travel.copy(this.#wanted));
    const rising = this.velocity.y;
    this.#travel.y += this.#fall.travel(dt, this.gravity, this.terminalSpeed, seen.rMax);
    // Mend: never outrun what the cubemap vouches for. Time waits with it: neither a fall's nor a jump's speed is lost.
    const part = vouchedTravel(this.collider, seen, from, this.#travel);
    this.velocity.y = rising + part * (this.velocity.y - rising);
    this.#center.addScaledVector(this.#travel, part);

    if (renderer !== undefined && scene !== undefined) {
      this.#draw(renderer, scene);
      if (!drawnAt(this.collider, this.#center, seen.rMax)) {
        this.#warnings.once(
          'the collider did not draw at the character (disposed, context lost, or under a moved parent?); holding still.',
        );
        this.#center.copy(from);
        this.#rest();
        return null;
      }
    }
    const now = surroundings(this.collider, this.#center, this.#scratch);
    if (now !== null) this.#respond(now, dt);
    // Mend: the paper's sphere never gets the response and drifts from the user; here both share one place.
    this.#settle();
    return now;
  }

  #respond(seen: AxisMaxima, dt: number): void {
    this.response.respond(seen, this.#center, this.#push);
    this.#center.add(this.#push);
    this.#fall.touch(this.#push.y, this.#from, this.#center, dt);
    const dy = this.#center.y - this.#from.y;
    if (this.#wanted.lengthSq() === 0 && this.#fall.isRounding(dy, seen)) {
      this.#center.y = this.#from.y;
    }
  }

  /** Radius of the colliding sphere: in the paper's mode the collider's rMax, whatever `radius` says. */
  #radius(): number {
    return this.collider.maxima?.rMax ?? this.body.radius;
  }

  /** `center` from the foot. */
  #place(): void {
    this.#center.copy(this.body.position);
    this.#center.y += this.#radius();
  }

  /** The foot from `center`. */
  #settle(): void {
    this.body.position.copy(this.#center);
    this.body.position.y -= this.#radius();
    this.position.copy(this.body.position);
  }

  #draw(renderer: R, scene: S): void {
    this.collider.position.copy(this.#center);
    this.collider.update(renderer, scene);
  }

  #rest(): void {
    this.velocity.set(0, 0, 0);
    this.#move.set(0, 0, 0);
  }

  /** A vector that a frame's sums may have spoiled: it must neither throw into the loop nor be taken. */
  #accepts(method: string, vector: Vector3): boolean {
    if (isFiniteVector(vector)) return true;
    this.#warnings.once(`${method}() needs a Vector3 of finite numbers; passed over.`);
    return false;
  }

  /** May this frame move? Else it has been told why, once. */
  #usable(delta: number): boolean {
    if (this.#disposed) {
      this.#warnings.once('used after dispose(); make a new one.');
      return false;
    }
    if (Number.isFinite(delta) && delta >= 0) return true;
    this.#warnings.once(
      `"delta" must be seconds since the last frame, 0 or more (got ${delta}); holding.`,
      'delta',
    );
    return false;
  }
}

/** Scratch of `ready`. */
const spot = /* @__PURE__ */ new Vector3();
