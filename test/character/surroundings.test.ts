import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { surroundings, vouchedTravel, vouchesFor } from '../../src/character/surroundings.js';
import { AxisMaxima } from '../../src/cube/AxisMaxima.js';
import { AnalyticCollider, type AnalyticOptions } from '../support/AnalyticCollider.js';
import { plane } from '../support/analytic.js';

const R = 0.35;
const wall = plane(1, 0, 0, 0.8);

function drawn(options: AnalyticOptions) {
  const collider = new AnalyticCollider(wall, { readback: 'sync', resolution: 32, ...options });
  expect(vouchesFor(collider, new Vector3(), R)).toBe(false);
  collider.update();
  return collider;
}

describe('surroundings', () => {
  it.each([
    ['maxima, within the shell', { output: 'axis' }, 0.174, true],
    ['maxima, beyond it', { output: 'axis' }, 0.176, false],
    ['a field, within its reach', { output: 'surface' }, 1.44, true],
    ['a field, beyond it', { output: 'surface' }, 1.46, false],
    [
      'a coarse field, where its points are dense',
      { output: 'surface', resolution: 16 },
      0.6,
      true,
    ],
    ['a coarse field, where they are not', { output: 'surface', resolution: 16 }, 0.7, false],
  ] as const)('should be vouched for by %s: %j, %f m off, %s', (_, options, off, want) => {
    const collider = drawn(options);
    const center = new Vector3(0, off, 0);
    expect(vouchesFor(collider, center, R)).toBe(want);
    expect(surroundings(collider, center, new AxisMaxima(R / 2, R)) !== null).toBe(want);
  });

  it('should never vouch for a place behind a surface that the field saw', () => {
    const collider = drawn({ output: 'surface' });
    const nothingNear = new AxisMaxima(R / 2, R);
    const center = nothingNear.center.set(0.68, 0, 0);
    const travel = (x: number) =>
      vouchedTravel(collider, nothingNear, center, new Vector3(x, 0, 0));
    expect(travel(0.02)).toBe(1);
    // To 0.78, 0.82 and 1.68, the wall being at 0.8: each goes as far as half of rMin before it, and no farther.
    for (const x of [0.1, 0.14, 1]) {
      const place = 0.68 + x * travel(x);
      expect(place).toBeLessThan(0.8 - R / 4 + 0.002);
      expect(place).toBeGreaterThan(0.8 - R / 4 - 0.02);
    }
    expect(travel(-0.1)).toBe(1);
  });
});
