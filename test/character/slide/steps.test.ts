import { describe, expect, it } from 'vitest';
import { SOAK } from '../../support/soak.js';
import { block, ground, kerb, stairs } from '../../support/world/scenes.js';
import { World } from '../../support/world/World.js';
import { WorldWalker, type WalkerOptions } from '../../support/world/WorldWalker.js';
import { Box } from '../../support/world/solids.js';

const ANGLES = SOAK ? Array.from({ length: 31 }, (_, i) => 2.5 * i) : [0, 15, 30, 45, 60, 75];

/** Walks along +X at a kerb turned by `degrees`, long enough to be up or to have been refused. */
function approach(height: number, degrees: number, speed: number, options: WalkerOptions = {}) {
  const yaw = (degrees * Math.PI) / 180;
  const across = Math.cos(yaw);
  const walker = new WorldWalker(new World(ground(), kerb(height, 0, yaw)), {
    foot: [-0.8 / across, 0.02, 0],
    ...options,
  });
  walker.settle(0.5);
  let top = -Infinity;
  walker.walk(speed).run(1.3 / (speed * across) + 0.5, () => (top = Math.max(top, walker.foot.y)));
  return { walker, top };
}

describe.each([1, 3, 6])('a step walked at with %i m/s', (speed) => {
  it.each(ANGLES)('should be climbed up to the step height, at %f°', (degrees) => {
    for (const height of [0.1, 0.25, 0.39]) {
      const { walker, top } = approach(height, degrees, speed);
      const told = `${height} m: ${walker.story}`;
      expect(walker.foot.y, told).toBeGreaterThan(height);
      expect(top, told).toBeLessThan(height + 0.05);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
    }
  });

  it.each(ANGLES)('should be refused above the step height, at %f°', (degrees) => {
    for (const height of [0.41, 0.5, 0.8]) {
      const { walker, top } = approach(height, degrees, speed);
      expect(top, `${height} m: ${walker.story}`).toBeLessThan(0.05);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
    }
  });
});

describe.each([
  [20, 0],
  [30, 3],
  [144, 1],
])('a step at %i Hz, fields %i late', (rate, latency) => {
  it.each([0.2, 0.3, 0.4])('should be judged by stepHeight %f m alike', (stepHeight) => {
    for (const speed of [1, 3, 6]) {
      for (const degrees of [0, 50]) {
        const options = { rate, latency, character: { stepHeight } };
        const climbed = approach(stepHeight - 0.01, degrees, speed, options);
        const told = `${speed} m/s at ${degrees}°: `;
        expect(climbed.walker.foot.y, told + climbed.walker.story).toBeGreaterThan(
          stepHeight - 0.01,
        );
        const refused = approach(stepHeight + 0.01, degrees, speed, options);
        expect(refused.top, told + refused.walker.story).toBeLessThan(0.05);
      }
    }
  });
});

describe.each([
  [0.15, 0.3],
  [0.18, 0.27],
  [0.3, 0.3],
])('stairs of %f by %f m', (rise, tread) => {
  const count = 10;
  it.each([1, 3, 6])('should be walked up and down evenly at %i m/s', (speed) => {
    for (const latency of [0, 2]) {
      const world = new World(ground(), ...stairs(count, rise, tread));
      const walker = new WorldWalker(world, { latency, foot: [-0.6, 0.02, 0] }).settle(0.5);
      const slope = Math.cos(Math.atan2(rise, tread));
      const least = speed * slope * 0.95;
      let seconds = 0;
      let y = walker.drawn.y;
      let back = 0;
      walker.walk(speed);
      const timed = (from: number, to: number, sign: number) => () => {
        const { x } = walker.foot;
        if ((x - from) * (x - to) < 0) seconds += 1 / 60;
        back = Math.max(back, sign * (y - walker.drawn.y));
        ({ y } = walker.drawn);
        expect(walker.character.grounded, walker.story).toBe(true);
      };
      walker.run((count * tread + 1.5) / least + 0.3, timed(0, count * tread, 1));
      expect(walker.foot.y, walker.story).toBeGreaterThan(count * rise);
      const up = (count * tread) / seconds;
      expect(up, `up, ${latency} late`).toBeGreaterThan(least);
      expect(up, `up, ${latency} late`).toBeLessThan(speed * 1.05);
      expect(back, 'sinks on the way up').toBeLessThan(0.004);
      // Down again, from where it is now.
      const { x } = walker.foot;
      back = seconds = 0;
      walker.walk(-speed);
      walker.run((x + 0.6) / least + 0.2, timed(0, count * tread, -1));
      expect(walker.foot.y, walker.story).toBeLessThan(0.03);
      const down = (count * tread) / seconds;
      expect(down, `down, ${latency} late`).toBeGreaterThan(least);
      expect(down, `down, ${latency} late`).toBeLessThan(speed * 1.05);
      expect(back, 'rises on the way down').toBeLessThan(0.004);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
    }
  });
});

