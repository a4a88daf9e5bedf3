import { describe, expect, it } from 'vitest';
import { FACES } from '../../src/cube/faces.js';
import { UNFOLDED } from '../../src/helpers/unfold.js';

type Triple = readonly [number, number, number];
const sum = (a: Triple, b: Triple, sign = 1) => a.map((entry, i) => entry + sign * b[i]!);

describe('the unfolded cube', () => {
  it('should run on over every inner join, no face turned or mirrored', () => {
    let joins = 0;
    UNFOLDED.forEach(([column, row], one) => {
      UNFOLDED.forEach(([otherColumn, otherRow], other) => {
        const a = FACES[one]!;
        const b = FACES[other]!;
        if (otherColumn === column + 1 && otherRow === row) {
          joins++;
          // The same edge of the cube, the same way up.
          expect(sum(a.forward, a.right)).toEqual(sum(b.forward, b.right, -1));
          expect(a.up).toEqual(b.up);
        } else if (otherRow === row + 1 && otherColumn === column) {
          joins++;
          expect(sum(a.forward, a.up)).toEqual(sum(b.forward, b.up, -1));
          expect(a.right).toEqual(b.right);
        }
      });
    });
    expect(joins).toBe(5);
    expect(new Set(UNFOLDED.map(String)).size).toBe(6);
  });
});
