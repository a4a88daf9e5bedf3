import fc from 'fast-check';
import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { AxisMaxima } from '../../src/cube/AxisMaxima.js';
import { axisMaxima, axisMaximaAt } from '../../src/field/axisMaxima.js';
import { SurfaceField } from '../../src/field/SurfaceField.js';
import { redTexels } from '../support/AnalyticCollider.js';
import { ball, box, plane, type Shape, union } from '../support/analytic.js';

const fieldOf = (shape: Shape, center: Vector3, resolution: number, far = 2) =>
  SurfaceField.from(
    (c, [x, y, z]) => ({ distance: shape(c.x, c.y, c.z, x, y, z), normal: [-x, -y, -z] }),
    { resolution, far, center },
  );

const number = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const scenes = fc
  .tuple(number(-0.4, 0.4), number(-0.4, 0.4), number(0.05, 0.6))
  .map(([a, b, c]) => {
    const rock = ball(0.6 * a + 0.3, b, -0.3, 0.4 * c);
    return union(plane(a, 1, b, -c), box(0.2 + c / 3, a, b - 0.5, 1.5, a + 0.4, b + 0.5), rock);
  });

describe('axisMaxima', () => {
  it('should find the highest red of each face, by brute force over rays (seed 4)', () => {
    fc.assert(
      fc.property(scenes, fc.constantFrom(1, 4, 7, 16), (shape, n) => {
        const center = new Vector3(0.01, 0.02, 0.03);
        const found = axisMaxima(fieldOf(shape, center, n), new AxisMaxima(0.1, 0.5));
        expect(found.center.equals(center)).toBe(true);
        for (let face = 0; face < 6; face++) {
          const options = { resolution: n, rMin: 0.1, rMax: 0.5, quantised: false };
          const red = redTexels(shape, center, face, options);
          const winner = found.texel[2 * face]! + n * found.texel[2 * face + 1]!;
          expect(found.red[face]).toBeCloseTo(Math.max(...red), 5);
          expect(red[winner]).toBeCloseTo(Math.max(...red), 5);
        }
      }),
      { numRuns: 300, seed: 4 },
    );
  });

  it.each([
    [4, 1, 1],
    [5, 2, 2],
    [16, 7, 7],
  ])('should settle ties of N = %i for the first texel nearest to the middle', (n, x, y) => {
    const field = new SurfaceField(n, 1);
    field.distance.fill(0.25);
    const found = axisMaxima(field, new AxisMaxima(0.2, 0.4));
    for (let face = 0; face < 6; face++) {
      expect([...found.texel.subarray(2 * face, 2 * face + 2)]).toEqual([x, y]);
      expect(found.red[face]).toBeCloseTo(0.75, 6);
    }
  });

  it('should prefer a redder texel at the rim to the middle, and the middle where all is empty', () => {
    const field = new SurfaceField(4, 1);
    field.distance[16 * 2 + 3] = 0.3; // +Y, row 0, column 3
    const found = axisMaxima(field, new AxisMaxima(0.2, 0.4));
    expect([...found.texel]).toEqual([1, 1, 1, 1, 3, 0, 1, 1, 1, 1, 1, 1]);
    expect([...found.red].map((red) => red > 0)).toEqual([false, false, true, false, false, false]);
  });
});

describe('axisMaximaAt', () => {
  it('should see a plane from where the sphere is now as deep as it is (seed 5)', () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 0, max: 5 }),
        number(0.2, 0.34),
        fc.tuple(number(-0.2, 0.2), number(-0.2, 0.2), number(-0.2, 0.2)),
        (face, distance, [x, y, z]) => {
          const axis = face >> 1;
          const sign = face & 1 ? -1 : 1;
          const normal = [0, 0, 0];
          normal[axis] = 1;
          const center = new Vector3(x, y, z);
          const wall = plane(
            normal[0]!,
            normal[1]!,
            normal[2]!,
            center.getComponent(axis) + sign * distance,
          );
          // Drawn up to 0.35 m away, still on this side of the wall.
          const field = fieldOf(wall, new Vector3(), 32);
          fc.pre(sign * (center.getComponent(axis) + sign * distance) > 0.05);
          const found = axisMaximaAt(field, center, new AxisMaxima(0.1, 0.35));
          expect(found.center.equals(center)).toBe(true);
          // Points at most √2/32 of 0.6 m off the foot of the perpendicular: up to 1.8 mm too far.
          expect(found.penetration(face)).toBeLessThanOrEqual(0.35 - distance + 1e-6);
          expect(found.penetration(face)).toBeGreaterThan(0.35 - distance - 0.002);
          expect(found.direction[3 * face + axis]! * sign).toBeGreaterThan(0.98);
          expect(found.red[face ^ 1]).toBe(0);
        },
      ),
      { numRuns: 500, seed: 5 },
    );
  });

  it('should equal axisMaxima at the field’s own centre', () => {
    const center = new Vector3(5, 6, 7);
    const field = fieldOf(ball(5.3, 6, 7, 0.1), center, 8);
    const here = axisMaximaAt(field, center.clone(), new AxisMaxima(0.1, 0.5));
    expect(here).toEqual(axisMaxima(field, new AxisMaxima(0.1, 0.5)));
  });
});
