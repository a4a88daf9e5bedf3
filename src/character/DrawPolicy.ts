import { Vector3 } from 'three';
import type { Survey } from './CharacterCollider.js';

/** Way made between two draws, metres: at 5 m/s and 60 Hz every seventh frame. */
const INTERVAL = 0.55;
/** The same for what is fast, seconds. */
const INTERVAL_TIME = 6 / 60;
/** Of both so much remains on edges, and where fields come too late to be drawn far enough ahead. */
const FINE_RATIO = 0.6;
/** How much farther from the last draw's centre than it was then the body may get, metres: it has turned away. */
const TURNED = 0.17;
/** Most of a field's room that may be used up between two draws. */
const ROOM_RATIO = 0.6;
/** Time between draws of what moves, seconds. */
const MOVER_INTERVAL = 0.03;
/** Age at which a field with something in it that may deform is renewed, seconds: `maxAge` of the design. */
const MAX_AGE = 0.1;
/** Way made after which it is worth looking round a corner again, metres. */
const LEAST = 0.08;
/** A draw this near to the body's middle is what a waiting body waits for, metres. */
const HERE = 0.03;
/** How long it is waited for, seconds. */
const PATIENCE = 0.25;
/** How long after it came to rest one more field is drawn around where it is, seconds. */
const SETTLED = 0.25;
/** The same where it wants to go on: a look from here may show that nothing is in its way. */
const PRESSED = 0.04;
/** Slower than this it is at rest, m/s. */
const STILL = 0.01;

/**
 * When to draw the next cubemap, and where: seldom, for reading back is what costs.
 */
export class DrawPolicy {
  /** Whether what it stands on has edges, as stairs do: these are seen well from near by only. */
  edged = false;
  /** Centre of the last draw, and where the body was then. */
  readonly center = new Vector3(NaN, NaN, NaN);
  readonly #from = new Vector3();
  #since = Infinity;
  #rested = 0;
  #patience = SETTLED;
  #settled = false;

  /** After a teleport: draw at once. */
  reset(): void {
    this.center.set(NaN, NaN, NaN);
    this.#since = Infinity;
    this.#settled = false;
  }

  /**
   * Is a draw due?
   *
   * @param hurry whether to draw as often as for what moves
   * @param middle of the body, world space
   * @param velocity of the body, m/s
   * @param room how far the body may move from a field's centre
   * @param waiting whether the body stands for want of a field
   * @param pressing whether it wants to walk
   * @param sees whether what is ahead can be seen
   * @param empty whether there is no field at all
   * @param latency seconds from a draw to its field
   * @param dt seconds since it was asked last
   */
  due(
    survey: Readonly<Survey>,
    hurry: boolean,
    middle: Vector3,
    velocity: Vector3,
    room: number,
    waiting: boolean,
    pressing: boolean,
    sees: boolean,
    empty: boolean,
    latency: number,
    dt: number,
  ): boolean {
    this.#since += dt;
    const speed = velocity.length();
    this.#rested = speed < STILL ? this.#rested + dt : 0;
    this.#patience = pressing ? PRESSED : SETTLED;
    if (this.#rested === 0) this.#settled = false;
    if (survey.changed || empty || Number.isNaN(this.center.x)) return true;
    // Asked for already, it is on its way; but ways get lost.
    if (waiting) return middle.distanceTo(this.center) > HERE || this.#since > PATIENCE;
    if ((survey.moved || hurry) && this.#since >= MOVER_INTERVAL) return true;
    if (survey.deforms && this.#since >= MAX_AGE) return true;
    const most = this.#interval(speed, room, latency);
    const made = middle.distanceTo(this.#from);
    if (made > most || (!sees && made > LEAST)) return true;
    // It turned away from where it was expected.
    const away = middle.distanceTo(this.center);
    if (away > this.#from.distanceTo(this.center) + Math.min(TURNED, 0.5 * most)) return true;
    return this.#rested > this.#patience && !this.#settled && away > 0.02;
  }

  /**
   * Where to draw: ahead of the body, so that it passes through the middle of what is seen.
   *
   * @param latency seconds until the field will be there
   * @returns `target`
   */
  predict(
    middle: Vector3,
    velocity: Vector3,
    room: number,
    latency: number,
    target: Vector3,
  ): Vector3 {
    const speed = velocity.length();
    target.copy(middle);
    if (speed < STILL) return target;
    const wanted = speed * latency + 0.5 * this.#interval(speed, room, latency);
    const ahead = Math.min(wanted, ROOM_RATIO * room);
    return target.addScaledVector(velocity, ahead / speed);
  }

  /** A draw was made around `center` while the body's middle was at `from`. */
  drawn(center: Vector3, from: Vector3): void {
    this.center.copy(center);
    this.#from.copy(from);
    this.#since = 0;
    this.#settled = this.#rested > this.#patience;
  }

  /** Way between two draws. What a field cannot be drawn farther ahead for is lost on either side of its centre. */
  #interval(speed: number, room: number, latency: number): number {
    const most = Math.max(INTERVAL, speed * INTERVAL_TIME);
    const lost = Math.max(0, 2 * speed * latency + most - 2 * ROOM_RATIO * room);
    const left = this.edged ? FINE_RATIO * most : Math.max(FINE_RATIO * most, most - lost);
    return Math.min(left, ROOM_RATIO * room);
  }
}
