import { describe, expect, it } from 'vitest';
import { ground, ramp, rampFrom0 } from '../../support/world/scenes.js';
import { World } from '../../support/world/World.js';
import { WorldWalker, type WalkerOptions } from '../../support/world/WorldWalker.js';

const radians = (degrees: number) => (degrees * Math.PI) / 180;

/** A walker before the foot of a ramp that begins at x = 0. */
const before = (degrees: number, options: WalkerOptions = {}) =>
  new WorldWalker(new World(ground(), rampFrom0(radians(degrees))), {
    foot: [-1.2, 0.02, 0],
    ...options,
  }).settle(0.5);

/** A walker on the middle of a long ramp through the origin, a skin above it. */
function on(degrees: number, options: WalkerOptions = {}) {
  const gap = (0.35 + 0.02) / Math.cos(radians(degrees)) - 0.35;
  return new WorldWalker(new World(ramp(radians(degrees))), { foot: [0, gap, 0], ...options });
}

describe.each([5, 10, 20, 30, 40, 45, 47, 49])('a slope of %i°', (degrees) => {
  it.each([1, 3, 6])('should be climbed at %i m/s and stood on', (speed) => {
    for (const latency of [0, 2]) {
      const walker = before(degrees, { latency })
        .walk(speed)
        .run(1.2 / speed + 1);
      const rise = Math.tan(radians(degrees)) * speed * Math.cos(radians(degrees));
      expect(walker.foot.y, walker.story).toBeGreaterThan(0.8 * rise);
      walker.walk(0).run(0.5);
      const from = walker.foot.clone();
      walker.run(2);
      expect(walker.foot.distanceTo(from), walker.story).toBeLessThan(1e-4);
      expect(walker.character.grounded).toBe(true);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
    }
  });

  it('should hold who is put there', () => {
    const walker = on(degrees).settle(0.5);
    const from = walker.foot.clone();
    walker.run(3);
    expect(walker.foot.distanceTo(from), walker.story).toBeLessThan(1e-4);
    expect(Math.abs(walker.foot.x)).toBeLessThan(0.03);
    expect(walker.character.grounded).toBe(true);
  });

  it.each([3, 6])('should be walked at a fair speed, up, down and across, at %i m/s', (speed) => {
    const least = Math.cos(radians(degrees)) * speed * 0.95;
    for (const [x, z] of [
      [speed, 0],
      [-speed, 0],
      [0, speed],
    ] as const) {
      const walker = on(degrees).settle(0.3).walk(x, z).run(0.3);
      const from = walker.foot.clone();
      walker.run(0.5, () => expect(walker.character.grounded, walker.story).toBe(true));
      const { x: dx, z: dz } = walker.foot.clone().sub(from).divideScalar(0.5);
      const told = `along (${x}, ${z}): ${walker.story}`;
      expect(Math.sqrt(dx * dx + dz * dz), told).toBeGreaterThan(x === 0 ? 0.95 * speed : least);
      expect(Math.sqrt(dx * dx + dz * dz), told).toBeLessThan(1.02 * speed);
    }
  });

  it.each([3, 6])('should neither be hopped onto nor off at its foot, at %i m/s', (speed) => {
    for (const rate of [20, 60, 144]) {
      const walker = before(degrees, { rate }).walk(speed);
      let { y } = walker.foot;
      const climb = Math.sin(radians(degrees)) * speed;
      // A millimetre and a half in a frame of the steps' own rate is no hop.
      const bump = 0.0015 * 60;
      let fastest = 0;
      let slowest = 0;
      const measure = () => {
        expect(walker.character.grounded, walker.story).toBe(true);
        fastest = Math.max(fastest, (walker.drawn.y - y) * rate);
        slowest = Math.min(slowest, (walker.drawn.y - y) * rate);
        ({ y } = walker.drawn);
      };
      ({ y } = walker.drawn);
      walker.run(1.2 / speed + 0.4, measure);
      const most = Math.tan(radians(degrees)) * speed * 1.02 + bump;
      expect(fastest, `up ${climb}: ${walker.story}`).toBeLessThan(most);
      expect(slowest, 'up').toBeGreaterThan(-bump);
      fastest = slowest = 0;
      walker.walk(-speed).run(1.2 / speed + 0.4, measure);
      expect(slowest, `down: ${walker.story}`).toBeGreaterThan(-most);
      expect(fastest, 'down').toBeLessThan(bump);
    }
  });
});

describe.each([51, 53, 55, 60, 65, 70, 75, 80, 85])('a slope of %i°', (degrees) => {
  it.each([1, 3, 6])('should not be climbed at %i m/s', (speed) => {
    for (const latency of [0, 2]) {
      const walker = before(degrees, { latency }).walk(speed);
      let top = 0;
      walker.run(1.2 / speed + 1.5, () => (top = Math.max(top, walker.foot.y)));
      expect(top, walker.story).toBeLessThan(0.1);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
    }
  });

  it('should be slid down, walking up it or not', () => {
    for (const speed of [0, 3]) {
      const walker = on(degrees).settle(0.3);
      const from = walker.foot.y;
      walker.walk(speed).run(1);
      expect(walker.foot.y - from, `${speed} m/s: ${walker.story}`).toBeLessThan(-0.5);
      expect(walker.character.grounded).toBe(false);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
    }
  });
});

describe('another slope limit', () => {
  it.each([20, 35, 60])('should be as sharp at %i°', (limit) => {
    const character = { slopeLimit: radians(limit) };
    for (const rate of [20, 144]) {
      const climbed = before(limit - 1, { character, rate })
        .walk(3)
        .run(1.4);
      expect(climbed.foot.y, climbed.story).toBeGreaterThan(0.5);
      const refused = before(limit + 1, { character, rate })
        .walk(3)
        .run(1.4);
      expect(refused.foot.y, refused.story).toBeLessThan(0.1);
    }
  });
});
