import { describe, expect, it } from 'vitest';
import { listen } from '../../support/world/events.js';
import { block, ground, kerb, ramp, stairs, wall } from '../../support/world/scenes.js';
import { World } from '../../support/world/World.js';
import { WorldWalker, type WalkerOptions } from '../../support/world/WorldWalker.js';

const flat = (options: WalkerOptions = {}) =>
  new WorldWalker(new World(ground()), options).settle(0.5);

describe.each([20, 30, 60, 144])('a jump at %i Hz', (rate) => {
  it.each([0.3, 1.1, 2])('should rise %f m', (jumpHeight) => {
    for (const latency of [0, 2]) {
      const walker = flat({ rate, latency, character: { jumpHeight } });
      const from = walker.foot.y;
      let top = 0;
      expect(walker.character.jump()).toBe(true);
      walker.run(1.5, () => (top = Math.max(top, walker.foot.y - from)));
      // At 20 Hz the top may fall between two looks: half of g·(dt/2)².
      expect(top).toBeGreaterThan(0.98 * jumpHeight - 2.5 / rate ** 2);
      expect(top).toBeLessThan(1.02 * jumpHeight);
      expect(walker.character.grounded).toBe(true);
    }
  });

  it('should never be cancelled by snapping: on slopes and stairs, up and down', () => {
    for (const solids of [[ramp(0.6)], [ground(), ...stairs(12, 0.17, 0.29)]]) {
      for (const speed of [3, -3, 6, -6]) {
        const walker = new WorldWalker(new World(...solids.map((s) => s)), {
          rate,
          foot: [1.7, 1.8, 0],
          character: { jumpHeight: 0.5 },
        });
        walker.settle(0.7).walk(speed).run(0.15);
        const from = walker.foot.y;
        let top = 0;
        expect(walker.character.jump(), `${speed} m/s: ${walker.story}`).toBe(true);
        walker.run(0.26, () => (top = Math.max(top, walker.foot.y - from)));
        expect(top, `${speed} m/s: ${walker.story}`).toBeGreaterThan(0.44);
      }
    }
  });

  it('should be granted a little after an edge, and no later', () => {
    for (const [seconds, granted] of [
      [rate === 20 ? 0 : 0.05, true],
      [0.25, false],
    ] as const) {
      const walker = new WorldWalker(new World(ground(-5), block([-5, -1, -2], [0, 0, 2])), {
        rate,
        foot: [-1, 0.02, 0],
      });
      const heard = listen(walker.character);
      walker.settle(0.3).walk(3);
      for (let i = 0; i < 3 * rate && heard.leave.length === 0; i++) walker.frame();
      expect(heard.leave.length).toBe(1);
      walker.run(seconds);
      walker.character.jump();
      walker.frame(2);
      expect(heard.jump.length, `${seconds} s after`).toBe(granted ? 1 : 0);
    }
  });

  it('should be kept in mind for a little before landing, and no longer', () => {
    for (const [early, granted] of [
      [0.06, true],
      [0.3, false],
    ] as const) {
      const walker = flat({ rate });
      const heard = listen(walker.character);
      walker.character.jump();
      // The whole jump takes 0.663 s.
      walker.run(0.66 - early);
      expect(walker.character.jump()).toBe(false);
      walker.run(0.5);
      expect(heard.jump.length, `${early} s before`).toBe(granted ? 2 : 1);
    }
  });
});

describe('events', () => {
  it.each([20, 60, 144])('should tell of a jump once each, at %i Hz', (rate) => {
    const walker = flat({ rate });
    const heard = listen(walker.character);
    walker.character.jump();
    walker.run(1.5);
    expect(heard.jump.length).toBe(1);
    expect(heard.leave.length).toBe(1);
    expect(heard.land.length).toBe(1);
    expect(heard.land[0]!.speed).toBeGreaterThan(6.2);
    expect(heard.land[0]!.speed).toBeLessThan(7);
    expect(heard.step.length + heard.squeeze.length + heard.respawn.length).toBe(0);
  });

  it('should tell of walking off an edge once each', () => {
    const walker = new WorldWalker(new World(ground(-1.2), block([-5, -2, -2], [0, 0, 2])), {
      foot: [-1, 0.02, 0],
    });
    walker.settle(0.3);
    const heard = listen(walker.character);
    walker.walk(3).run(2);
    expect([heard.leave.length, heard.land.length, heard.jump.length]).toEqual([1, 1, 0]);
    expect(heard.land[0]!.speed).toBeGreaterThan(6);
  });

  it('should tell of a step climbed, and neither of leaving nor of landing there', () => {
    for (const height of [0.15, 0.3, 0.38]) {
      const walker = new WorldWalker(new World(ground(), kerb(height)), { foot: [-1, 0.02, 0] });
      walker.settle(0.3);
      const heard = listen(walker.character);
      walker.walk(3).run(1);
      expect(heard.step.length, `${height} m`).toBe(1);
      expect(heard.step[0]!.height).toBeGreaterThan(height - 0.03);
      expect(heard.step[0]!.height).toBeLessThan(height + 0.03);
      expect(heard.leave.length + heard.land.length).toBe(0);
      // Down again it snaps: nothing to tell.
      walker.walk(-3).run(1.5);
      expect(walker.foot.y).toBeLessThan(0.03);
      expect(heard.leave.length + heard.land.length).toBe(0);
    }
  });

  it('should tell of touching a wall once, and of leaving it once', () => {
    for (const latency of [0, 2]) {
      const side = wall(1);
      const walker = new WorldWalker(new World(ground(), side), { latency }).settle(0.5);
      const heard = listen(walker.character);
      const told = (of: { object?: unknown }[]) =>
        of.filter(({ object }) => object === side.object).length;
      walker.walk(3).run(1).walk(1, 2).run(1);
      expect([told(heard.contact), told(heard.separate)]).toEqual([1, 0]);
      expect(walker.character.contacts.some(({ object }) => object === side.object)).toBe(true);
      walker.walk(-3).run(0.5);
      expect([told(heard.contact), told(heard.separate)]).toEqual([1, 1]);
      expect(walker.character.ground!.object!.name).toBe('ground');
      expect(walker.character.ground!.normal.y).toBeCloseTo(1, 4);
    }
  });

  it('should put it back from below respawnBelow', () => {
    const walker = new WorldWalker(new World(block([-2, -1, -2], [0, 0, 2])), {
      foot: [-1, 0.02, 0],
      character: { respawnBelow: -8 },
    });
    walker.settle(0.5);
    const heard = listen(walker.character);
    walker.walk(3).run(0.8).walk(0);
    for (let i = 0; i < 600 && heard.respawn.length === 0; i++) walker.frame();
    expect(heard.respawn.length).toBe(1);
    walker.run(1);
    expect(walker.foot.y).toBeCloseTo(0.02, 2);
    expect(walker.character.grounded).toBe(true);
    expect(heard.respawn.length).toBe(1);
  });
});
