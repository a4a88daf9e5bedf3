import { Euler, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import type { Capsule } from '../../src/field/Capsule.js';
import { ContactSet } from '../../src/field/ContactSet.js';
import type { FieldMemory } from '../../src/field/FieldMemory.js';
import { findContacts } from '../../src/field/findContacts.js';
import { capsuleAt, dice, exactGap, remembered, UP } from '../support/fields.js';
import { block, Box, corner, ground, kerb, ramp, room, wall } from '../support/world/scenes.js';
import { World } from '../support/world/World.js';

const MILLIMETRE = 1e-3;

interface Met {
  point: Vector3;
  normal: Vector3;
  gap: number;
  surfaceUp: number;
}

/** Contacts, nearest first. */
function contacts(memory: FieldMemory, capsule: Capsule, reach: number): Met[] {
  const set = findContacts(memory, capsule, reach, new ContactSet());
  return Array.from({ length: set.count }, (_, c) => ({
    point: new Vector3(...set.point.subarray(3 * c, 3 * c + 3)),
    normal: new Vector3(...set.normal.subarray(3 * c, 3 * c + 3)),
    gap: set.gap[c]!,
    surfaceUp: set.surfaceUp[c]!,
  })).sort((a, b) => a.gap - b.gap);
}

describe('findContacts on flat ground', () => {
  it('should find one contact, wherever it stands (seed 40)', () => {
    const between = dice(40);
    for (let run = 0; run < 100; run++) {
      const center = new Vector3(between(-1, 1), between(0.6, 1.1), between(-1, 1));
      const memory = remembered(new World(ground()), center);
      for (let k = 0; k < 10; k++) {
        const [x, z] = [center.x + between(-0.2, 0.2), center.z + between(-0.2, 0.2)];
        const found = contacts(memory, capsuleAt(x, between(-0.05, 0.15), z), 0.2);
        expect(found.length, `run ${run}.${k}`).toBe(1);
      }
    }
  });

  it('should touch the ground under its foot, whatever way the world is turned (seed 41)', () => {
    const between = dice(41);
    for (let run = 0; run < 60; run++) {
      const turn = new Euler(between(-3, 3), between(-3, 3), between(-3, 3));
      const world = new World(ground());
      world.root.rotation.copy(turn);
      const toBody = new Quaternion().setFromEuler(turn).conjugate();
      const center = new Vector3(between(-1, 1), between(0.6, 1.1), between(-1, 1));
      const toWorld = toBody.clone().conjugate();
      const memory = remembered(world, center.clone().applyQuaternion(toWorld), { toBody });
      const [x, z] = [center.x + between(-0.2, 0.2), center.z + between(-0.2, 0.2)];
      const y = between(-0.05, 0.15);
      const found = contacts(memory, capsuleAt(x, y, z), 0.2);
      expect(found[0]!.gap, `run ${run}`).toBeCloseTo(y, 4);
      expect(found[0]!.normal.distanceTo(UP)).toBeLessThan(1e-4);
      expect(found[0]!.point.distanceTo(new Vector3(x, 0, z))).toBeLessThan(1e-4);
      expect(found[0]!.surfaceUp).toBeCloseTo(1, 5);
    }
  });

  it('should find nothing beyond its reach', () => {
    const memory = remembered(new World(ground()), new Vector3(0, 0.9, 0));
    expect(contacts(memory, capsuleAt(0, 0.05, 0), 0.06).length).toBe(1);
    expect(contacts(memory, capsuleAt(0, 0.05, 0), 0.04).length).toBe(0);
  });

  it.each([0.2, 0.5, 0.8])('should find one contact on a slope of %f rad', (angle) => {
    const memory = remembered(new World(ramp(angle)), new Vector3(0.1, 0.9, 0));
    const found = contacts(memory, capsuleAt(0.1, 0.2, 0.02), 0.3);
    expect(found.length).toBe(1);
    const normal = new Vector3(-Math.sin(angle), Math.cos(angle), 0);
    expect(found[0]!.normal.distanceTo(normal)).toBeLessThan(1e-4);
    expect(found[0]!.surfaceUp).toBeCloseTo(normal.y, 5);
  });
});

describe('findContacts beside boxes and planes', () => {
  const SCENES: [string, (between: (low: number, high: number) => number) => World][] = [
    ['a floor and a wall', (of) => new World(ground(), wall(of(0.4, 0.6), 0, of(-0.5, 0.5)))],
    ['a slope', (of) => new World(ramp(of(-0.8, 0.8)).at(0, of(-0.6, -0.3), 0))],
    ['a room', (of) => new World(room(of(0.4, 0.8), of(0.95, 1), of(0.4, 0.8)))],
    ['a corner', (of) => new World(corner(of(1, 2.6)))],
    ['a kerb', (of) => new World(ground(), kerb(of(0.05, 0.4), of(0.25, 0.5), of(-0.6, 0.6)))],
  ];

  it.each(SCENES)('should tell the exact distance from %s (seed 42)', (name, make) => {
    const between = dice(42);
    let told = 0;
    for (let run = 0; run < 40; run++) {
      const world = make(between);
      const x = name === 'a corner' ? between(0.5, 0.8) : 0;
      const base = name === 'a room' ? -0.9 : 0;
      const memory = remembered(world, new Vector3(x, base + 0.9, 0));
      for (let k = 0; k < 10; k++) {
        const capsule = capsuleAt(
          x + between(-0.1, 0.1),
          base + between(0.01, 0.1),
          between(-0.1, 0.1),
          between(0.15, 0.3),
          between(0.8, 1.8),
        );
        const gap = exactGap(world, capsule);
        if (gap < -0.1 || gap > 0.29) continue;
        told++;
        const found = contacts(memory, capsule, 0.3);
        expect(found.length, `run ${run}.${k}`).toBeGreaterThan(0);
        expect(Math.abs(found[0]!.gap - gap), `run ${run}.${k}`).toBeLessThan(MILLIMETRE);
      }
    }
    expect(told).toBeGreaterThan(100);
  });

  it('should find both walls of a concave corner, and nothing else', () => {
    for (const angle of [1, Math.PI / 2, 2.4]) {
      const memory = remembered(new World(corner(angle)), new Vector3(0.7, 0.9, 0.02));
      const found = contacts(memory, capsuleAt(0.6, 0, 0.01), 0.5);
      expect(found.length, `${angle}`).toBe(2);
      for (const side of [1, -1]) {
        // Each wall's normal points into the corner.
        const normal = new Vector3(Math.sin(angle / 2), 0, side * Math.cos(angle / 2));
        expect(found.some((each) => each.normal.distanceTo(normal) < 1e-3)).toBe(true);
      }
    }
  });

  it('should find floor and wall where they meet', () => {
    const memory = remembered(new World(ground(), wall(0.4)), new Vector3(0, 0.9, 0));
    const found = contacts(memory, capsuleAt(0, 0.01, 0), 0.15);
    expect(found.length).toBe(2);
    expect(found[0]!.normal.distanceTo(UP)).toBeLessThan(1e-3);
    expect(found[0]!.gap).toBeCloseTo(0.01, 4);
    expect(found[1]!.normal.distanceTo(new Vector3(-1, 0, 0))).toBeLessThan(1e-3);
    expect(found[1]!.gap).toBeCloseTo(0.095, 4);
  });

  it('should turn the normal of an edge from there to the axis of the body (seed 43)', () => {
    const between = dice(43);
    for (let run = 0; run < 40; run++) {
      const [height, at] = [between(0.06, 0.24), between(0.3, 0.45)];
      const world = new World(block([at, -1, -3], [3, height, 3]));
      // Low enough to see the riser not edge-on.
      const memory = remembered(world, new Vector3(0, 0.65, 0));
      const capsule = capsuleAt(0, between(0.02, 0.06), between(-0.05, 0.05));
      // The middle of the foot's sphere is higher than the edge, and before it.
      const middle = new Vector3(0, capsule.y + 0.3, capsule.z);
      const edge = new Vector3(at, height, capsule.z);
      const [met] = contacts(memory, capsule, 0.3);
      expect(met, `run ${run}`).toBeDefined();
      expect(met!.point.distanceTo(edge), `run ${run}`).toBeLessThan(MILLIMETRE);
      const normal = middle.clone().sub(edge).normalize();
      expect(met!.normal.distanceTo(normal), `run ${run}`).toBeLessThan(5e-3);
      expect(met!.gap).toBeCloseTo(middle.distanceTo(edge) - 0.3, 3);
      // The edge belongs to a face to stand on.
      expect(met!.surfaceUp).toBeCloseTo(1, 3);
    }
  });

  it('should tell an overlap as a gap below 0', () => {
    const world = new World(ground(), new Box(0.2, 0.4, 0.2).at(0.45, 0.4, 0));
    const memory = remembered(world, new Vector3(0, 0.9, 0));
    const found = contacts(memory, capsuleAt(0, 0.01, 0), 0.05);
    expect(found[0]!.gap).toBeCloseTo(-0.05, 3);
    expect(found[0]!.normal.distanceTo(new Vector3(-1, 0, 0))).toBeLessThan(0.02);
  });
});
