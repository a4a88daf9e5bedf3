import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { distanceOf, redOf, redStep } from '../../src/cube/axisRed.js';

describe('axisRed', () => {
  it.each([
    // distance, rMin, rMax, red
    [0.25, 0.25, 0.5, 1],
    [0.5, 0.25, 0.5, 0],
    [0.375, 0.25, 0.5, 0.5],
    [0.3, 0.2, 0.6, 0.75],
    [0.1, 0.25, 0.5, 1],
    [0, 0.25, 0.5, 1],
    [0.7, 0.25, 0.5, 0],
    [Infinity, 0.25, 0.5, 0],
  ])('(10) should make of %f m between %f and %f the red %f', (distance, rMin, rMax, red) => {
    expect(redOf(distance, rMin, rMax)).toBeCloseTo(red, 14);
  });

  it('should come back within half a step after 8 bits (seed 3)', () => {
    const part = fc.double({ min: 0, max: 1, noNaN: true });
    fc.assert(
      fc.property(part, fc.double({ min: 0.05, max: 2, noNaN: true }), part, (at, rMax, low) => {
        const rMin = 0.95 * low * rMax;
        const distance = rMin + at * (rMax - rMin);
        const red = Math.round(redOf(distance, rMin, rMax) * 255) / 255;
        const error = Math.abs(distanceOf(red, rMin, rMax) - distance);
        expect(error).toBeLessThanOrEqual(0.5 * redStep(rMin, rMax) + 1e-12);
      }),
      { numRuns: 5000, seed: 3 },
    );
  });
});
