import { type Object3D, Quaternion, Vector3 } from 'three';
import type { CharacterCollider } from '../character/CharacterCollider.js';
import { DrawPolicy } from '../character/DrawPolicy.js';
import { FieldMemory } from '../field/FieldMemory.js';
import { timeOfImpact } from '../field/timeOfImpact.js';
import { Warnings } from '../Warnings.js';
import type { Boom } from './Boom.js';
import { wayInView } from './wayInView.js';

/** What a boom asks of its collider: `CubeCollider` is one. `R` and `S`, renderer and scene, are only handed on. */
export type BoomCollider<R = unknown, S = unknown> = Omit<
  CharacterCollider<R, S>,
  'maxima' | 'include'
>;

/** How far beyond the boom's end the cubemap sees: the pivot moves on while a read is on its way, metres. */
const ROOM = 0.75;
/** For `DrawPolicy`: a new cubemap after 0.18 m at a walk, drawn at most 0.6 m ahead of the head. */
const INTERVAL_ROOM = 0.3;
const AHEAD_ROOM = 1;
/** A pivot that moves farther in one frame was put elsewhere, metres. */
const LEAP = 2;
/** Longest time from draw to field that a draw's place is chosen for, seconds. */
const MOST_LATENCY = 0.15;
/** A draw that has not come after so long is asked for again, seconds. */
const LATE = 0.25;
/** A cubemap is drawn no nearer than this to a surface, metres. */
const CLEARANCE = 0.2;
/**
 * Edges are known to a fraction of a texel, which is so wide for each metre it is away, times the resolution: the outer
 * half of the boom keeps that much more to them.
 */
const EDGE = 0.25;
/** Draws whose time is remembered: reads come late, and maybe not all of them. */
const ASKED = 4;
/** Frames in which the camera asked and nobody drew, after which it says so. */
const PATIENCE = 60;

/**
 * A camera boom that never enters a wall: a second, small cubemap around the head, seen from which the way to the camera
 * is free.
 *
 * ```js
 * const boom = new CameraBoom(new CubeCollider({ resolution: 16 }));
 * const controls = new CharacterControls(character, camera, dom, { view: 'third', boom });
 * // in the animation loop
 * controls.update(delta);
 * character.update(renderer, scene, delta);
 * controls.follow(delta); // asks the boom how long it may be
 * boom.update(renderer, scene, delta); // draws its cubemap if one is due
 * ```
 *
 * A cubemap sees all ways at once, so turning the view asks for no draw. One is drawn when the head has moved on by 0.18 m
 * or something around it moves, changes or may deform; in first person and at rest, none. Between two reads the camera goes
 * by the newest three: places that one of them has looked through are free, whatever hides them from the others, and where
 * none has looked the boom does not go. What moved since takes its surfaces along.
 *
 * What is solid is what its collider draws: see-through materials, ghosts and whatever `filter` leaves out are not. For
 * things to be walked into that do not stop the camera, filter them in the boom's collider alone.
 */
export class CameraBoom<R = unknown, S = unknown> implements Boom {
  /** What draws and reads the boom's own cubemap, as it was given; the boom owns it no more than a character owns its. */
  readonly collider: BoomCollider<R, S>;

  readonly #memory = new FieldMemory(new Quaternion());
  readonly #policy = new DrawPolicy();
  readonly #warnings = new Warnings('CameraBoom');
  readonly #ball = { x: 0, y: 0, z: 0, radius: 0, height: 0 };
  readonly #pivot = new Vector3(NaN, NaN, NaN);
  readonly #last = new Vector3(NaN, NaN, NaN);
  readonly #velocity = new Vector3();
  /** Longest boom asked for since the last update, metres; 0 if none was. */
  #wanted = 0;
  /** Whether it was cut where nothing has been seen to be in the way. */
  #blind = false;
  /** Seconds, by the updates' own clock: now, of the last draw, and from draw to use of the newest field. */
  #clock = 0;
  #drawn = -Infinity;
  #latency = 0;
  readonly #asked = Array.from({ length: ASKED }, () => ({ center: new Vector3(NaN), clock: 0 }));
  #draws = 0;
  #unanswered = 0;
  #idle = true;

  /**
   * @param collider drawn and read by `update`, around the head; one of its own, without a moved parent. Without a `far`
   *   it sees as far as the boom is long, else the boom is no longer than that. Not disposed with it.
   * @throws TypeError without a collider of surfaces
   */
  constructor(collider: BoomCollider<R, S>) {
    if (typeof collider?.update !== 'function' || collider.output !== 'surface') {
      throw new TypeError(
        'CameraBoom: "collider" must be a CubeCollider of its own with output \'surface\'.',
      );
    }
    this.collider = collider;
  }

