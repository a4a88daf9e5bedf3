import { type AnimationAction, type AnimationClip, AnimationMixer, type Object3D } from 'three';
import { DEFAULTS } from 'three-cube-collider';
import { Squash } from './Squash.js';

/** The clips, by name; `sneak` is the crouched walk. */
const CLIPS = ['idle', 'walk', 'run', 'jump', 'fall', 'land', 'crouch', 'sneak'] as const;
export type ClipName = (typeof CLIPS)[number];

/** What it is about. On the ground and crouched, clips blend by speed. */
const STATES = ['ground', 'crouch', 'jump', 'fall', 'land'] as const;
type State = (typeof STATES)[number];

/** How fast a state takes over from the others, 1/s. */
const RATES: Record<State, number> = { ground: 12, crouch: 14, jump: 24, fall: 8, land: 30 };
/** A share too small to see. */
const NOTHING = 0.004;

/** Speeds at which the feet of these clips stand still on the ground, m/s. */
const { walkSpeed: WALK, runSpeed: RUN } = DEFAULTS.controls;
/** Faster than that it was put somewhere else. */
const FASTEST = 3 * RUN;
/** From this speed on it walks, without any more of the clip that stands, m/s. */
const STROLL = 1.2;
/** How fast clips follow the speed, 1/s. */
const SPEED_RATE = 14;
/** Shortest steps, as a part of the clip's: slower walks take fewer of them. */
const LEAST_STEP = 0.35;

/** Upward speed that is a leap, not the end of a ramp, m/s. */
const TAKE_OFF = 2;
/** Fall that wants a landing, and that takes the deepest one, m/s. */
const SOFT = 2.5;
const HARD = 8;

/**
 * Blends a figure's clips by how its character moves: who walks, runs, leaps, falls, lands or crouches. A state's share
 * grows toward one while the others' shrink, so they always make up a whole.
 *
 * Steps go by the way walked, not by the clock: one phase drives walk, run and sneak, so that a foot is down in all of
 * them at once, and stays where it was put.
 */
export class Moves {
  /** What gives when it leaps and lands. */
  readonly squash: Squash;
  readonly #mixer: AnimationMixer;
  readonly #actions = {} as Record<ClipName, AnimationAction>;
  readonly #shares: Record<State, number> = { ground: 1, crouch: 0, jump: 0, fall: 0, land: 0 };
  #state: State = 'ground';
  /** Seconds in this state, and in all. */
  #since = 0;
  #clock = 0;
  /** m/s over the ground, smoothed. */
  #speed = 0;
  /** Of the steps, cycles. */
  #phase = 0;
  /** Fastest fall since it left the ground, m/s, and how deep a landing that wants, 0…1. */
  #fallen = 0;
  #depth = 0;

  /** @throws Error if a clip is missing */
  constructor(figure: Object3D, clips: readonly AnimationClip[]) {
    this.squash = new Squash(figure);
    this.#mixer = new AnimationMixer(figure);
    for (const name of CLIPS) {
      const clip = clips.find((clip) => clip.name === name);
      if (!clip) throw new Error(`Moves: there is no clip "${name}".`);
      this.#actions[name] = this.#mixer.clipAction(clip).setEffectiveWeight(0).play();
    }
    this.update(0, 0, true, false, 0);
  }

  /** How much of a clip shows, 0…1. */
  weight(name: ClipName): number {
    return this.#actions[name].weight;
  }

  /**
   * Goes on by `delta` seconds; `pose` shows it.
   *
   * @param speed m/s over the ground
   * @param rise m/s, upward
   */
  update(delta: number, speed: number, grounded: boolean, crouched: boolean, rise: number): void {
    this.#clock += delta;
    this.#since += delta;
    this.#turnTo(this.#next(grounded, crouched, rise));
    this.#fade(delta);
    const raw = Math.min(speed, FASTEST);
    this.#speed += (raw - this.#speed) * (1 - Math.exp(-SPEED_RATE * delta));
    if (Math.abs(raw - this.#speed) < 1e-3) this.#speed = raw;
    this.#walk(raw * delta);
    this.squash.update(delta);
  }

  /** Turns the joints. */
  pose(): void {
    this.#mixer.update(0);
  }

  #next(grounded: boolean, crouched: boolean, rise: number): State {
    const state = this.#state;
    const airborne = state === 'jump' || state === 'fall';
    if (!grounded) {
      this.#fallen = Math.max(airborne ? this.#fallen : 0, -rise);
      if (crouched) return 'crouch';
      if (rise > TAKE_OFF) return 'jump';
      return state === 'jump' && rise > 0 ? 'jump' : 'fall';
    }
    if (crouched) return 'crouch';
    if (airborne) return this.#fallen > SOFT ? 'land' : 'ground';
    return state === 'land' && this.#since < this.#actions.land.getClip().duration
      ? 'land'
      : 'ground';
  }

  #turnTo(state: State): void {
    if (state === this.#state) return;
    this.#state = state;
    this.#since = 0;
    if (state === 'jump') this.squash.push(1);
    if (state !== 'land') return;
    this.#depth = Math.min(1, this.#fallen / HARD);
    this.squash.push(-1.6 * this.#depth);
  }

  #fade(delta: number): void {
    const shares = this.#shares;
    const keep = Math.exp(-RATES[this.#state] * delta);
    let others = 0;
    for (const state of STATES) {
      if (state === this.#state) continue;
      shares[state] *= keep;
      if (shares[state] < NOTHING) shares[state] = 0;
      others += shares[state];
    }
    shares[this.#state] = 1 - others;
  }

  /** @param way metres over the ground since the last frame */
  #walk(way: number): void {
    const { ground, crouch, jump, fall, land } = this.#shares;
    const { idle, walk, run, sneak } = this.#actions;
    const moving = Math.min(1, this.#speed / STROLL);
    const running = Math.min(1, Math.max(0, (this.#speed - WALK) / (RUN - WALK)));

    // A clip's stride is what its feet cover in a cycle.
    const upright =
      walk.getClip().duration * WALK * (1 - running) + run.getClip().duration * RUN * running;
    const stride = upright + (sneak.getClip().duration * WALK - upright) * crouch;
    this.#phase = (this.#phase + way / (stride * Math.max(LEAST_STEP, moving))) % 1;

    // Who lands in a run runs on.
    const landing = land * (0.3 + 0.7 * this.#depth) * (1 - 0.6 * moving);
    const standing = ground + land - landing;
    this.#set('idle', standing * (1 - moving), this.#clock % idle.getClip().duration);
    this.#step('walk', standing * moving * (1 - running));
    this.#step('run', standing * moving * running);
    this.#set(
      'crouch',
      crouch * (1 - moving),
      this.#clock % this.#actions.crouch.getClip().duration,
    );
    this.#step('sneak', crouch * moving);
    this.#once('jump', jump);
    this.#set('fall', fall, this.#clock % this.#actions.fall.getClip().duration);
    this.#once('land', landing);
  }

  #step(name: ClipName, weight: number): void {
    this.#set(name, weight, this.#phase * this.#actions[name].getClip().duration);
  }

  /** Plays it from the state's beginning and holds its end; a state that fades out stays where it was. */
  #once(name: 'jump' | 'land', weight: number): void {
    const action = this.#actions[name];
    const time = this.#state === name ? this.#since : action.time;
    this.#set(name, weight, Math.min(time, action.getClip().duration));
  }

  #set(name: ClipName, weight: number, time: number): void {
    const action = this.#actions[name];
    action.setEffectiveWeight(weight);
    action.time = time;
  }
}
