import { describe, expect, it } from 'vitest';
import { BoomSpring } from '../../src/controls/BoomSpring.js';
import { bytesEach } from '../support/bytesEach.js';

/** Lengths over time: 0.5 m free until `release`, then all of 4 m. */
function pullOut(rate: number, seconds = 3, release = 0.2): number[] {
  const spring = new BoomSpring();
  return Array.from({ length: Math.round(seconds * rate) }, (_, i) =>
    spring.update(4, i <= release * rate ? 0.5 : 4, 5, 1 / rate),
  );
}

describe('BoomSpring', () => {
  it('should take what is wanted while nothing is in the way', () => {
    const spring = new BoomSpring();
    for (const wanted of [4, 1, 7, 0.3])
      expect(spring.update(wanted, wanted, 5, 1 / 60)).toBe(wanted);
  });

  it('should pull in at once', () => {
    const spring = new BoomSpring();
    spring.update(4, 4, 5, 1 / 60);
    expect(spring.update(4, 0.8, 5, 1 / 60)).toBe(0.8);
    // Also while it is on its way out.
    for (let i = 0; i < 30; i++) spring.update(4, 4, 5, 1 / 60);
    expect(spring.update(4, 0.6, 5, 1 / 60)).toBe(0.6);
  });

  it('should let out slowly, without a jerk, and be out after a second', () => {
    const lengths = pullOut(60);
    const out = lengths.slice(12);
    expect(out[0]).toBeLessThan(0.52);
    for (let i = 1; i < out.length; i++) {
      expect(out[i]).toBeGreaterThanOrEqual(out[i - 1]!);
      // 3.5 m at 5/s go 6.4 m/s at most.
      expect(out[i]! - out[i - 1]!).toBeLessThan(6.5 / 60);
    }
    expect(out[15]).toBeLessThan(2.5);
    expect(out[60]).toBeGreaterThan(3.8);
    expect(out.at(-1)).toBe(4);
  });

  it('should never be longer than what is free, whatever the limit does', () => {
    const spring = new BoomSpring();
    for (let i = 0; i < 5000; i++) {
      // Approaches, recedes and flickers.
      const free = 2 + 1.9 * Math.sin(0.07 * i) + (i % 7 === 0 ? -0.09 : 0);
      expect(spring.update(3, Math.min(3, free), 5, 1 / 60)).toBeLessThanOrEqual(free);
    }
  });

  it('should hardly shake where the limit flickers', () => {
    const spring = new BoomSpring();
    const lengths = Array.from({ length: 120 }, (_, i) =>
      spring.update(4, i % 6 === 0 ? 2 : 4, 5, 1 / 60),
    );
    expect(Math.max(...lengths.slice(1))).toBeLessThan(2.3);
  });

  it('should be as long at any frame rate', () => {
    const [medium, fast] = [60, 240].map((rate) => pullOut(rate, 1, 0));
    const at = (lengths: number[], rate: number, time: number) => lengths[Math.round(time * rate)]!;
    for (const time of [0.25, 0.5, 0.75]) {
      expect(at(medium!, 60, time)).toBeCloseTo(at(fast!, 240, time), 9);
    }
  });

  it('should settle at once without smoothing', () => {
    const spring = new BoomSpring();
    spring.update(4, 0.5, Infinity, 1 / 60);
    expect(spring.update(4, 4, Infinity, 1 / 60)).toBe(4);
  });

  it('should make no object', () => {
    const spring = new BoomSpring();
    let frame = 0;
    const each = bytesEach(20_000, () => spring.update(4, ++frame % 50 === 0 ? 1 : 4, 5, 1 / 60));
    expect(each).toBeLessThan(33);
  });
});
