import { Quaternion, Vector3 } from 'three';
import type { Capsule } from '../field/Capsule.js';
import type { FieldMemory } from '../field/FieldMemory.js';
import type { CharacterCollider, Survey } from './CharacterCollider.js';
import { DrawPolicy } from './DrawPolicy.js';
import { seesAhead } from './seesAhead.js';

/** How far around the body fields must see, beyond its own size, metres. */
const AROUND = 0.05;
/** Draws whose time is remembered. */
const ASKED = 6;
/** Least way that a body may move from a field's centre, metres. */
const ROOM = 1;
/** Reach that serves walking; more is asked for by speed, seconds of it ahead. */
const REACH = 2.2;
const REACH_SPEED = 6;
const REACH_TIME = 0.12;
const MOST_REACH = 4;
/** Height of the cubemap's centre in the body: low, for the foot needs the finest texels. */
const CENTRE_RATIO = 0.36;
/** Slower than this nothing is run into unseen, m/s. */
const WALKING = 0.3;
/** A field drawn this near to the body's middle sees what can be seen from there, metres. */
const NEAR_ENOUGH = 0.03;
/**
 * After so long a draw that has not come is asked for again, seconds: on a page whose GPU is never idle none comes by
 * itself, and a body that an old field stops would stand for ever.
 */
const LATE = 0.2;
/** How far ahead it looks for corners it cannot see round, beyond the time until a field is there, seconds. */
const SOON = 2 / 60;

/**
 * A body's cubemaps: where they are drawn around it, when, and whether those there are see enough.
 */
export class Probe<R, S> {
  /** Seconds from the draw to the use of the newest field, by the character's own clock. */
  latency = 0;

  readonly #collider: CharacterCollider<R, S>;
  readonly #memory: FieldMemory;
  readonly #body: Capsule;
  readonly #toWorld: Quaternion;
  readonly #policy = new DrawPolicy();
  /** Where and when the last draws were made: reads come late, and maybe not all of them. */
  readonly #asked = Array.from({ length: ASKED }, () => ({ center: new Vector3(NaN), clock: 0 }));
  #turn = 0;
  /** Did fields see what is ahead, when a draw was asked for last? */
  #sees = false;

  constructor(collider: CharacterCollider<R, S>, memory: FieldMemory, body: Capsule) {
    this.#collider = collider;
    this.#memory = memory;
    this.#body = body;
    this.#toWorld = memory.toBody.clone().invert();
  }

  /** After a teleport: draw at once. */
  reset(): void {
    this.#policy.reset();
  }

