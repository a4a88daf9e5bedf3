import { EventDispatcher, type Object3D, Vector3 } from 'three';
import { AxisResponse } from '../response/AxisResponse.js';
import type { CollisionResponse } from '../response/CollisionResponse.js';
import { SlideResponse } from '../response/SlideResponse.js';
import { Warnings } from '../Warnings.js';
import { AxisMotion } from './AxisMotion.js';
import type { CharacterCollider } from './CharacterCollider.js';
import type { CharacterEventMap } from './characterEvents.js';
import {
  checkCharacterOptions,
  isFiniteVector,
  isResponse,
  isSlide,
  RESPONSE_WANTED,
  type CharacterOptions,
} from './characterOptions.js';
import { type CharacterSettings, CharacterState } from './CharacterState.js';
import type { Contact } from './Contact.js';
import { ContactList } from './ContactList.js';
import type { Motion } from './Motion.js';
import { type CharacterStats, SlideMotion } from './SlideMotion.js';

/** The first frame's time stamp may lie this far before a clock that was made after it, seconds: no time has passed. */
const CLOCK_SKEW = 1;

/** The part of a character that collides. */
export interface CharacterBody {
  /** Middle of the foot after the last step, world space, metres. To move it, use `teleport`. */
  readonly position: Vector3;
  /** Metres. */
  readonly radius: number;
  /** Metres, now: less while crouched. */
  readonly height: number;
}

/**
 * A character that walks, climbs, falls, jumps and rides among whatever its collider draws.
 *
 * ```js
 * const collider = new CubeCollider();
 * const character = new CharacterController(collider);
 * character.teleport(new Vector3(0, 1, 0));
 * // each frame
 * character.walk(velocity);
 * character.update(renderer, scene, delta);
 * avatar.position.copy(character.position);
 * ```
 *
 * It moves in steps of 1/60 s, so it behaves alike at every frame rate; `position` is drawn between two of them. Its
 * collider is drawn seldom: when the body nears the edge of what has been seen, or something around it moves.
 *
 * The body's middle line never leaves the space that its cubemaps saw to be free. Without such (loading, just teleported,
 * context lost) it holds still: it never falls into what it has not seen, and says so by `ready`.
 *
 * `R` and `S`, the renderer and the scene, are only handed on to the collider.
 */
