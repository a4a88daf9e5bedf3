import { describe, expect, it } from 'vitest';
import {
  block,
  ground,
  kerb,
  pole,
  ramp,
  stairs,
  table,
  wall,
} from '../../support/world/scenes.js';
import type { Solid } from '../../support/world/Solid.js';
import { World } from '../../support/world/World.js';
import { WorldWalker } from '../../support/world/WorldWalker.js';

type Place = [string, () => Solid[], readonly [number, number, number]];

const PLACES: Place[] = [
  ['flat ground', () => [ground()], [0.013, 0.3, 0.021]],
  ['a slope of 30°', () => [ramp(Math.PI / 6)], [0, 0.4, 0]],
  ['a slope of 45°', () => [ramp(Math.PI / 4)], [0, 0.4, 0]],
  ['the edge of a stair', () => [ground(), ...stairs(6, 0.17, 0.29)], [0.57, 0.8, 0]],
  ['a stair, half over it', () => [ground(), ...stairs(6, 0.17, 0.29)], [0.72, 0.8, 0.2]],
  ['a kerb, just on it', () => [ground(), kerb(0.15)], [0.05, 0.3, 0]],
  ['a kerb, half off', () => [ground(), kerb(0.15)], [-0.1, 0.3, 0]],
  ['a high edge, a hand over it', () => [ground(-3), kerb(0.15)], [-0.15, 0.3, 0]],
  ['a corridor', () => [ground(), wall(0.365), wall(-0.365)], [0.003, 0.1, 0]],
  ['a corridor as wide as a skin allows', () => [ground(), wall(0.38), wall(-0.38)], [0, 0.1, 0]],
  ['a table', () => [ground(), ...table(0, 0)], [0.3, 1, 0.2]],
  ['a niche', () => [ground(), wall(0.5), wall(0, 0.5, Math.PI / 2)], [0.1, 0.1, 0.1]],
  ['a pole’s side', () => [ground(), pole(0.42, 0)], [0, 0.1, 0]],
  ['a room just high enough', () => [ground(), block([-9, 1.85, -9], [9, 2, 9])], [0, 0.025, 0]],
];
const MODES = [
  [60, 0],
  [20, 0],
  [144, 2],
] as const;

describe.each(PLACES)('standing on %s', (_, solids, foot) => {
  it.each(MODES)(
    'should move by less than 0.1 mm in a minute and draw nothing, %i Hz, %i late',
    (rate, latency) => {
      const walker = new WorldWalker(new World(...solids()), {
        ...{ rate, latency, foot },
        judged: false,
      }).settle();
      const from = walker.foot.clone();
      const drawn = walker.drawn.clone();
      let far = 0;
      let draws = 0;
      const measure = () => {
        far = Math.max(far, walker.foot.distanceTo(from), walker.drawn.distanceTo(drawn));
        if (Math.abs(walker.time - 2) < 1 / rate) ({ draws } = walker.collider);
      };
      walker.run(rate === 60 ? 59 : 9, measure);
      expect(far, walker.story).toBeLessThan(1e-4);
      expect(walker.collider.draws - draws, 'draws at rest').toBe(0);
      expect(walker.character.grounded).toBe(true);
    },
  );

  it('should keep a gap of 10 to 25 mm', () => {
    const walker = new WorldWalker(new World(...solids()), { foot }).settle(2);
    // Where the walls leave less room than two skins, less is all there is.
    const least = _ === 'a corridor' || _ === 'a room just high enough' ? 0.0049 : 0.01;
    expect(walker.gap, walker.story).toBeGreaterThan(least);
    expect(walker.gap, walker.story).toBeLessThan(0.025);
    for (const { gap, normal } of walker.character.contacts) {
      expect(gap).toBeGreaterThanOrEqual(0);
      expect(normal.length()).toBeCloseTo(1, 5);
    }
  });
});

describe('pressing on', () => {
  it.each([
    ['a wall', () => [ground(), wall(1)]],
    ['a pole', () => [ground(), pole(1, 0)]],
    ['a steep slope', () => [ground(), ramp(1.2)]],
    ['a step too high', () => [ground(), kerb(0.6, 1)]],
  ] as [string, () => Solid[]][])('%s should not shake it', (_, solids) => {
    for (const latency of [0, 2]) {
      const walker = new WorldWalker(new World(...solids()), { latency, foot: [-0.8, 0.02, 0] });
      walker.walk(3).run(2);
      const from = walker.foot.clone();
      let far = 0;
      walker.run(1, () => (far = Math.max(far, walker.foot.distanceTo(from))));
      expect(far, walker.story).toBeLessThan(1e-3);
      expect(walker.gap).toBeGreaterThan(0.01);
      expect(walker.gap).toBeLessThan(0.025);
    }
  });
});
