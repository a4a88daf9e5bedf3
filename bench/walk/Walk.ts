import { Vector3 } from 'three';
import { Inputs } from './Inputs.js';
import type { WalkLevel } from './level.js';
import type { Places } from './Places.js';
import { SHAPE } from '../rivals/shape.js';
import { Distribution, type DistributionSummary } from './Distribution.js';
import type { Walker, WalkerCounts } from '../rivals/Walker.js';

/** How far below the lowest point of the level it has fallen out, metres. */
const LOST = 10;
/** Places at which it is made to stand after the walk, and for how long, seconds. */
const RESTS = 12;
const REST_TIME = 1;
/** Part of the rest over which its drift is measured: settled by then. */
const SETTLED = 0.5;
/** Frames that a leg waits at most for a walker to be ready. */
const PATIENCE = 30;

const STILL = new Vector3();

/** A frame to look at: how many came before it, and the foot at its begin and end, world, metres. */
export interface Moment {
  frame: number;
  from: number[];
  to: number[];
}

export interface WalkResult {
  /** With inputs. Those before a leg, until the walker was ready, are in nothing but `waits` and draws. */
  frames: number;
  /** Times it was put somewhere, and frames after which it was not ready there yet. */
  legs: number;
  waits: number;
  /** Into the capsule, metres, one a frame; negative is a gap. */
  penetration: DistributionSummary;
  /** Frames in which its middle or its foot's middle passed a surface. */
  crossed: number;
  /** The first of them. */
  firstCrossing: Moment | null;
  /** The frame that ended deepest. */
  deepest: Moment | null;
  /** Times it fell out of the level over its edge. */
  fellOff: number;
  /** Times it fell out of the level after it had crossed a surface. */
  fellThrough: number;
  /** Frames after which its place was no number. */
  nan: number;
  /** Metres over ground. */
  distance: number;
  /** Farthest from the start, over ground, metres. */
  farthest: number;
  /** Frames in which it stood on something. */
  grounded: number;
  /** Milliseconds of JavaScript in a frame in which it stepped or drew; waiting for the GPU not counted. */
  milliseconds: DistributionSummary;
  /** Milliseconds that it waited for the GPU, all together. */
  waited: number;
  /** Milliseconds its making kept the page. */
  preparation: number;
  counts: WalkerCounts;
  /** Gaps at rest, metres, one a place, and the longest drift in half a second there. */
  rest: { gaps: number[]; drift: number };
  /** If asked for, of every frame: x, y, z of the foot, whether grounded, penetration. */
  trace: number[][] | null;
}

export interface WalkSettings {
  /** Frames a second. */
  hz: number;
  frames: number;
  /** Of the inputs. */
  seed: number;
  /** Seconds after which it is put in the next place, so that no pit keeps it. */
  leg: number;
  /** Whether to keep every frame's outcome. */
  trace?: boolean;
}

/** One walker, one script of inputs, one frame rate; judged after every frame. */
export class Walk {
  readonly #level: WalkLevel;
  readonly #walker: Walker;
  readonly #hz: number;
  readonly #inputs: Inputs;
  readonly #velocity = new Vector3();
  readonly #before = new Vector3();
  readonly #penetration: Distribution;
  readonly #milliseconds: Distribution;
  readonly #places: Places;
  readonly #legFrames: number;
  readonly #result: WalkResult;
  readonly #frames: number;
  readonly #trace: number[][] | null;
  /** Frames without input that it may still live before its leg begins. */
  #patience = 0;
  #leg = -1;
  #worst = -Infinity;
  #throughSomething = false;

  constructor(level: WalkLevel, walker: Walker, { hz, frames, seed, leg, trace }: WalkSettings) {
    this.#level = level;
    this.#walker = walker;
    this.#hz = hz;
    this.#frames = frames;
    this.#trace = trace ? [] : null;
    this.#inputs = new Inputs(seed, this.#velocity);
    this.#penetration = new Distribution(frames);
    this.#milliseconds = new Distribution(frames);
    this.#result = emptyResult(this.#penetration, this.#milliseconds);
    this.#places = level.places(seed);
    this.#legFrames = Math.round(leg * hz);
  }

  get done(): boolean {
    return this.#result.frames >= this.#frames;
  }

