import { BoxGeometry, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { Distribution } from '../bench/walk/Distribution.js';
import { HeldBackCollider } from '../bench/walk/HeldBackCollider.js';
import { Inputs } from '../bench/walk/Inputs.js';
import { Judge } from '../bench/walk/Judge.js';
import { Places } from '../bench/walk/Places.js';
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
