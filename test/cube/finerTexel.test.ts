import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { finerDirection } from '../../src/cube/finerTexel.js';
import { texelIndex } from '../../src/cube/atlas.js';
import { directionTexel, texelDirections } from '../../src/cube/texelDirections.js';
import { seededRandom } from '../../e2e/support/thinThings.js';

describe('finerDirection', () => {
  it.each([2, 4])('should be the finer grid’s own, inside the texel (s = %i)', (s) => {
    const n = 5;
    const finer = texelDirections(s * n);
    const d = new Float32Array(3);
    for (let texel = 0; texel < 6 * n * n; texel++) {
      const face = Math.floor(texel / (n * n));
      const x = texel % n;
      const y = Math.floor(texel / n) % n;
      for (let row = 0; row < s; row++) {
        for (let column = 0; column < s; column++) {
          finerDirection(face, x, y, column + 4 * row, n, s, d, 0);
          const same = 3 * texelIndex(face, s * x + column, s * y + row, s * n);
          expect(d).toEqual(finer.slice(same, same + 3));
          expect(directionTexel(d[0]!, d[1]!, d[2]!, n)).toBe(texel);
        }
      }
    }
  });
});

/**
 * Flat bars across the line of sight, their outlines as hard to hit as any's of that width: how many of `count` none of
 * the texels' middles lies in.
 *
 * @param width of the bar over 2·z / (N·s), z its largest depth along a face's axis
 * @param length over its width
 * @param seam whether its middle lies on a seam between faces
 */
function missedBars(count: number, width: number, length: number, seam: boolean): number {
  const n = 16;
  const directions = texelDirections(n);
  const random = seededRandom(8);
  const any = () => new Vector3().set(2 * random() - 1, 2 * random() - 1, 2 * random() - 1);
  const depth = (v: Vector3) => Math.max(Math.abs(v.x), Math.abs(v.y), Math.abs(v.z));
  const end = new Vector3();
  let missed = 0;
  for (let i = 0; i < count; i++) {
    const middle = any();
    if (seam) middle.set(1, 2 * random() - 1, 1);
    middle.normalize();
    const along = any().cross(middle).normalize();
    const across = new Vector3().crossVectors(middle, along);
    let w = 0;
    // Its ends may be deeper, by which it must be wider, by which they move.
    for (let k = 0; k < 4; k++) {
      let deepest = depth(middle);
      for (const half of [-0.5, 0.5]) {
        deepest = Math.max(
          deepest,
          depth(end.copy(middle).addScaledVector(along, half * length * w)),
        );
      }
      w = (width * 2 * deepest) / n;
    }
    let seen = false;
    for (let k = 0; k < directions.length && !seen; k += 3) {
      end.fromArray(directions, k);
      const z = end.dot(middle);
      seen =
        z > 0.3 &&
        Math.abs(end.dot(across)) <= (z * w) / 2 &&
        Math.abs(end.dot(along)) <= (z * w * length) / 2;
    }
    if (!seen) missed++;
  }
  return missed;
}

describe('what the grid of texels must meet (seed 8)', () => {
  it.each([false, true])(
    'should be all that is a pitch wide and half as long again; seams: %s',
    (seam) => {
      expect(missedBars(3000, 1, 1.5, seam)).toBe(0);
    },
  );

  it.each([false, true])('should be all that is √2 pitches wide each way; seams: %s', (seam) => {
    expect(missedBars(3000, Math.SQRT2, 1, seam)).toBe(0);
  });

  it('should not be what is narrower or shorter', () => {
    expect(missedBars(3000, 0.7, 3, false)).toBeGreaterThan(0);
    expect(missedBars(3000, 1, 1, false)).toBeGreaterThan(0);
  });
});
