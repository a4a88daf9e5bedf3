import { describe, expect, it } from 'vitest';
import { seeded } from '../../e2e/support/axisScenes.js';
import type { AnalyticOptions } from '../support/AnalyticCollider.js';
import { box, corridor, floor, plane, ramp, stairs, union } from '../support/analytic.js';
import { Walker } from '../support/walker.js';

const R = 0.35;
const RATES = [20, 30, 60, 144];
const MODES: [string, AnalyticOptions][] = [
  ['the paper’s maxima, sync', { output: 'axis' }],
  ['a surface field, two frames late', { output: 'surface', resolution: 24 }],
];
const EACH = MODES.flatMap(([mode, options]) =>
  RATES.filter((rate) => options.output === 'axis' || rate <= 60).map(
    (rate) => [mode, rate, options] as const,
  ),
);

describe.each(EACH)('walking by %s at %i Hz', (_, rate, options) => {
  it('should stand where it was dropped, without shaking, creeping or losing the ground', () => {
    const walker = new Walker(floor(), rate, [0.013, 0.5, 0.021], options).run(1);
    const { x, y, z } = walker.at;
    // R/N² = 1.4 mm that the texels nearest to straight down look past, and two steps of red held as rounding.
    expect(y).toBeLessThan(0.001);
    expect(y).toBeGreaterThan(-0.003);
    walker.run(options.output === 'axis' && rate === 60 ? 60 : 10, () => {
      expect(walker.character.grounded).toBe(true);
      expect(walker.at.y).toBe(y);
    });
    expect(Math.hypot(walker.at.x - x, walker.at.z - z)).toBeLessThan(1e-4);
  });

  it('should jump as high as asked', () => {
    const walker = new Walker(floor(), rate, [0, 0, 0], options).run(0.5);
    const from = walker.at.y;
    let top = 0;
    expect(walker.character.jump()).toBe(true);
    expect(walker.character.jump()).toBe(false);
    walker.run(0.2, () => expect(walker.character.grounded).toBe(false));
    walker.run(1.2, () => (top = Math.max(top, walker.at.y - from)));
    expect(top).toBeGreaterThan(0.95 * 1.1);
    expect(top).toBeLessThan(1.05 * 1.1);
    expect(walker.character.grounded).toBe(true);
  });

  it('should hit the ceiling and fall again at once', () => {
    const ceiling = 2 * R + 0.4;
    const walker = new Walker(union(floor(), plane(0, 1, 0, ceiling)), rate, [0, 0, 0], options);
    walker.run(0.5);
    walker.character.jump();
    let top = 0;
    let frames = 0;
    walker.run(1, () => {
      top = Math.max(top, walker.at.y);
      if (walker.at.y > 0.01) frames++;
    });
    expect(top).toBeLessThan(0.4 + 0.01);
    // 0.07 s up at 6.6 m/s, 0.2 s down; a jump not stopped would take 0.66 s.
    expect(frames / rate).toBeLessThan(0.27 + 3 / rate);
  });

  it.each([3, 6])('should stop at a wall walked into at %i m/s, and stay out of it', (speed) => {
    const walker = new Walker(union(floor(), plane(1, 0, 0, 2)), rate, [0, 0, 0], options);
    let worst = -Infinity;
    walker.walk(speed).run(2, () => (worst = Math.max(worst, walker.at.x + R - 2)));
    expect(worst).toBeLessThan(0.045);
    expect(walker.at.x + R - 2).toBeGreaterThan(-0.001);
    expect(walker.at.x + R - 2).toBeLessThan(0.004);
    const { x } = walker.at;
    walker.run(1, () => expect(Math.abs(walker.at.x - x)).toBeLessThan(0.001));
    expect(walker.character.velocity.x).toBeCloseTo(0, 1);
    walker.walk(-speed).run(0.5);
    expect(walker.at.x).toBeLessThan(x - 0.4 * speed);
  });

  it('should slide along a wall at full speed', () => {
    const walker = new Walker(union(floor(), plane(1, 0, 0, 1)), rate, [0.5, 0, 0], options);
    walker.walk(3, 3).run(2);
    expect(walker.at.z).toBeGreaterThan(5.5);
    expect(walker.at.x + R).toBeLessThan(1.004);
  });

  it.each([1, 3])(
    'should climb a kerb of 0.25 R and be stopped by one of 0.55 R at %i m/s',
    (speed) => {
      for (const [height, climbs] of [
        [0.25 * R, true],
        [0.55 * R, false],
      ] as const) {
        const scene = union(floor(), box(1, -1, -50, 50, height, 50));
        const walker = new Walker(scene, rate, [0, 0, 0], options).walk(speed).run(2 / speed + 1);
        expect(walker.at.x > 1.3).toBe(climbs);
        expect(walker.at.y > height - 0.01).toBe(climbs);
      }
    },
  );

  it('should walk up stairs lower than 0.29 R', () => {
    const walker = new Walker(union(floor(), stairs(8, 0.09, 0.3)), rate, [-1, 0, 0], options);
    walker.walk(2).run(3);
    expect(walker.at.y).toBeCloseTo(0.72, 1);
    expect(walker.at.x).toBeGreaterThan(3.5);
  });

  it('should stand on a slope of 30°, walk up it, and keep touch walking down', () => {
    const walker = new Walker(ramp(Math.PI / 6), rate, [0, 0.1, 0], options).run(1);
    const { x } = walker.at;
    walker.run(3);
    expect(Math.abs(walker.at.x - x)).toBeLessThan(1e-4);
    walker.walk(3).run(2);
    expect(walker.at.x - x).toBeGreaterThan(0.75 * 6);
    walker.walk(-3).run(0.3);
    walker.run(1, () => expect(walker.character.grounded).toBe(true));
  });

  it('should find the middle of a corridor narrower than itself, and walk along it', () => {
    const walker = new Walker(union(floor(), corridor(0.6)), rate, [0.03, 0, 0], options).run(2);
    expect(Math.abs(walker.at.x)).toBeLessThan(0.001);
    walker.walk(1, 2).run(2);
    expect(Math.abs(walker.at.x)).toBeLessThan(0.001);
    expect(walker.at.z).toBeGreaterThan(3.5);
  });

  it('should fall off a ledge, and fall no slower for touching a wall', () => {
    const scene = union(box(-5, -1, -5, 0, 0, 5), plane(1, 0, 0, 1), floor(-3));
    const walker = new Walker(scene, rate, [-0.5, 0, 0], options).walk(3).run(0.7);
    expect(walker.character.grounded).toBe(false);
    // 3 m take 0.55 s from the edge.
    walker.run(0.9);
    expect(walker.character.grounded).toBe(true);
    expect(walker.at.y).toBeCloseTo(-3, 1);
  });
});

