import { describe, expect, it } from 'vitest';
import { block, ground, rampFrom0 } from '../../support/world/scenes.js';
import { World } from '../../support/world/World.js';
import { WorldWalker } from '../../support/world/WorldWalker.js';

const lintel = (low: number, from = 0, to = 5) =>
  block([from, low, -5], [to, low + 1, 5], 'lintel');

describe('a ceiling', () => {
  it.each([20, 60, 144])('should stop a jump’s rise and let it fall at once, at %i Hz', (rate) => {
    const walker = new WorldWalker(new World(ground(), lintel(2.2, -5)), { rate }).settle(0.5);
    expect(walker.character.jump()).toBe(true);
    let top = 0;
    let air = 0;
    walker.run(1, () => {
      top = Math.max(top, walker.foot.y);
      if (walker.foot.y > 0.03) air += 1 / rate;
    });
    expect(top).toBeGreaterThan(0.3);
    expect(top).toBeLessThan(0.4);
    // 0.06 s up at 6.6 m/s and 0.19 s down; a jump that hangs would take 0.66 s.
    expect(air).toBeLessThan(0.27 + 3 / rate);
    expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
    expect(walker.character.grounded).toBe(true);
  });

  it.each([0.5, 1, 1.4, 1.7, 1.79])('%f m high should not be entered', (low) => {
    for (const speed of [1, 3, 6]) {
      const walker = new WorldWalker(new World(ground(), lintel(low)), {
        foot: [-1.2, 0.02, 0],
        latency: speed === 3 ? 2 : 0,
      });
      walker
        .settle(0.3)
        .walk(speed)
        .run(2 / speed + 1);
      expect(walker.foot.x, walker.story).toBeLessThan(0.1);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
      expect(walker.foot.y).toBeLessThan(0.05);
    }
  });

  it.each([1.85, 2])('%f m high should be walked under', (low) => {
    const walker = new WorldWalker(new World(ground(), lintel(low)), { foot: [-1.2, 0.02, 0] });
    walker.settle(0.3).walk(3).run(2);
    expect(walker.foot.x, walker.story).toBeGreaterThan(4);
  });

  it('should end a climb where it comes too low, without a tremor', () => {
    const world = new World(ground(), rampFrom0(0.5), lintel(2.5, -2, 20));
    const walker = new WorldWalker(world, { foot: [-1.2, 0.02, 0] }).walk(3).run(3);
    const from = walker.foot.clone();
    let far = 0;
    walker.run(1, () => (far = Math.max(far, walker.foot.distanceTo(from))));
    expect(far, walker.story).toBeLessThan(0.001);
    expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
  });
});

describe('crouching', () => {
  it.each([0, 2])(
    'should go under what stops it upright, and stand up where there is room, %i late',
    (latency) => {
      const walker = new WorldWalker(new World(ground(), lintel(1.3, 0, 3)), {
        latency,
        foot: [-1.2, 0.02, 0],
      });
      const { character } = walker.settle(0.3);
      const { body } = character;
      expect(character.crouched).toBe(false);
      character.crouch(true);
      walker.run(0.5);
      expect(character.crouched).toBe(true);
      expect(body.height).toBeCloseTo(1.1, 6);
      expect(walker.foot.y).toBeCloseTo(0.02, 2);
      walker.walk(3).run(0.9);
      expect(walker.foot.x, walker.story).toBeGreaterThan(0.5);
      character.crouch(false);
      walker.walk(0).run(1);
      expect(walker.foot.x).toBeLessThan(2.5);
      expect(character.crouched).toBe(true);
      expect(body.height).toBeCloseTo(1.1, 6);
      walker.walk(3).run(1.5);
      expect(walker.foot.x).toBeGreaterThan(3.4);
      expect(character.crouched).toBe(false);
      expect(body.height).toBeCloseTo(1.8, 6);
      expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
      expect(walker.worstDrawn).toBeLessThan(0.01);
    },
  );

  it('should not be entered upright by a jump from below or aside', () => {
    const walker = new WorldWalker(new World(ground(), lintel(1.3)), { foot: [-0.8, 0.02, 0] });
    walker.settle(0.3);
    for (let i = 0; i < 4; i++) {
      walker.walk(3).character.jump();
      walker.run(1);
    }
    expect(walker.foot.x, walker.story).toBeLessThan(0.1);
    expect(walker.worst, walker.worstAt).toBeLessThan(0.01);
  });
});