export class CharacterController<R = unknown, S = unknown>
  extends EventDispatcher<CharacterEventMap>
  implements CharacterSettings
{
  /** What it is drawn and read by. */
  readonly collider: CharacterCollider<R, S>;
  /** The capsule that collides, as the last step left it. */
  readonly body: CharacterBody;
  /** m/s², downward, >= 0. */
  gravity: number;
  /** Fastest fall, m/s. */
  terminalSpeed: number;
  /** Rise of a jump's foot, metres. */
  jumpHeight: number;
  /** Gap kept to every surface, metres. */
  skin: number;
  /** Steepest slope that is walked and stood on, radians. */
  slopeLimit: number;
  /** Highest step climbed without a jump, metres. */
  stepHeight: number;
  /** How far down it follows ground that it walks off, metres. */
  snapDistance: number;
  /** How long after it left the ground it may still jump, seconds. */
  coyoteTime: number;
  /** How long a jump asked for before landing is remembered, seconds. */
  jumpBuffer: number;
  /** How fast the speed in the air turns toward the wish, m/s². */
  airControl: number;
  /** Height along `up` below which it is put back to where `teleport` last put it, metres; null for never. */
  respawnBelow: number | null;
  /** What is drawn of it, left out of its own cubemap; null for nothing. */
  readonly avatar: Object3D | null;
  /** What was done for want of a field, in counts. */
  readonly stats: CharacterStats = { steps: 0, held: 0, slowed: 0, draws: 0 };

  readonly #state: CharacterState;
  readonly #list = new ContactList();
  readonly #spawn = new Vector3();
  readonly #warnings = new Warnings('CharacterController');
  #response: CollisionResponse | SlideResponse;
  #motion: Motion<R, S>;
  #disposed = false;
  /** Whether a frame has been timed. */
  #began = false;

  /**
   * @param collider drawn and read by `update`; its place is set in world space, so leave it without a moved parent.
   *   One collider serves one character. Not disposed with it.
   * @throws TypeError without a collider, RangeError for options out of range (see `CharacterOptions`)
   */
  constructor(collider: CharacterCollider<R, S>, options: CharacterOptions = {}) {
    super();
    if (typeof collider?.update !== 'function') {
      throw new TypeError('CharacterController: "collider" must be a CubeCollider.');
    }
    const checked = checkCharacterOptions(options);
    this.collider = collider;
    this.gravity = checked.gravity;
    this.terminalSpeed = checked.terminalSpeed;
    this.jumpHeight = checked.jumpHeight;
    this.skin = checked.skin;
    this.slopeLimit = checked.slopeLimit;
    this.stepHeight = checked.stepHeight;
    this.snapDistance = checked.snapDistance;
    this.coyoteTime = checked.coyoteTime;
    this.jumpBuffer = checked.jumpBuffer;
    this.airControl = checked.airControl;
    this.respawnBelow = checked.respawnBelow;
    this.avatar = checked.avatar;
    const { radius, height, crouchHeight, up } = checked;
    const state = new CharacterState(this, this, radius, height, crouchHeight, up);
    this.#state = state;
    this.body = {
      position: state.foot,
      radius,
      get height() {
        return state.height;
      },
    };
    this.#response =
      checked.response ?? (collider.output === 'axis' ? new AxisResponse() : new SlideResponse());
    this.#checkPair(this.#response);
    this.#motion = this.#makeMotion();
    if (this.avatar !== null) collider.exclude(this.avatar);
  }

  /** Turns contacts into displacements; may be changed at any time. The character goes on where it is, at rest. */
  get response(): CollisionResponse | SlideResponse {
    return this.#response;
  }

  set response(response: CollisionResponse | SlideResponse) {
    if (!response || !isResponse(response)) {
      throw new TypeError(RESPONSE_WANTED);
    }
    this.#checkPair(response);
    this.#motion.reset();
    this.#list.findSensors([], this.#state);
    this.#list.report(this);
    this.#response = response;
    this.#state.height = this.#state.fullHeight;
    this.#motion = this.#makeMotion();
    this.#motion.reset();
  }

  /** Middle of the foot, for drawing, between the last two steps, world space, metres. To move it, use `teleport`. */
  get position(): Vector3 {
    return this.#state.position;
  }

  /** m/s, world axes. */
  get velocity(): Vector3 {
    return this.#state.velocity;
  }

  /** What `walk` asked for last, m/s, world axes, whatever stops it on its way: for who wants to push that. */
  get wish(): Readonly<Vector3> {
    return this.#state.walk;
  }

  /** Unit vector, world axes. */
  get up(): Readonly<Vector3> {
    return this.#state.up;
  }

  /** Whether the collider's newest data can vouch for the body's place. While false, nothing moves. */
  get ready(): boolean {
    return this.#motion.ready;
  }

  /** Whether something carries it, or did `coyoteTime` ago and it has not jumped since. */
  get grounded(): boolean {
    return this.#motion.grounded;
  }

  /** The contact that carries it; null in the air, and with `AxisResponse`. Overwritten by the next step. */
  get ground(): Readonly<Contact> | null {
    return this.#list.ground;
  }

  /** What it touches; none with `AxisResponse`. Overwritten by the next step. */
  get contacts(): readonly Readonly<Contact>[] {
    return this.#list.contacts;
  }

  /** Whether it has no room for its body: something closes on it. */
  get squeezed(): boolean {
    return this.#motion instanceof SlideMotion && this.#motion.squeezed;
  }

  /**
   * Whether it is inside a solid, as two fields in a row tell by the backs of surfaces all around; of solids that are
   * larger than the fields' reach they cannot. It then goes back to where it was free last, unless it was put there.
   * Materials that show both sides have no inside. Always false in the paper's mode.
   */
  get inside(): boolean {
    return this.#motion instanceof SlideMotion && this.#motion.inside;
  }

  /** Whether it is crouched: still so where there is no room to stand up. */
  get crouched(): boolean {
    return this.#state.height < this.#state.fullHeight;
  }

  /** Seconds from the draw of the newest field to its use, by the character's own clock. */
  get latency(): number {
    return this.#motion instanceof SlideMotion ? this.#motion.latency : 0;
  }

  /**
   * Puts the foot at `position` (world space, metres), at rest, and waits for new data there.
   *
   * What is no Vector3 of finite numbers is passed over, with one warning.
   */
  teleport(position: Vector3): void {
    if (!this.#accepts('teleport', position)) return;
    this.#spawn.copy(position);
    this.#put(position);
  }

  /**
   * Sets the wanted velocity, m/s; what of it points along `up` is ignored. Holds until changed.
   *
   * What is no Vector3 of finite numbers is passed over, with one warning.
   */
  walk(velocity: Vector3): void {
    if (!this.#accepts('walk', velocity)) return;
    const { up, walk } = this.#state;
    const rise = velocity.x * up.x + velocity.y * up.y + velocity.z * up.z;
    walk.set(velocity.x - rise * up.x, velocity.y - rise * up.y, velocity.z - rise * up.z);
  }

  /**
   * Adds to the next step's travel, once: metres, world axes, the paper's user displacement. Several calls add up. What
   * the step could not travel, because of walls or because no data vouch for it, is dropped.
   *
   * What is no Vector3 of finite numbers is passed over, with one warning.
   */
  move(displacement: Vector3): void {
    if (!this.#accepts('move', displacement)) return;
    this.#state.move.add(displacement);
  }

  /**
   * Jumps `jumpHeight` high if `grounded`; in the air it is remembered for `jumpBuffer` seconds.
   *
   * @returns whether it jumps at once
   */
  jump(): boolean {
    return this.#motion.jump();
  }

  /** Crouches, or stands up as soon as there is room. `AxisResponse` knows no crouching. */
  crouch(on: boolean): void {
    this.#state.crouch = on;
  }

  /**
   * Moves on by `delta` seconds against the collider's newest data, drawing nothing: tests, crowds, replays. Holds still
   * while not `ready`; a bad delta warns once and holds.
   */
  step(delta: number): void {
    if (!this.#usable(delta)) return;
    this.#motion.step(Math.max(delta, 0));
    this.#respawn();
  }

  /**
   * The one call in the animation loop: moves on by `delta` seconds and draws the cubemap if one is due.
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
      return;
    }
    this.#motion.update(renderer, scene, Math.max(delta, 0));
    this.#respawn();
  }

  /** Lets the avatar back into cubemaps. The collider lives on: dispose of it yourself. */
  dispose(): void {
    if (this.#disposed) return;
    this.#disposed = true;
    this.#motion.reset();
    if (this.avatar !== null) this.collider.include(this.avatar);
  }

  #checkPair(response: CollisionResponse | SlideResponse): void {
    if (!isSlide(response) || this.collider.output !== 'axis') return;
    throw new TypeError(
      'CharacterController: a SlideResponse needs surfaces: give the collider output: "surface", or take an AxisResponse.',
    );
  }

  #makeMotion(): Motion<R, S> {
    const response = this.#response;
    if (!isSlide(response)) {
      return new AxisMotion(this.#state, this.collider, response, this.#warnings);
    }
    return new SlideMotion(
      this.#state,
      this.collider,
      response,
      this.#list,
      this.stats,
      this.#warnings,
    );
  }

  #put(position: Vector3): void {
    this.#state.foot.copy(position);
    this.#state.position.copy(position);
    this.#motion.reset();
    this.collider.invalidate();
  }

  #respawn(): void {
    const { foot, up } = this.#state;
    if (this.respawnBelow === null || foot.dot(up) >= this.respawnBelow) return;
    this.#put(this.#spawn);
    this.dispatchEvent({ type: 'respawn', position: this.#spawn });
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
    const began = this.#began;
    if (Number.isFinite(delta) && (delta >= 0 || (!began && delta > -CLOCK_SKEW))) {
      this.#began = true;
      return true;
    }
    this.#warnings.once(
      `"delta" must be seconds since the last frame, 0 or more (got ${delta}); holding.`,
      'delta',
    );
    return false;
  }
}