  /** See `Boom`. Without a field, 0: the camera stays in the head. Makes no object. */
  reach(pivot: Vector3, direction: Vector3, distance: number, radius: number): number {
    this.#pivot.copy(pivot);
    this.#wanted = Math.max(this.#wanted, distance);
    if (++this.#unanswered === PATIENCE) {
      this.#warnings.once('call boom.update(renderer, scene, delta) each frame, after follow().');
    }
    this.#take();
    if (this.#memory.newest === null) return 0;
    const { resolution } = this.#memory.newest;
    let free = this.#sweep(pivot, direction, 0, distance, radius);
    const margin = (EDGE / resolution) * free;
    free = this.#sweep(pivot, direction, 0.5 * free, free, radius + margin);
    const seen = wayInView(this.#memory, pivot, direction, free, radius + margin);
    this.#blind = seen < free;
    return seen;
  }

  ignore(avatar: Object3D): void {
    this.collider.exclude(avatar);
  }

  /**
   * Draws the cubemap if one is due. Call it each frame, after `controls.follow` and before the scene is rendered.
   *
   * @param delta seconds since the last call
   */
  update(renderer: R, scene: S, delta: number): void {
    this.#unanswered = 0;
    if (this.#wanted === 0 || !(delta >= 0) || !Number.isFinite(this.#pivot.lengthSq())) {
      this.#rest();
      return;
    }
    this.#idle = false;
    this.#move(delta);
    const { collider } = this;
    if (collider.autoFar) this.#stretch();
    const survey = collider.survey(scene);
    if (survey.moved || survey.changed || survey.deforms) this.#memory.forgetOlder();
    if (survey.moved) this.#carry();
    const due = this.#policy.due(
      survey,
      false,
      this.#pivot,
      this.#velocity,
      INTERVAL_ROOM,
      false,
      this.#blind,
      !this.#blind,
      this.#memory.newest === null && this.#clock - this.#drawn > LATE,
      0,
      delta,
    );
    if (due || this.#isLate() || this.#isShort()) this.#draw(renderer, scene);
    this.#wanted = 0;
  }

  /** Nobody looks from behind: what was seen until now says nothing of later. */
  #rest(): void {
    if (this.#idle) return;
    this.#idle = true;
    this.#wanted = 0;
    this.#memory.forget();
    this.#policy.reset();
    this.#last.set(NaN, NaN, NaN);
    this.collider.invalidate();
  }

  /** How the pivot moves. */
  #move(delta: number): void {
    this.#clock += delta;
    const way = this.#velocity.subVectors(this.#pivot, this.#last);
    const leapt = !(way.lengthSq() < LEAP * LEAP);
    if (leapt || delta === 0) way.set(0, 0, 0);
    else way.divideScalar(delta);
    this.#last.copy(this.#pivot);
  }

  #take(): void {
    const { field } = this.collider;
    if (field === null) this.#memory.forget();
    else if (this.#memory.take(field)) {
      for (const { center, clock } of this.#asked) {
        if (center.equals(field.center))
          this.#latency = Math.min(MOST_LATENCY, this.#clock - clock);
      }
    }
  }

  /** How far a ball gets from `from` metres along the boom on until it touches something, at most `to`. */
  #sweep(pivot: Vector3, direction: Vector3, from: number, to: number, radius: number): number {
    const ball = this.#ball;
    ball.x = pivot.x + from * direction.x;
    ball.y = pivot.y + from * direction.y - radius;
    ball.z = pivot.z + from * direction.z;
    ball.radius = radius;
    ball.height = 2 * radius;
    way.copy(direction).multiplyScalar(to - from);
    return from + (to - from) * timeOfImpact(this.#memory, ball, way, 0);
  }

  /** Brings the newest surfaces to where their objects are now. */
  #carry(): void {
    const { newest, toBody } = this.#memory;
    if (newest === null) return;
    for (let i = 0; i < newest.objects.length; i++) {
      if (!newest.objects[i]!.matrixWorld.equals(newest.poses[i]!)) newest.carry(i + 1, toBody);
    }
  }

  /** Half metres: a reach that changes all the time helps no one. */
  #stretch(): void {
    const reach = Math.ceil(2 * (this.#wanted + ROOM)) / 2;
    if (this.collider.far !== reach) this.collider.far = reach;
  }

  /** Has the last draw been asked for long ago, and not come? */
  #isLate(): boolean {
    const { newest } = this.#memory;
    const late = this.#clock - this.#drawn > LATE;
    return newest !== null && late && !newest.center.equals(this.collider.position);
  }

  /** Does the newest field end before the boom, though the next would not? */
  #isShort(): boolean {
    const { newest } = this.#memory;
    const late = this.#clock - this.#drawn > LATE;
    return newest !== null && late && newest.far < this.collider.far;
  }

  #draw(renderer: R, scene: S): void {
    const { position } = this.collider;
    this.#policy.predict(this.#pivot, this.#velocity, AHEAD_ROOM, this.#latency, target);
    // A centre inside something sees nothing.
    for (let i = 0; i < 3; i++) {
      if (this.#memory.isKnownFree(target.x, target.y, target.z, CLEARANCE, 0)) break;
      target.lerp(this.#pivot, i === 2 ? 1 : 0.5);
    }
    position.copy(target);
    if (this.collider.update(renderer, scene, true) === false) return;
    this.#policy.drawn(target, this.#pivot);
    this.#drawn = this.#clock;
    const asked = this.#asked[this.#draws++ % ASKED]!;
    asked.center.copy(target);
    asked.clock = this.#clock;
  }
}

const way = /* @__PURE__ */ new Vector3();
const target = /* @__PURE__ */ new Vector3();