  /**
   * Takes over the collider's newest field, if it is new.
   *
   * @param clock the character's, seconds
   */
  take(clock: number): boolean {
    const { field } = this.#collider;
    if (field === null) {
      this.#memory.forget();
      return false;
    }
    if (!this.#memory.take(field)) return false;
    const surfels = this.#memory.newest!;
    surfels.asked = clock;
    for (const { center, clock: asked } of this.#asked) {
      if (center.equals(field.center)) surfels.asked = Math.min(surfels.asked, asked);
    }
    this.latency = clock - surfels.asked;
    return true;
  }

  /** Has a field seen all that is around the body? */
  get covers(): boolean {
    const { x, y, z, height } = this.#body;
    const level = this.#level();
    return this.#memory.isKnownFree(x, y + level, z, 0, height - level + AROUND);
  }

  /**
   * Do fields see where the body's side will be after moving at `velocity` (body's frame, m/s) for `time` seconds? What
   * cannot be seen from its own middle will not be seen from elsewhere: then they see enough.
   */
  seesAhead(velocity: Vector3, time: number): boolean {
    if (velocity.lengthSq() < WALKING * WALKING || !this.covers) return true;
    const { x, y, z } = velocity;
    if (seesAhead(this.#memory, this.#body, x * time, y * time, z * time)) return true;
    return this.#middle(middle).distanceTo(this.#memory.newest!.center) < NEAR_ENOUGH;
  }

  /**
   * Is a draw due?
   *
   * @param hurry whether to draw as often as for what moves
   * @param velocity body's frame, m/s
   * @param waiting whether the body stands for want of a field
   * @param pressing whether it wants to walk
   * @param edged whether what it stands on has edges
   * @param dt seconds since it was asked last
   * @param clock the character's, seconds
   */
  isDue(
    survey: Readonly<Survey>,
    hurry: boolean,
    velocity: Vector3,
    waiting: boolean,
    pressing: boolean,
    edged: boolean,
    dt: number,
    clock: number,
  ): boolean {
    this.#sees = this.seesAhead(velocity, this.latency + SOON);
    this.#policy.edged = edged;
    const empty = this.#memory.newest === null;
    this.#middle(middle);
    const due = this.#policy.due(
      survey,
      hurry,
      middle,
      velocity,
      this.#room(),
      waiting,
      pressing,
      this.#sees,
      empty,
      this.latency,
      dt,
    );
    return due || this.#isLate(clock);
  }

  /**
   * Draws around the body, or ahead of it if it is `ahead` and moves.
   *
   * @param velocity body's frame, m/s
   * @returns whether it did
   */
  draw(renderer: R, scene: S, velocity: Vector3, ahead: boolean, clock: number): boolean {
    const collider = this.#collider;
    if (collider.autoFar) {
      // Quarters of a metre: a reach that changes all the time helps no one.
      const speed = Math.max(0, velocity.length() - REACH_SPEED);
      const least = Math.max(REACH, this.#body.height - this.#level() + AROUND + ROOM);
      const wanted = least + Math.min(MOST_REACH, REACH_TIME * speed);
      const reach = Math.ceil(4 * wanted) / 4 - 0.05;
      if (collider.far !== reach) collider.far = reach;
    }
    this.#middle(middle);
    target.copy(middle);
    if (ahead) {
      way.copy(velocity).applyQuaternion(this.#toWorld);
      this.#policy.predict(middle, way, this.#room(), this.latency, target);
      this.#retreat();
    }
    collider.position.copy(target);
    // As long as what it moves toward can be seen an old field is no reason to block, nor in a fast fall, where it always is
    // far behind: what it vouches for still holds.
    const patient = ahead && (this.#sees || velocity.y < -REACH_SPEED);
    if (collider.update(renderer, scene, patient) === false) return false;
    this.#policy.drawn(target, middle);
    const asked = this.#asked[this.#turn++ % ASKED]!;
    asked.center.copy(target);
    asked.clock = clock;
    return true;
  }

  /** Has the last draw been asked for long ago, and not come? */
  #isLate(clock: number): boolean {
    const { newest } = this.#memory;
    const last = this.#asked[(this.#turn + ASKED - 1) % ASKED]!;
    return newest !== null && clock - last.clock > LATE && !last.center.equals(newest.center);
  }

  /** Brings `target` back to where it is free for sure: a centre inside something sees nothing. */
  #retreat(): void {
    for (let i = 0; i < 3; i++) {
      way.copy(target).applyQuaternion(this.#memory.toBody);
      if (this.#memory.isKnownFree(way.x, way.y, way.z, this.#body.radius, 0)) return;
      target.lerp(middle, i === 2 ? 1 : 0.5);
    }
  }

  /** How far the body may move from a field's centre. */
  #room(): number {
    return Math.max(0.2, this.#collider.far - this.#body.height + this.#level() - AROUND);
  }

  /** Height above the foot around which cubemaps are drawn, metres. */
  #level(): number {
    return Math.max(this.#body.radius, CENTRE_RATIO * this.#body.height);
  }

  /** Where a cubemap around the body is drawn, world space. */
  #middle(target: Vector3): Vector3 {
    const { x, y, z } = this.#body;
    return target.set(x, y + this.#level(), z).applyQuaternion(this.#toWorld);
  }
}

const middle = /* @__PURE__ */ new Vector3();
const target = /* @__PURE__ */ new Vector3();
const way = /* @__PURE__ */ new Vector3();
