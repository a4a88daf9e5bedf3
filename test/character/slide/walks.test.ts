import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { seeded } from '../../../e2e/support/axisScenes.js';
import { tries } from '../../support/soak.js';
import { HALF, randomWorld } from '../../support/world/randomWorld.js';
import { WorldWalker } from '../../support/world/WorldWalker.js';

const CASES = [20, 30, 60, 144].flatMap((rate) =>
  [0, 1, 2, 3].map((latency) => [rate, latency] as const),
);

/** Turns, jumps, crouches and pauses at random in a random yard; as in the rivals' walks, speed 5. */
function ramble(seed: number, rate: number, latency: number, seconds: number): WorldWalker {
  const random = seeded(seed);
  const walker = new WorldWalker(randomWorld(random), { rate, latency });
  walker.settle(0.3);
  let yaw = 2 * Math.PI * random();
  for (let time = 0; time < seconds; time += 0.2) {
    yaw += (random() - 0.5) * 2;
    if (random() < 0.05) yaw += Math.PI;
    const speed = random() < 0.05 ? 0 : 5;
    walker.walk(speed * Math.cos(yaw), speed * Math.sin(yaw));
    if (random() < 0.15) walker.character.jump();
    if (random() < 0.05) walker.character.crouch(random() < 0.3);
    walker.run(0.2);
    const { x, y, z } = walker.foot;
    expect(Number.isFinite(x + y + z), `seed ${seed}: not a number, ${walker.story}`).toBe(true);
  }
  return walker;
}

describe('random walks in random yards', () => {
  it.each(CASES)('should stay out of everything at %i Hz, fields %i late', (rate, latency) => {
    for (let i = 0; i < tries(1, 60); i++) {
      const seed = 100 * i + rate + latency;
      const walker = ramble(seed, rate, latency, tries(10, 60));
      const told = `seed ${seed}`;
      expect(walker.worst, `${told}: ${walker.worstAt}`).toBeLessThan(0.01);
      expect(walker.percentile(0.99), `${told}: p99`).toBeLessThan(0.001);
      expect(walker.crossings, `${told}: ${walker.crossedAt}`).toBe(0);
      const { x, y, z } = walker.foot;
      expect(y, told).toBeGreaterThan(-0.01);
      expect(Math.max(Math.abs(x), Math.abs(z)), told).toBeLessThan(HALF);
      const { steps, held, slowed } = walker.character.stats;
      expect(
        (held + slowed) / steps,
        `${told}: held ${held}, slowed ${slowed} of ${steps}`,
      ).toBeLessThan(latency === 0 ? 0.01 : 0.05);
    }
  });

  it('should be the same walk twice, and not stand about', () => {
    const ends = [1, 2].map(() => ramble(77, 60, 1, 6).foot.clone());
    expect(ends[0]!.equals(ends[1]!)).toBe(true);
    const random = seeded(77);
    randomWorld(random);
    expect(ends[0]!.distanceTo(new Vector3(0, 0.02, 0))).toBeGreaterThan(0.5);
  });
});
