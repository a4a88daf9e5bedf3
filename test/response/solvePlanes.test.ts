import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { seeded } from '../../e2e/support/axisScenes.js';
import { MOST_PLANES, Planes, solvePlanes } from '../../src/response/solvePlanes.js';

/** Solutions may break a plane by this much, metres. */
const TOLERANCE = 1.1e-6;

type Triple = readonly [number, number, number];
interface Plane {
  n: Triple;
  bound: number;
}

const number = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const unit = fc.tuple(number(-1, 1), number(-Math.PI, Math.PI)).map(([y, yaw]): Triple => {
  const level = Math.sqrt(1 - y * y);
  return [level * Math.cos(yaw), y, level * Math.sin(yaw)];
});
const wish = fc.tuple(number(-0.3, 0.3), number(-0.3, 0.3), number(-0.3, 0.3));
const planesOf = (bound: fc.Arbitrary<number>, maxLength = 6) =>
  fc.array(fc.record({ n: unit, bound }), { minLength: 1, maxLength });
const solvable = planesOf(number(-0.2, 0));
const any = planesOf(number(-0.2, 0.1));

const dot = (a: Triple, b: Triple) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const apart = (a: Triple, b: Triple) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

function solve(list: readonly Plane[], [x, y, z]: Triple): { at: Triple; slack: number } {
  const planes = new Planes();
  for (const { n, bound } of list) planes.add(...n, bound);
  const d = { x, y, z };
  const slack = solvePlanes(planes, d);
  return { at: [d.x, d.y, d.z], slack };
}

/** By how much the point breaks the plane it breaks most. */
const broken = (list: readonly Plane[], at: Triple): number =>
  Math.max(...list.map(({ n, bound }) => bound - dot(n, at)));

describe('solvePlanes', () => {
  it('should leave alone what is allowed (seed 31)', () => {
    fc.assert(
      fc.property(solvable, wish, (list, d) => {
        fc.pre(broken(list, d) <= 0);
        expect(solve(list, d)).toEqual({ at: d, slack: 0 });
      }),
      { numRuns: 300, seed: 31 },
    );
  });

  it('should keep all planes that can be kept (seed 32)', () => {
    fc.assert(
      fc.property(solvable, wish, (list, d) => {
        // Bounds of 0 and less allow to stay.
        const { at, slack } = solve(list, d);
        expect(slack).toBe(0);
        expect(broken(list, at)).toBeLessThan(TOLERANCE);
      }),
      { numRuns: 2000, seed: 32 },
    );
  });

  it('should keep all planes to within the slack it tells (seed 33)', () => {
    fc.assert(
      fc.property(any, wish, (list, d) => {
        const { at, slack } = solve(list, d);
        expect(slack).toBeGreaterThanOrEqual(0);
        expect(broken(list, at) - slack).toBeLessThan(TOLERANCE);
      }),
      { numRuns: 2000, seed: 33 },
    );
  });

  it('should come nearer to the wish than any other allowed place (seed 34)', () => {
    const random = seeded(34);
    const between = (low: number, high: number) => low + (high - low) * random();
    fc.assert(
      fc.property(solvable, wish, (list, d) => {
        const { at } = solve(list, d);
        const distance = apart(at, d);
        for (let i = 0; i < 1000; i++) {
          // Half of them around the solution: nearer ones would be found there.
          const [x, y, z] = i % 2 ? at : d;
          const around = i % 2 ? 10 ** between(-5, -1) : 0.5;
          const other: Triple = [
            x + around * between(-1, 1),
            y + around * between(-1, 1),
            z + around * between(-1, 1),
          ];
          if (broken(list, other) > 0) continue;
          expect(apart(other, d)).toBeGreaterThan(distance - 1e-5);
        }
      }),
      { numRuns: 200, seed: 34 },
    );
  });

  it('should find the one nearest place: on what it lies pushes back, and nothing pulls (seed 35)', () => {
    // Of a convex set the foot f of d is the place where (g - f) · (d - f) <= 0 for every other place g of it.
    fc.assert(
      fc.property(solvable, wish, wish, (list, d, other) => {
        const { at } = solve(list, d);
        const inner = solve(list, other).at;
        const product =
          (inner[0] - at[0]) * (d[0] - at[0]) +
          (inner[1] - at[1]) * (d[1] - at[1]) +
          (inner[2] - at[2]) * (d[2] - at[2]);
        expect(product).toBeLessThan(1e-5);
      }),
      { numRuns: 2000, seed: 35 },
    );
  });

  it('should give way by half of what is missing between opposing planes, to the middle (seed 36)', () => {
    fc.assert(
      fc.property(unit, wish, number(-0.2, 0.2), number(0.001, 0.2), (n, d, at, missing) => {
        const back: Triple = [-n[0], -n[1], -n[2]];
        const list = [
          { n, bound: at + missing / 2 },
          { n: back, bound: missing / 2 - at },
        ];
        const found = solve(list, d);
        // The search ends after twelve halvings of what the bounds ask for at most.
        const close = (Math.abs(at) + missing / 2) / 4096 + TOLERANCE;
        expect(Math.abs(found.slack - missing / 2)).toBeLessThan(close);
        expect(Math.abs(dot(n, found.at) - at)).toBeLessThan(2 * close);
        // Along the planes the wish is free.
        const off = dot(n, d) - dot(n, found.at);
        const level: Triple = [d[0] - off * n[0], d[1] - off * n[1], d[2] - off * n[2]];
        expect(apart(level, found.at)).toBeLessThan(1e-9);
      }),
      { numRuns: 500, seed: 36 },
    );
  });

  it('should not depend on the order of the planes (seed 37)', () => {
    const shuffled = any.chain((list) =>
      fc.tuple(
        fc.constant(list),
        fc.shuffledSubarray(list, { minLength: list.length, maxLength: list.length }),
      ),
    );
    fc.assert(
      fc.property(shuffled, wish, ([list, other], d) => {
        const a = solve(list, d);
        const b = solve(other, d);
        expect(b.slack).toBeCloseTo(a.slack, 9);
        expect(apart(a.at, b.at)).toBeLessThan(1e-5);
      }),
      { numRuns: 2000, seed: 37 },
    );
  });

  it('should drop the least urgent of too many planes, whatever their order', () => {
    const bounds = Array.from({ length: MOST_PLANES + 3 }, (_, i) => -i / 100);
    for (const order of [bounds, bounds.slice().reverse()]) {
      const planes = new Planes();
      for (const bound of order) planes.add(0, 1, 0, bound);
      expect(planes.count).toBe(MOST_PLANES);
      expect([...planes.bound].sort((a, b) => b - a)).toEqual(bounds.slice(0, MOST_PLANES));
    }
  });
});