  /** One frame: inputs, walker, judge; or, before a leg, one without inputs. */
  frame(): void {
    const result = this.#result;
    const { judge, lowest, start } = this.#level;
    const { foot } = this.#walker;
    if (this.#leg < Math.floor(result.frames / this.#legFrames)) this.#begin();
    if (this.#patience > 0) {
      this.#await();
      return;
    }
    this.#before.copy(foot);
    this.#inputs.advanceTo(result.frames / this.#hz);
    this.#live(this.#velocity, this.#inputs.jump, this.#milliseconds);
    result.frames++;
    result.waited = this.#walker.waiting;

    if (!Number.isFinite(foot.x + foot.y + foot.z)) {
      result.nan++;
      this.#begin();
      return;
    }
    const penetration = judge.penetration(foot);
    this.#penetration.add(penetration);
    if (penetration > this.#worst) {
      this.#worst = penetration;
      result.deepest = this.#moment();
    }
    result.distance += Math.hypot(foot.x - this.#before.x, foot.z - this.#before.z);
    result.farthest = Math.max(result.farthest, Math.hypot(foot.x - start.x, foot.z - start.z));
    if (this.#walker.grounded) result.grounded++;
    if (this.#crossed()) {
      result.crossed++;
      result.firstCrossing ??= this.#moment();
      this.#throughSomething = true;
    }
    this.#trace?.push([...foot.toArray(), +this.#walker.grounded, penetration]);
    if (foot.y < lowest - LOST) {
      if (this.#throughSomething) result.fellThrough++;
      else result.fellOff++;
      this.#begin();
    }
  }

  /** Makes it stand for a second in each of the first places. `between` is awaited after every frame. */
  async rest(between: () => Promise<void> | void, places = RESTS): Promise<void> {
    const { foot } = this.#walker;
    const frames = Math.round(REST_TIME * this.#hz);
    const settled = new Vector3();
    for (let place = 0; place < places; place++) {
      this.#walker.place(this.#places.at(place));
      for (let i = 0; i < frames; i++) {
        this.#live(STILL, false);
        if (i === Math.floor(frames * (1 - SETTLED))) settled.copy(foot);
        await between();
      }
      const { gaps } = this.#result.rest;
      gaps.push(-this.#level.judge.penetration(foot));
      this.#result.rest.drift = Math.max(this.#result.rest.drift, settled.distanceTo(foot));
    }
  }

  /** What came out. */
  finish(): WalkResult {
    return {
      ...this.#result,
      penetration: this.#penetration.summary(),
      milliseconds: this.#milliseconds.summary(),
      preparation: this.#walker.preparation,
      trace: this.#trace,
    };
  }

  #live(velocity: Vector3, jump: boolean, times?: Distribution): void {
    const walker = this.#walker;
    const before = walker.counts();
    const { waiting } = walker;
    const start = performance.now();
    walker.frame(velocity, jump, 1 / this.#hz);
    const took = performance.now() - start - (walker.waiting - waiting);
    if (times === undefined) return;
    const after = walker.counts();
    this.#count(before, after, Object.keys(after) as (keyof WalkerCounts)[]);
    // A character with a step of its own has nothing to do in most frames of a fast screen.
    const idle = after.steps === before.steps && after.draws === before.draws;
    if (after.steps === undefined || !idle) times.add(took);
  }

  /** Adds what became more of these in a frame. */
  #count(before: WalkerCounts, after: WalkerCounts, keys: (keyof WalkerCounts)[]): void {
    const { counts } = this.#result;
    for (const key of keys) {
      counts[key] = (counts[key] ?? 0) + (after[key] ?? 0) - (before[key] ?? 0);
    }
  }

  /** Puts it where this leg begins. */
  #begin(): void {
    this.#leg = Math.floor(this.#result.frames / this.#legFrames);
    this.#walker.place(this.#places.at(this.#leg));
    this.#throughSomething = false;
    this.#patience = PATIENCE;
    this.#result.legs++;
  }

  /** A frame without inputs: everyone gets one, who waits for a field gets more. */
  #await(): void {
    const before = this.#walker.counts();
    this.#live(STILL, false);
    const after = this.#walker.counts();
    if ('draws' in after) this.#count(before, after, ['draws']);
    this.#patience--;
    if (this.#walker.ready) this.#patience = 0;
    else this.#result.waits++;
  }

  #moment(): Moment {
    return {
      frame: this.#result.frames - 1,
      from: this.#before.toArray(),
      to: this.#walker.foot.toArray(),
    };
  }

  #crossed(): boolean {
    const { judge } = this.#level;
    const { foot } = this.#walker;
    return (
      judge.crossed(this.#before, foot, SHAPE.height / 2) ||
      judge.crossed(this.#before, foot, SHAPE.radius)
    );
  }
}

function emptyResult(penetration: Distribution, milliseconds: Distribution): WalkResult {
  return {
    frames: 0,
    legs: 0,
    waits: 0,
    penetration: penetration.summary(),
    crossed: 0,
    firstCrossing: null,
    deepest: null,
    fellOff: 0,
    fellThrough: 0,
    nan: 0,
    distance: 0,
    farthest: 0,
    grounded: 0,
    milliseconds: milliseconds.summary(),
    waited: 0,
    preparation: 0,
    counts: {},
    rest: { gaps: [], drift: 0 },
    trace: null,
  };
}