describe('stairs along a wall', () => {
  it.each([1, 3, 10, 25])('should be walked up by who leans against it by %f°', (degrees) => {
    const world = new World(
      ground(),
      ...stairs(10, 0.2, 0.35),
      block([-2, -1, 1], [20, 6, 2], 'wall'),
    );
    for (const speed of [1, 3, 5]) {
      const walker = new WorldWalker(world, { foot: [-0.8, 0.02, 0.6] }).settle(0.3);
      const yaw = (degrees * Math.PI) / 180;
      walker.walk(speed * Math.cos(yaw), speed * Math.sin(yaw)).run(6.5 / speed + 0.5);
      expect(walker.foot.y, walker.story).toBeGreaterThan(2);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
    }
  });
});

describe('stairs beside a balustrade that rises with them', () => {
  // Lifted for a step the body overlooks its top, comes nearer over that, and must come down beside it all the same.
  const walks = (SOAK ? [0.5, 1, 2, 3, 6] : [0.5, 3]).flatMap((degrees) => [
    { degrees, supersample: 1, above: 0.45, coping: false },
    { degrees, supersample: 4, above: 0.6, coping: false },
    { degrees, supersample: 1, above: 0.6, coping: true },
    { degrees, supersample: 4, above: 0.45, coping: true },
  ]);
  it.each(walks)(
    'should be walked up by who leans against that: by $degrees°, $above m, coping $coping, supersample $supersample',
    ({ degrees, supersample, above, coping }) => {
      const [count, rise, tread] = [12, 0.2, 0.35];
      const bars = [slanted(rise, tread, above, 3, [1.5, 1.8])];
      if (coping) bars.push(slanted(rise, tread, above + 0.08, 0.1, [1.44, 1.86]));
      const world = new World(ground(), ...stairs(count, rise, tread, 3), ...bars);
      const yaw = (degrees * Math.PI) / 180;
      for (const [speed, x, z] of [
        [3, -0.8, 1.1],
        [3, -1.13, 1.1],
        [6, -0.8, 1.1],
        [6, -0.8, 0.7],
      ] as const) {
        const walker = new WorldWalker(world, { foot: [x, 0.02, z], supersample }).settle(0.1);
        walker.walk(speed * Math.cos(yaw), speed * Math.sin(yaw)).run(5.5 / speed + 0.5);
        expect(walker.foot.y, walker.story).toBeGreaterThan(2.3);
        expect(walker.worst, walker.worstAt).toBeLessThan(-0.005);
      }
    },
  );

  /** A bar along the stairs from z to z, its top so far above the line through their edges. */
  function slanted(
    rise: number,
    tread: number,
    above: number,
    high: number,
    [from, to]: readonly [number, number],
  ): Box {
    const slope = Math.atan2(rise, tread);
    const half = (high * Math.cos(slope)) / 2;
    return new Box(15, half, (to - from) / 2, 'bar')
      .at(half * Math.sin(slope), rise + above - half * Math.cos(slope), (from + to) / 2)
      .turn({ roll: slope });
  }
});

describe('stairs drawn four times finer, walked straight up', () => {
  // Which ray of a texel is kept depends on where one stands: wherever that is, no edge may end in the air.
  it.each([
    [0.25, 0.4],
    [0.17, 0.28],
    [0.2, 0.35],
  ])('should never be stopped at: %f by %f m', (rise, tread) => {
    const world = new World(ground(), ...stairs(5, rise, tread));
    const starts = SOAK ? 60 : 6;
    for (let i = 0; i < starts; i++) {
      const foot = [-0.7 - 0.8 * ((0.618 * i) % 1), 0.02, 0] as const;
      const walker = new WorldWalker(world, { supersample: 4, foot, judged: false }).settle(0.1);
      walker.walk(3).run(1.6 + (4 * tread) / 3);
      expect(walker.foot.x, walker.story).toBeGreaterThan(5 * tread);
    }
  });
});
