import { BoxGeometry, Scene, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { Distribution } from '../bench/walk/Distribution.js';
import { HeldBackCollider } from '../bench/walk/HeldBackCollider.js';
import { Inputs } from '../bench/walk/Inputs.js';
import { Judge } from '../bench/rivals/Judge.js';
import { Places } from '../bench/walk/Places.js';
import { Walk } from '../bench/walk/Walk.js';
import type { Walker } from '../bench/rivals/Walker.js';
import { AnalyticCollider } from './support/AnalyticCollider.js';
import { floor } from './support/analytic.js';

describe('the inputs of the comparison', () => {
  it('should be the same at the same time, at any frame rate', () => {
    const seconds = 20;
    const at = (hz: number) => {
      const velocity = new Vector3();
      const inputs = new Inputs(3, velocity);
      const headings: number[] = [];
      let jumps = 0;
      for (let frame = 1; frame <= seconds * hz; frame++) {
        jumps += +inputs.advanceTo(frame / hz).jump;
        if (frame % hz === 0) headings.push(velocity.x, velocity.z);
      }
      return { headings, jumps };
    };
    const want = at(60);
    expect(new Set(want.headings).size).toBeGreaterThan(10);
    for (const hz of [20, 30, 144]) expect(at(hz).headings).toEqual(want.headings);
    expect(want.jumps).toBeGreaterThan(5);
    expect(at(144).jumps).toBe(want.jumps);
  });
});

describe('the judge of the comparison', () => {
  const judge = new Judge(new BoxGeometry(4, 2, 4).toNonIndexed());

  it('should tell how deep an upright capsule is in the nearest triangle', () => {
    expect(judge.penetration(new Vector3(0, 1.02, 0))).toBeCloseTo(-0.02, 6);
    expect(judge.penetration(new Vector3(0, 0.97, 0))).toBeCloseTo(0.03, 6);
    // Beside it, and over its edge: 0.3 out and 0.35 up to the axis' lower end.
    expect(judge.penetration(new Vector3(2.25, -0.5, 0))).toBeCloseTo(0.1, 6);
    expect(judge.penetration(new Vector3(2.3, 1, 0))).toBeCloseTo(0.35 - Math.hypot(0.3, 0.35), 6);
    expect(judge.penetration(new Vector3(0, 9, 0))).toBe(-0.5);
  });

  it('should tell a way through a surface, from either side, from one beside it', () => {
    const [outside, inside] = [new Vector3(2.4, 0, 0), new Vector3(1.6, 0, 0)];
    expect(judge.crossed(outside, inside, 0.35)).toBe(true);
    expect(judge.crossed(inside, outside, 0.35)).toBe(true);
    expect(judge.crossed(outside, inside, 1.35)).toBe(false);
    expect(judge.crossed(outside, outside, 0.35)).toBe(false);
  });

  it('should find free places to begin at, the same for a seed', () => {
    const first = new Vector3(0, 1.02, 0);
    const places = () => {
      const list = new Places(judge, first, 3, 9);
      return [0, 1, 2, 3].map((i) => list.at(i));
    };
    expect(places()).toEqual(places());
    expect(places()[0]).toEqual(first);
    for (const place of places()) expect(judge.penetration(place)).toBeLessThan(0);
    expect(new Set(places().map(({ x }) => x)).size).toBe(4);
  });
});

describe('a walk of the comparison', () => {
  const geometry = new BoxGeometry(40, 2, 40).toNonIndexed();
  const judge = new Judge(geometry);
  const start = new Vector3(0, 1.02, 0);
  const places = (seed: number) => new Places(judge, start, 3, seed);
  const level = { scene: new Scene(), geometry, triangles: 12, judge, start, places, lowest: -1 };
  const settings = { hz: 20, frames: 100, seed: 4, leg: 2 };

  /** Goes where it is told, once it has lived the given number of frames at its place. */
  class LateWalker implements Walker {
    readonly foot = new Vector3();
    readonly grounded = true;
    readonly preparation = 0;
    readonly waiting = 0;
    readonly wishes: number[] = [];
    #frames = 0;
    #steps = 0;
    #held = 0;

    constructor(readonly late: number) {}

    get ready() {
      return this.#frames >= this.late;
    }

    place(foot: Vector3): void {
      this.foot.copy(foot);
      this.#frames = 0;
    }

    frame(velocity: Vector3, jump: boolean, dt: number): void {
      this.#steps++;
      this.#frames++;
      if (!this.ready) this.#held++;
      this.foot.addScaledVector(velocity, dt);
      if (velocity.lengthSq() > 0) this.wishes.push(velocity.x, velocity.z, +jump);
    }

    counts() {
      return { steps: this.#steps, held: this.#held, draws: this.#steps };
    }

    dispose(): void {
      // nothing to let go
    }
  }

  function walkOf(late: number) {
    const walker = new LateWalker(late);
    const walk = new Walk(level, walker, settings);
    let frames = 0;
    for (; !walk.done; frames++) walk.frame();
    return { walker, result: walk.finish(), frames };
  }

  it('should give who waits for its first field the same inputs and ways as who need not', () => {
    const [quick, late] = [walkOf(1), walkOf(4)];
    expect(quick.result).toMatchObject({ frames: 100, legs: 3, waits: 0 });
    expect(late.result).toMatchObject({ frames: 100, legs: 3, waits: 9 });
    expect(late.walker.wishes).toEqual(quick.walker.wishes);
    expect(late.result.distance).toBeCloseTo(100 * (5 / 20), 9);
    // Before a leg everyone lives one frame that is not counted.
    expect(quick.frames).toBe(103);
    expect(late.frames).toBe(112);
    // What it did meanwhile is in none of its counts, but what it drew is.
    expect(late.result.counts).toEqual({ steps: 100, held: 0, draws: 112 });
  });

  it('should not wait for ever', () => {
    const { result, frames } = walkOf(Infinity);
    expect(result).toMatchObject({ frames: 100, waits: 90 });
    expect(result.counts.held).toBe(100);
    expect(frames).toBe(190);
  });
});

describe('fields that are held back', () => {
  it('should arrive the given number of frames after they were drawn, unchanged by later draws', () => {
    const inner = new AnalyticCollider(floor(), {
      output: 'surface',
      readback: 'sync',
    });
    const collider = new HeldBackCollider(inner as never, 3);
    const frame = (x: number) => {
      collider.frame();
      const seen = collider.field?.center.x ?? null;
      collider.position.set(x, 1, 0);
      collider.update(null as never, null as never);
      return seen;
    };
    // Two may be on their way: the third and sixth frame draw none.
    expect([1, 2, 3, 4, 5, 6, 7, 8].map(frame)).toEqual([null, null, null, 1, 2, 2, 4, 5]);
    const { field } = collider;
    const distances = field!.distance.slice();
    frame(9);
    expect(field!.distance).toEqual(distances);
    expect(field!.center.x).toBe(5);
    collider.invalidate();
    expect(collider.field).toBeNull();
    expect([10, 11, 12, 13].map(frame)).toEqual([null, null, null, 10]);
  });
});

describe('a distribution', () => {
  it('should tell quantiles and a tail that ends at the largest', () => {
    const distribution = new Distribution(1000);
    for (let i = 0; i < 1000; i++) distribution.add((i * 7) % 1000);
    const { count, mean, p50, p99, max, tail } = distribution.summary();
    expect({ count, mean, p50, p99, max }).toEqual({
      count: 1000,
      mean: 499.5,
      p50: 500,
      p99: 990,
      max: 999,
    });
    expect(tail.at(-1)).toEqual([999, 0.001]);
    for (const [value, part] of tail) expect(part).toBeCloseTo(1 - value / 1000, 2);
  });
});