describe('never through', () => {
  it.each(EACH)('should land on a floor after any fall, by %s at %i Hz', (_, rate, options) => {
    for (const height of [1, 5, 20]) {
      const walker = new Walker(floor(), rate, [0, height, 0], options);
      let lowest = Infinity;
      walker.run(5, () => (lowest = Math.min(lowest, walker.at.y)));
      expect(lowest).toBeGreaterThan(-R / 4);
      expect(walker.at.y).toBeCloseTo(0, 2);
    }
  });

  it.each([1, 2, 3, 4])('should not leave a closed room at any speed or rate (seed %i)', (seed) => {
    const random = seeded(seed);
    // 5 m wide, 2.5 m high, walls with no thickness, a block inside.
    const room = union(box(-2.5, 0, -2.5, 2.5, 2.5, 2.5), box(0.5, -1, 0.5, 1.5, 0.6, 1.5));
    for (let trial = 0; trial < 6; trial++) {
      const mode = MODES[trial % 2]![1];
      const walker = new Walker(room, 5 + 140 * random() ** 2, [-1, 0.01, -1], {
        ...mode,
        resolution: 12,
      });
      walker.run(0.5);
      for (let leg = 0; leg < 12; leg++) {
        const angle = 2 * Math.PI * random();
        const speed = 40 * random() ** 2;
        walker.walk(speed * Math.cos(angle), speed * Math.sin(angle));
        if (random() < 0.5) walker.character.jump();
        walker.run(0.4, () => {
          const { x, y, z } = walker.at;
          // rMin is 0.175.
          const room = Math.min(2.5 - Math.abs(x), 2.5 - Math.abs(z), y + R, 2.5 - y - R);
          expect(room).toBeGreaterThan(0.2);
        });
      }
    }
  });

  it('should wait, not fall, in a frame of any length', () => {
    const walker = new Walker(floor(), 60, [0, 0, 0]).run(1);
    for (const delta of [10, 1e6, Number.MAX_VALUE, 0, 1e-9]) {
      walker.character.update({}, {}, delta);
      expect(Math.abs(walker.at.y)).toBeLessThan(0.01);
    }
  });
});
