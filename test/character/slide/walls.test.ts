import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { tries } from '../../support/soak.js';
import { block, corner, ground, wall } from '../../support/world/scenes.js';
import { World } from '../../support/world/World.js';
import { WorldWalker } from '../../support/world/WorldWalker.js';

const radians = (degrees: number) => (degrees * Math.PI) / 180;

describe('a corridor', () => {
  const mouth = (width: number) => [
    block([0, -1, width / 2], [6, 3, 4], 'left jamb'),
    block([0, -1, -4], [6, 3, -width / 2], 'right jamb'),
  ];

  it.each([0.3, 0.5, 0.6, 0.68])('%f m wide should not be entered', (width) => {
    for (const [speed, latency, aside] of [
      [3, 0, 0],
      [6, 2, 0.03],
      [1, 1, -0.1],
    ] as const) {
      const walker = new WorldWalker(new World(ground(), ...mouth(width)), {
        latency,
        foot: [-1.5, 0.02, aside],
      });
      walker
        .settle(0.3)
        .walk(speed)
        .run(3 / speed + 1);
      const { x } = walker.foot;
      // Two edges hold the body's round before its middle is between them.
      expect(x, walker.story).toBeLessThan(0.01);
      expect(x, walker.story).toBeGreaterThan(-0.4);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
      const from = walker.foot.clone();
      let far = 0;
      walker.run(1, () => (far = Math.max(far, walker.foot.distanceTo(from))));
      expect(far, 'shakes').toBeLessThan(0.001);
    }
  });

  it.each([0.76, 0.9, 1.2])('%f m wide should be walked through', (width) => {
    for (const aside of [0, 0.05, -0.12]) {
      const walker = new WorldWalker(new World(ground(), ...mouth(width)), {
        foot: [-1.5, 0.02, aside],
      });
      walker.settle(0.3).walk(3).run(3);
      expect(walker.foot.x, walker.story).toBeGreaterThan(6);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
    }
  });
});

describe('a corner of any angle', () => {
  it('should be run into at 5 m/s without harm, and without a tremor while it presses on', () => {
    fc.assert(
      fc.property(
        fc.double({ min: 10, max: 170, noNaN: true }),
        fc.double({ min: -1, max: 1, noNaN: true }),
        fc.integer({ min: 0, max: 3 }),
        fc.constantFrom(20, 30, 60, 144),
        (degrees, aim, latency, rate) => {
          const angle = radians(degrees);
          const walker = new WorldWalker(new World(ground(), ...corner(angle)), {
            latency,
            rate,
            foot: [0.6 / Math.sin(angle / 2), 0.02, 0],
          });
          walker.settle(0.3);
          // Aside by so much at most that both walls are still pushed at.
          const aside = aim * Math.max(0, radians(75) - angle / 2);
          walker.walk(-5 * Math.cos(aside), 5 * Math.sin(aside)).run(3);
          const from = walker.foot.clone();
          let far = 0;
          walker.run(1, () => (far = Math.max(far, walker.foot.distanceTo(from))));
          expect(far, `trembles: ${walker.story}`).toBeLessThan(0.001);
          expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
          expect(walker.worstDrawn).toBeLessThan(0.01);
          expect(walker.crossings, walker.crossedAt).toBe(0);
          expect(walker.foot.y).toBeCloseTo(0.02, 2);
        },
      ),
      { seed: 7, numRuns: tries(40, 2000) },
    );
  });

  it('should be run around on its outside', () => {
    const walker = new WorldWalker(new World(ground(), block([0, -1, -3], [3, 3, 0])), {
      foot: [-0.5, 0.02, -2],
    });
    walker.settle(0.3).walk(1, 3).run(1).walk(3, -1).run(1);
    expect(walker.foot.x, walker.story).toBeGreaterThan(1.5);
    expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
  });
});

describe('sliding along a wall', () => {
  it.each([10, 30, 45, 60, 80])('should keep the speed along it at %i°', (degrees) => {
    for (const speed of [1, 3, 6]) {
      for (const [rate, latency] of [
        [20, 0],
        [60, 0],
        [60, 3],
        [144, 1],
      ] as const) {
        // In pieces, whose seams are nothing to a picture.
        const pieces = Array.from({ length: 20 }, (_, i) =>
          block([1, -1, i - 2], [1.3, 3, i - 1], `piece ${i}`),
        );
        const walker = new WorldWalker(new World(ground(), ...pieces), {
          rate,
          latency,
          foot: [0.6, 0.02, -1.5],
        });
        const along = speed * Math.cos(radians(degrees));
        walker.settle(0.3).walk(speed * Math.sin(radians(degrees)), along);
        walker.run(0.3 / (speed * Math.sin(radians(degrees))) + 0.2);
        let { z } = walker.drawn;
        let least = Infinity;
        const from = z;
        // Three steps at a time, so that rates other than the steps' own are even.
        const frames = Math.max(1, Math.round(rate / 20));
        for (let i = 0; i < 16; i++) {
          walker.frame(frames);
          least = Math.min(least, ((walker.drawn.z - z) * rate) / frames);
          ({ z } = walker.drawn);
        }
        const told = `${speed} m/s: ${walker.story}`;
        const mean = ((z - from) * rate) / frames / 16;
        expect(mean, told).toBeGreaterThan(0.98 * along);
        expect(mean, told).toBeLessThan(1.02 * along);
        if (rate !== 144) expect(least, `snags, ${told}`).toBeGreaterThan(0.9 * along);
        expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
      }
    }
  });

  it('should hold along a wall that leans over, and one that leans away', () => {
    for (const lean of [-0.3, -0.1, 0.1, 0.3]) {
      const leaning = wall(1.2).turn({ roll: lean });
      const walker = new WorldWalker(new World(ground(), leaning), { foot: [-0.3, 0.02, -4] });
      walker.settle(0.3).walk(3, 3).run(1);
      const { z } = walker.foot;
      walker.run(1);
      expect(walker.foot.z - z, `${lean}: ${walker.story}`).toBeGreaterThan(3 * 0.97);
      expect(walker.foot.y).toBeCloseTo(0.02, 2);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
    }
  });
});
