import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import {
  Box,
  ground,
  kerb,
  pole,
  ramp,
  rampFrom0,
  stairs,
  wall,
} from '../../support/world/scenes.js';
import type { Solid } from '../../support/world/Solid.js';
import { World } from '../../support/world/World.js';
import { WorldWalker } from '../../support/world/WorldWalker.js';

const UPS: [string, Vector3][] = [
  ['+Z', new Vector3(0, 0, 1)],
  ['-Y', new Vector3(0, -1, 0)],
  ['a slant', new Vector3(0.4, 0.7, -0.5).normalize()],
];

describe.each(UPS)('with %s up', (_, up) => {
  const walker = (solids: Solid[], foot: readonly [number, number, number], latency = 0) =>
    new WorldWalker(new World(...solids), { up, foot, latency });

  it('should stand on the flat and on a slope without a tremor', () => {
    for (const solids of [[ground()], [ramp(0.5)], [ground(), kerb(0.15)]]) {
      const standing = walker(solids, [-0.1, 0.3, 0.1]).settle();
      const from = standing.foot.clone();
      const { draws } = standing.collider;
      standing.run(5);
      expect(standing.foot.distanceTo(from)).toBeLessThan(1e-4);
      expect(standing.collider.draws - draws).toBeLessThan(3);
      expect(standing.gap).toBeGreaterThan(0.01);
      expect(standing.gap).toBeLessThan(0.025);
      expect(standing.character.grounded).toBe(true);
    }
  });

  it('should walk as with +Y up', () => {
    const path = (towards: Vector3) => {
      const solids = [
        ground(),
        wall(2.5),
        new Box(0.5, 0.5, 0.5).at(1, 0.5, 1.5).turn({ yaw: 0.4 }),
        kerb(0.3, -1.5, Math.PI),
      ];
      const walking = new WorldWalker(new World(...solids), { up: towards, foot: [0, 0.02, 0] });
      walking.settle(0.3);
      const places: Vector3[] = [];
      for (const [x, z] of [
        [3, 0],
        [3, 2],
        [-3, 3],
        [0, -4],
        [-5, 0],
        [-3, 1],
        [0, 0],
      ] as const) {
        walking.walk(x, z).run(0.5);
        places.push(walking.foot.clone());
      }
      expect(walking.worst, walking.worstAt).toBeLessThan(0.01);
      return places;
    };
    const expected = path(new Vector3(0, 1, 0));
    // The cubemap's grid lies otherwise to the scene on a slant.
    const tolerance = _ === 'a slant' ? 0.02 : 0.001;
    path(up).forEach((place, i) =>
      expect(place.distanceTo(expected[i]!), `after ${i + 1}`).toBeLessThan(tolerance),
    );
  });

  it('should climb 0.39 m and 49°, and refuse 0.41 m and 51°', () => {
    for (const degrees of [0, 40]) {
      const yaw = (degrees * Math.PI) / 180;
      const start = [-1 / Math.cos(yaw), 0.02, 0] as const;
      const up39 = walker([ground(), kerb(0.39, 0, yaw)], start, 1)
        .walk(3)
        .run(1.5);
      expect(up39.foot.y, up39.story).toBeGreaterThan(0.39);
      const up41 = walker([ground(), kerb(0.41, 0, yaw)], start, 1)
        .walk(3)
        .run(1.5);
      expect(up41.foot.y, up41.story).toBeLessThan(0.05);
    }
    for (const [degrees, climbs] of [
      [49, true],
      [51, false],
    ] as const) {
      const solids = [ground(), rampFrom0((degrees * Math.PI) / 180)];
      const climbing = walker(solids, [-1, 0.02, 0]).walk(3).run(1.2);
      expect(climbing.foot.y > 0.8, climbing.story).toBe(climbs);
      if (!climbs) expect(climbing.foot.y, climbing.story).toBeLessThan(0.1);
    }
  });

  it('should walk stairs, jump and fall', () => {
    const stepping = walker([ground(), ...stairs(6, 0.17, 0.29)], [-1, 0.02, 0])
      .walk(3)
      .run(1.5);
    expect(stepping.foot.y, stepping.story).toBeGreaterThan(1.02);
    const from = stepping.walk(0).run(0.3).foot.y;
    let top = 0;
    expect(stepping.character.jump()).toBe(true);
    stepping.run(1, () => (top = Math.max(top, stepping.foot.y - from)));
    expect(top).toBeGreaterThan(1.07);
    expect(top).toBeLessThan(1.13);
    const falling = walker([ground(), pole(2, 0)], [0, 12, 0], 2).run(3);
    expect(falling.foot.y).toBeCloseTo(0.02, 2);
    expect(falling.worst, falling.worstAt).toBeLessThan(0.01);
  });
});
