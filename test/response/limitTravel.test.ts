import fc from 'fast-check';
import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { AxisMaxima } from '../../src/cube/AxisMaxima.js';
import { texelDirections } from '../../src/cube/texelDirections.js';
import { clipWish } from '../../src/response/clipWish.js';
import { approach, limitTravel } from '../../src/response/limitTravel.js';

const coordinate = fc.double({ min: -1, max: 1, noNaN: true });

describe('approach', () => {
  it('should be the largest dot product with any direction of the face (seed 8)', () => {
    const n = 64;
    const directions = texelDirections(n);
    fc.assert(
      fc.property(
        coordinate,
        coordinate,
        coordinate,
        fc.integer({ min: 0, max: 5 }),
        (x, y, z, face) => {
          let most = -Infinity;
          for (let i = 3 * face * n * n; i < 3 * (face + 1) * n * n; i += 3) {
            const dot = x * directions[i]! + y * directions[i + 1]! + z * directions[i + 2]!;
            most = Math.max(most, dot);
          }
          // Texels' middles stop half a texel short of the face's rim.
          expect(approach(face, x, y, z)).toBeGreaterThanOrEqual(most - 1e-6);
          expect(approach(face, x, y, z)).toBeLessThan(most + 0.04);
        },
      ),
      { numRuns: 300, seed: 8 },
    );
  });
});

describe('limitTravel', () => {
  it('should keep everything a face can have seen farther off than rMin (seed 9)', () => {
    const red = fc.double({ min: 0, max: 1, noNaN: true });
    fc.assert(
      fc.property(
        fc.array(red, { minLength: 6, maxLength: 6 }),
        fc.tuple(coordinate, coordinate, coordinate),
        fc.tuple(coordinate, coordinate, coordinate),
        (reds, travel, surface) => {
          const maxima = new AxisMaxima(0.5, 1);
          maxima.red.set(reds);
          const part = limitTravel(maxima, maxima.center, new Vector3(...travel));
          const moved = new Vector3(...travel).multiplyScalar(part);
          expect(part).toBeGreaterThanOrEqual(0);
          expect(part).toBeLessThanOrEqual(1);
          // Any surface of that face, as near as its red allows.
          const ray = new Vector3(...surface).normalize();
          fc.pre(ray.lengthSq() > 0.5);
          const axes = ray.toArray();
          const axis = axes.map(Math.abs).indexOf(Math.max(...axes.map(Math.abs)));
          const face = 2 * axis + (axes[axis]! < 0 ? 1 : 0);
          // A tangent plane there: nothing farther off than its red says can come nearer than this.
          const left = 1 - maxima.penetration(face) - moved.dot(ray);
          const always = moved.length() <= 0.1 * 0.5 + 1e-9;
          if (!always) expect(left).toBeGreaterThan(0.5 + 0.05 - 1e-6);
        },
      ),
      { numRuns: 5000, seed: 9 },
    );
  });

  it.each([
    // shell 0.5 m, wall at +X; what is left of a travel of 0.4 m.
    ['nothing near, all of it', 0, [0.4, 0, 0], 1],
    ['0.25 m deep in +X, 0.2 m toward it', 0.5, [0.4, 0, 0], 0.5],
    ['0.25 m deep in +X, all away from it', 0.5, [-0.4, 0, 0], 1],
    ['0.45 m deep in +X, the tenth of the shell that is always free', 0.9, [0.4, 0, 0], 0.125],
  ])('should allow with %s', (_, red, travel, part) => {
    const maxima = new AxisMaxima(0.5, 1);
    maxima.red[0] = red;
    const got = limitTravel(
      maxima,
      new Vector3(),
      new Vector3(...(travel as [number, number, number])),
    );
    expect(got).toBeCloseTo(part, 2);
  });

  it('should allow the way back, not the way on, from where the data end', () => {
    const maxima = new AxisMaxima(0.5, 1);
    const center = new Vector3(0, 0.49, 0);
    expect(limitTravel(maxima, center, new Vector3(0, 0.1, 0))).toBe(0);
    expect(limitTravel(maxima, center, new Vector3(0, -0.1, 0))).toBe(1);
  });
});

describe('clipWish', () => {
  const touching = (depth: number) => {
    const maxima = new AxisMaxima(0.5, 1);
    maxima.red[0] = depth / 0.5;
    maxima.direction.set([1, 0, 0], 0);
    return maxima;
  };
  it.each([
    ['into a wall, nothing', 0.02, [0.3, 0.1, 0.2], [0, 0.1, 0.2]],
    ['into a wall just touched, up to touch', 0.004, [0.3, 0.1, 0.2], [0.006, 0.1, 0.2]],
    ['away from it, all', 0.02, [-0.3, 0.1, 0.2], [-0.3, 0.1, 0.2]],
    ['in the open, all', 0, [0.3, 0.1, 0.2], [0.3, 0.1, 0.2]],
  ] as const)('should leave of a wish %s', (_, depth, wish, want) => {
    const got = clipWish(touching(depth), new Vector3(), new Vector3(...wish)).toArray();
    want.forEach((value, i) => expect(got[i]).toBeCloseTo(value, 6));
  });
});
