import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { atlasIndex, atlasSize, texelIndex } from '../../src/cube/atlas.js';
import { directionTexel, texelDirection, texelDirections } from '../../src/cube/texelDirections.js';

describe('texelDirections', () => {
  it.each([1, 2, 3, 8, 32, 33])('should name each of its own texels again (N = %i)', (n) => {
    const directions = texelDirections(n);
    for (let texel = 0; texel < 6 * n * n; texel++) {
      const [x, y, z] = directions.subarray(3 * texel, 3 * texel + 3) as unknown as number[];
      expect(Math.hypot(x!, y!, z!)).toBeCloseTo(1, 6);
      expect(directionTexel(x!, y!, z!, n)).toBe(texel);
    }
  });

  it('should be (14)-(16) with r = 1: φ from +Y, θ from +Z toward +X', () => {
    const d: number[] = [];
    // N = 4, face +Z, column 0 (right is -X, so x > 0: u = -3/4), row 3 (v = 3/4), by hand.
    texelDirection(4, 0, 3, 4, d);
    const phi = Math.acos(0.75 / Math.sqrt(1 + 2 * 0.75 ** 2));
    const theta = Math.atan2(0.75, 1);
    expect(d[0]).toBeCloseTo(Math.sin(theta) * Math.sin(phi), 14);
    expect(d[1]).toBeCloseTo(Math.cos(phi), 14);
    expect(d[2]).toBeCloseTo(Math.cos(theta) * Math.sin(phi), 14);
  });

  it('should give any direction a texel no farther than half a texel away (seed 2)', () => {
    const coordinate = fc.double({ min: -1, max: 1, noNaN: true });
    fc.assert(
      fc.property(
        coordinate,
        coordinate,
        coordinate,
        fc.integer({ min: 1, max: 64 }),
        (x, y, z, n) => {
          const length = Math.hypot(x, y, z);
          fc.pre(length > 1e-3);
          const texel = directionTexel(x, y, z, n);
          const d: number[] = [];
          texelDirection(Math.floor(texel / (n * n)), texel % n, Math.floor(texel / n) % n, n, d);
          const cosine = (x * d[0]! + y * d[1]! + z * d[2]!) / length;
          // Half a texel's diagonal at the face's middle, where texels are largest: √2/N of the unit depth.
          expect(Math.acos(Math.min(1, cosine))).toBeLessThan(Math.atan(Math.SQRT2 / n) + 1e-6);
        },
      ),
      { numRuns: 5000, seed: 2 },
    );
  });

  it('should give each texel its own place in the atlas', () => {
    const n = 5;
    const { width, height } = atlasSize(n);
    const places = new Set<number>();
    const numbers = new Set<number>();
    for (let face = 0; face < 6; face++) {
      for (let y = 0; y < n; y++) {
        for (let x = 0; x < n; x++) {
          places.add(atlasIndex(face, x, y, n));
          numbers.add(texelIndex(face, x, y, n));
        }
      }
    }
    expect(places.size).toBe(width * height);
    expect(Math.max(...places)).toBe(width * height - 1);
    expect(numbers.size).toBe(6 * n * n);
  });
});
