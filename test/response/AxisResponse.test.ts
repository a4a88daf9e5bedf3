import fc from 'fast-check';
import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { AxisMaxima } from '../../src/cube/AxisMaxima.js';
import { AxisResponse, penetrationAt } from '../../src/response/AxisResponse.js';

/** Maxima of a sphere of 0.5 m with a shell of 0.25 m: face, red, direction. */
function maximaOf(...winners: [face: number, red: number, x: number, y: number, z: number][]) {
  const maxima = new AxisMaxima(0.25, 0.5);
  for (const [face, red, x, y, z] of winners) {
    maxima.red[face] = red;
    maxima.direction.set([x, y, z], 3 * face);
  }
  return maxima;
}
const respond = (maxima: AxisMaxima, response = new AxisResponse(), center = maxima.center) =>
  response.respond(maxima, center, new Vector3(9, 9, 9)).toArray();
const close = (got: number[], want: number[]) =>
  want.forEach((value, i) => expect(got[i]).toBeCloseTo(value, 6));

describe('AxisResponse', () => {
  it.each([
    // One wall met head-on, red 0.4: 0.1 m deep; half of it undone sideways, all of it upright.
    ['+X', [0, 0.4, 1, 0, 0], [-0.05, 0, 0]],
    ['-X', [1, 0.4, -1, 0, 0], [0.05, 0, 0]],
    ['+Y', [2, 0.4, 0, 1, 0], [0, -0.1, 0]],
    ['-Y', [3, 0.4, 0, -1, 0], [0, 0.1, 0]],
    ['+Z', [4, 0.4, 0, 0, 1], [0, 0, -0.05]],
    ['-Z', [5, 0.4, 0, 0, -1], [0, 0, 0.05]],
  ] as const)('(23)-(25) should push away from a wall at %s', (_, winner, want) => {
    close(respond(maximaOf([...winner])), [...want]);
  });

  it.each([
    // (17)-(22) keep the face's own coordinate: 0.1 · 0.8 of the direction (0.8, 0.6, 0).
    ['one component a face', [[0, 0.4, 0.8, 0.6, 0]], [-0.04, 0, 0]],
    // max + min: 0.1 - 0.04 = 0.06.
    [
      'the difference of two',
      [
        [0, 0.4, 1, 0, 0],
        [1, 0.16, -1, 0, 0],
      ],
      [-0.03, 0, 0],
    ],
    [
      'nothing for equals',
      [
        [2, 0.3, 0, 1, 0],
        [3, 0.3, 0, -1, 0],
      ],
      [0, 0, 0],
    ],
    // A floor, a wall and a slanting one: y 0.02, x -0.5·0.05·0.9, z 0.5·0.1·0.7.
    [
      'three faces at once',
      [
        [3, 0.08, 0, -1, 0],
        [0, 0.2, 0.9, 0, 0.43589],
        [5, 0.4, 0.5, 0.5099, -0.7],
      ],
      [-0.0225, 0.02, 0.035],
    ],
    ['nothing of an empty cubemap', [], [0, 0, 0]],
  ] as [string, [number, number, number, number, number][], number[]][])(
    'should take %s',
    (_, winners, want) => close(respond(maximaOf(...winners)), want),
  );

  it('should scale with the shell, not with red alone (mend of (14)-(16))', () => {
    const maxima = maximaOf([3, 0.5, 0, -1, 0]);
    maxima.rMin = 1;
    maxima.rMax = 3;
    close(respond(maxima), [0, 1, 0]);
  });

  it('should drop horizontal pushes below hMax, and only those', () => {
    const maxima = maximaOf([0, 0.4, 1, 0, 0], [3, 0.1, 0, -1, 0], [4, 0.8, 0, 0, 1]);
    close(respond(maxima, new AxisResponse({ hMax: 0.06 })), [0, 0.025, -0.1]);
    close(respond(maxima, new AxisResponse({ hMax: 0.05 - 1e-6 })), [-0.05, 0.025, -0.1]);
  });

  it('should leave a corridor centred in one go with c = 1/2, for any widths (seed 6)', () => {
    const depth = fc.double({ min: 0.001, max: 1, noNaN: true });
    fc.assert(
      fc.property(depth, depth, fc.constantFrom(0, 4), (a, b, face) => {
        const one = face === 0 ? [1, 0, 0] : [0, 0, 1];
        const maxima = maximaOf(
          [face, a, one[0]!, 0, one[2]!],
          [face + 1, b, -one[0]!, 0, -one[2]!],
        );
        const [x, , z] = respond(maxima);
        const moved = new Vector3(x, 0, z);
        const left = penetrationAt(maxima, face, moved) - penetrationAt(maxima, face + 1, moved);
        // Unless one of them was clamped at the shell's end.
        fc.pre(Math.max(a, b) + Math.abs(a - b) / 2 < 1);
        expect(Math.abs(left)).toBeLessThan(1e-7);
      }),
      { numRuns: 2000, seed: 6 },
    );
  });

  it('should know how deep a plane is from elsewhere, to the shell’s ends (seed 7)', () => {
    const coordinate = fc.double({ min: -0.3, max: 0.3, noNaN: true });
    fc.assert(
      fc.property(
        fc.integer({ min: 0, max: 5 }),
        fc.double({ min: 0.01, max: 1, noNaN: true }),
        fc.tuple(coordinate, coordinate, coordinate),
        (face, red, [x, y, z]) => {
          const direction = [0, 0, 0];
          direction[face >> 1] = face & 1 ? -1 : 1;
          const maxima = maximaOf([face, red, direction[0]!, direction[1]!, direction[2]!]);
          maxima.center.set(3, 4, 5);
          const moved = [x, y, z][face >> 1]! * direction[face >> 1]!;
          const distance = 0.5 - 0.25 * red - moved;
          const want = Math.min(0.25, Math.max(0, 0.5 - distance));
          const center = new Vector3(3 + x, 4 + y, 5 + z);
          expect(penetrationAt(maxima, face, center)).toBeCloseTo(want, 6);
        },
      ),
      { numRuns: 2000, seed: 7 },
    );
  });

  it('should hear nothing from a face with red 0, wherever the sphere has gone', () => {
    const maxima = maximaOf([0, 0, 1, 0, 0]);
    expect(respond(maxima, undefined, new Vector3(0.2, 0, 0))).toEqual([0, 0, 0].map((v) => -v));
  });

  it.each([
    [{ cXZ: 0 }, '"cXZ" must'],
    [{ cXZ: 1 }, '"cXZ" must'],
    [{ cXZ: 0.8, cY: 0.8 }, '"cXZ" must'],
    [{ cXZ: NaN }, '"cXZ" must'],
    [{ cY: 1.1 }, '"cY" must'],
    [{ cY: 0 }, '"cY" must'],
    [{ cY: NaN }, '"cY" must'],
    [{ hMax: -0.1 }, '"hMax" must'],
    [{ hMax: Infinity }, '"hMax" must'],
  ])('should refuse %j', (options, message) => {
    expect(() => new AxisResponse(options)).toThrow(RangeError);
    expect(() => new AxisResponse(options)).toThrow(`AxisResponse: ${message}`);
  });
});
