import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { Box, ground, kerb, pole, rampFrom0, stairs } from '../../support/world/scenes.js';
import type { Solid } from '../../support/world/Solid.js';
import { World } from '../../support/world/World.js';
import { WorldWalker } from '../../support/world/WorldWalker.js';

/** Walked for half a second each: velocity along x and z, and whether it begins with a jump. */
type Script = readonly (readonly [number, number, boolean?])[];

const PLACES: [string, () => Solid[], Script][] = [
  [
    'flat ground with boxes',
    () => [
      ground(),
      new Box(0.5, 0.5, 0.5).at(2, 0.5, 0.3).turn({ yaw: 0.4 }),
      new Box(0.4, 1, 0.8).at(0.5, 1, 2).turn({ yaw: -0.8 }),
      kerb(0.3, 4, 0.2),
      pole(1, -1.9, 0.15),
    ],
    [
      [3, 0],
      [3, 1],
      [0, 3],
      [-3, 2],
      // Not head-on at a corner or a pole: which side it leaves on would be chance.
      [-3, -1],
      [0, -6],
      [6, 0, true],
      [6, 2],
      [3, 0, true],
      [0, 0],
    ],
  ],
  [
    'a ramp',
    () => [ground(), rampFrom0(0.5)],
    [
      [3, 0],
      [3, 1],
      [6, 0],
      [0, 3],
      [3, -3, true],
      [-6, 0],
      [-6, 0],
      [3, 0],
      [3, 0, true],
      [0, 0],
    ],
  ],
  [
    'stairs',
    () => [ground(), ...stairs(8, 0.17, 0.29)],
    [
      [3, 0],
      [3, 1],
      [3, 0],
      [0, -3],
      [-3, 0, true],
      [-3, 1],
      [6, 0],
      [3, 1],
      [-3, 0],
      [0, 0],
    ],
  ],
];
const RATES = [20, 30, 60, 144];

describe.each(PLACES)('a scripted path on %s', (_, solids, script) => {
  it.each([0, 2])('should end in the same place at every rate, fields %i late', (latency) => {
    const ends = RATES.map((rate) => {
      const walker = new WorldWalker(new World(...solids()), {
        rate,
        latency,
        foot: [-1, 0.02, 0],
      });
      walker.settle(0.5);
      for (const [x, z, jumps] of script) {
        if (jumps) walker.character.jump();
        walker.walk(x, z).run(0.5);
      }
      walker.walk(0).run(1);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
      return walker.foot.clone();
    });
    const apart = Math.max(...ends.flatMap((a) => ends.map((b) => a.distanceTo(b))));
    const where = ends
      .map((end) =>
        end
          .toArray()
          .map((n) => n.toFixed(3))
          .join(' '),
      )
      .join(' | ');
    expect(apart, where).toBeLessThan(0.05);
    expect(ends[2]!.distanceTo(new Vector3(-1, 0.02, 0)), where).toBeGreaterThan(0.5);
  });
});
