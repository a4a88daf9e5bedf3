import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { along, type Seen } from '../../src/field/along.js';
import { isKnownFree } from '../../src/field/knownFree.js';
import { dice, drawn } from '../support/fields.js';
import { Ball, ground, room } from '../support/world/scenes.js';
import { World } from '../support/world/World.js';

const seen = (): Seen => ({ distance: 0, texel: -1 });
const direction = (between: (low: number, high: number) => number) =>
  new Vector3(between(-1, 1), between(-1, 1), between(-1, 1)).normalize();

describe('along', () => {
  it('should meet a plane exactly, between the middles of texels too (seed 71)', () => {
    const between = dice(71);
    const field = drawn(new World(ground()), new Vector3(0.2, 0.7, 0.1), {
      resolution: 16,
      far: 4,
    });
    for (let i = 0; i < 2000; i++) {
      const { x, y, z } = direction(between);
      // Beyond, its texel may lie beyond the far end.
      if (y > -0.3) continue;
      expect(along(field, x, y, z, seen()).distance).toBeCloseTo(0.7 / -y, 5);
    }
  });

  it('should meet the walls of a room exactly but in the texels of its edges (seed 72)', () => {
    const between = dice(72);
    const world = new World(room(0.8, 0.9, 1.1));
    const center = new Vector3(0.1, 0.05, -0.1);
    const field = drawn(world, center, { far: 4 });
    let near = 0;
    for (let i = 0; i < 2000; i++) {
      const d = direction(between);
      const exits = [
        ((d.x > 0 ? 0.8 : -0.8) - center.x) / d.x,
        ((d.y > 0 ? 0.9 : -0.9) - center.y) / d.y,
        ((d.z > 0 ? 1.1 : -1.1) - center.z) / d.z,
      ].sort((a, b) => a - b);
      if (exits[1]! - exits[0]! < 0.15) continue;
      near++;
      expect(along(field, d.x, d.y, d.z, seen()).distance).toBeCloseTo(exits[0]!, 5);
    }
    expect(near).toBeGreaterThan(1000);
  });

  it('should come near a ball, and see nothing beside it', () => {
    const field = drawn(new World(new Ball(0.5).at(1, 0, 0)), new Vector3(), { far: 2 });
    const target = seen();
    expect(along(field, 1, 0, 0, target)).toBe(target);
    expect(target.distance).toBeCloseTo(0.5, 2);
    expect(field.object[target.texel]).toBe(1);
    expect(along(field, -1, 0, 0, seen()).distance).toBe(Infinity);
    expect(along(field, 0, 1, 0, seen()).distance).toBe(Infinity);
  });

  it('should change no distance by more than to half or twice, at a slant (seed 73)', () => {
    const between = dice(73);
    const field = drawn(new World(ground()), new Vector3(0, 0.05, 0), { resolution: 8, far: 2 });
    for (let i = 0; i < 2000; i++) {
      const { x, y, z } = direction(between);
      const { distance, texel } = along(field, x, y, z, seen());
      if (distance === Infinity) continue;
      const part = distance / field.distance[texel]!;
      expect(part).toBeGreaterThan(0.5);
      expect(part).toBeLessThan(2);
    }
  });
});

describe('isKnownFree of one cubemap', () => {
  const field = drawn(new World(ground()), new Vector3(0, 1, 0));
  const free = (x: number, y: number, z: number, margin: number) =>
    isKnownFree(field.distance, field.resolution, field.far, x, y, z, margin);

  it('should be so before a surface by the margin, and not behind it', () => {
    expect(free(0, -0.8, 0, 0.1)).toBe(true);
    expect(free(0, -0.8, 0, 0.25)).toBe(false);
    expect(free(0, -1.1, 0, 0)).toBe(false);
  });

  it('should be so where nothing was seen, but not beyond the far end', () => {
    expect(free(1.2, 0.6, 0, 0.1)).toBe(true);
    expect(free(0, 1.75, 0, 0)).toBe(true);
    expect(free(0, 1.75, 0, 0.1)).toBe(false);
    expect(free(0, 1.9, 0, 0)).toBe(false);
  });

  it('should be so at the centre itself', () => {
    expect(free(0, 0, 0, 0.5)).toBe(true);
  });
});
