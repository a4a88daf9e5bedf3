import { Euler, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import type { Capsule } from '../../src/field/Capsule.js';
import { timeOfImpact, type Way } from '../../src/field/timeOfImpact.js';
import { capsuleAt, dice, exactGap, remembered } from '../support/fields.js';
import { Box, ground, kerb, ramp, room, wall } from '../support/world/scenes.js';
import { World } from '../support/world/World.js';

const MILLIMETRE = 1e-3;

const length = ({ x, y, z }: Way) => Math.hypot(x, y, z);
const along = (capsule: Capsule, way: Way, t: number): Capsule => ({
  ...capsule,
  x: capsule.x + t * way.x,
  y: capsule.y + t * way.y,
  z: capsule.z + t * way.z,
});

/** The truth, by marching: nothing is nearer than the exact gap, so that much is free. */
function march(world: World, capsule: Capsule, way: Way, gap: number): number {
  let t = 0;
  for (let i = 0; i < 20_000 && t < 1; i++) {
    const room = exactGap(world, along(capsule, way, t)) - gap;
    if (room < 1e-6) return t;
    t += room / length(way);
  }
  return Math.min(t, 1);
}

/** What lies within a way of 0.3 m all around: planes, or boxes seen from before. */
type Make = (between: (low: number, high: number) => number) => World;
const PLANES: [string, Make][] = [
  ['ground', () => new World(ground())],
  ['a slope', (of) => new World(ramp(of(-0.5, 0.5)).at(0, -0.3, 0))],
  ['a wall', (of) => new World(ground(), wall(of(0.4, 0.55), 0, of(-0.5, 0.5)))],
  ['a room', (of) => new World(room(of(0.4, 0.7), of(0.95, 1.1), of(0.4, 0.7)).map(raised))],
];
const raised = <T extends { object: { position: Vector3 } }>(solid: T): T => {
  solid.object.position.y += 0.93;
  return solid;
};
const EDGES: [string, Make][] = [
  ['a kerb', (of) => new World(ground(), kerb(of(0.05, 0.4), of(0.35, 0.5), of(-0.5, 0.5)))],
  ['a low ceiling', (of) => new World(ground(), new Box(2, 0.1, 2).at(of(2.35, 2.5), 1.8, 0))],
];

describe('timeOfImpact', () => {
  it.each([...PLANES, ...EDGES])('should be when the body meets %s (seed 51)', (_, make) => {
    const between = dice(51);
    let met = 0;
    for (let run = 0; run < 25; run++) {
      const world = make(between);
      const memory = remembered(world, new Vector3(0, 0.92, 0));
      for (let k = 0; k < 12; k++) {
        const capsule = capsuleAt(0, between(0.02, 0.05), 0);
        const way = new Vector3(0, 0, between(0.02, 0.35)).applyEuler(
          new Euler(between(-1.5, 1.5), between(-3, 3), 0, 'YXZ'),
        );
        if (exactGap(world, capsule) < 0.01) continue;
        const gap = between(0, 0.008);
        const truth = march(world, capsule, way, gap);
        const told = timeOfImpact(memory, capsule, way, gap);
        if (truth < 1) met++;
        // At a grazing touch the time says little: by how far it would be in, or short of it.
        const off = (told - truth) * length(way);
        const say = `run ${run}.${k}: ${told} for ${truth}, ${(off / MILLIMETRE).toFixed(2)} mm`;
        expect(Math.abs(off), say).toBeLessThan(MILLIMETRE);
      }
    }
    expect(met).toBeGreaterThan(40);
  });

  it('should be 1 for ways that lead away, however near it stands (seed 52)', () => {
    const between = dice(52);
    const world = new World(ground(), wall(0.31));
    const memory = remembered(world, new Vector3(0, 0.9, 0));
    for (let run = 0; run < 200; run++) {
      const way = { x: between(-0.5, 0), y: between(0, 0.5), z: between(-0.5, 0.5) };
      expect(timeOfImpact(memory, capsuleAt(0, 1e-3, 0), way, 1e-3)).toBe(1);
    }
    expect(timeOfImpact(memory, capsuleAt(0, 0, 0), { x: 0, y: 0, z: 0 }, 0.01)).toBe(1);
  });

  it('should pass over surfels that are already nearer than "near"', () => {
    const memory = remembered(new World(ground(), wall(0.405)), new Vector3(0, 0.9, 0));
    const at = (way: Way, near: number) => timeOfImpact(memory, capsuleAt(0, 0.1, 0), way, 0, near);
    // The wall and the ground are 0.1 m away; all of them that the body sweeps lies nearer than 0.3 m.
    for (const way of [
      { x: 0.2, y: 0, z: 0 },
      { x: 0, y: -0.2, z: 0 },
    ]) {
      expect(at(way, 0)).toBeCloseTo(0.5, 3);
      expect(at(way, 0.09)).toBeCloseTo(0.5, 3);
      expect(at(way, 0.3)).toBe(1);
    }
  });

  it.each([-4, 0, 1, 3, 5, 7, 12])(
    'should let what is passed along its surface come as near as "graze": a wall that leans by %f°',
    (degrees) => {
      const [gap, graze] = [0.02, 0.008];
      const lean = (degrees * Math.PI) / 180;
      const way = { x: 0, y: -0.4, z: 0 };
      const capsule = capsuleAt(0, 0.5, 0);
      const leaning = wall(0.6).turn({ roll: -lean });
      const world = new World(leaning);
      world.refresh();
      leaning.object.position.x -= (exactGap(world, capsule) - 0.024) / Math.cos(lean);
      const memory = remembered(world, new Vector3(0, 1.2, 0));
      // 6° part the two.
      const wanted = degrees < 6 ? graze : gap;
      const told = timeOfImpact(memory, capsule, way, gap, gap, null, graze);
      const off = (told - march(world, capsule, way, wanted)) * length(way) * Math.sin(lean);
      expect(Math.abs(off)).toBeLessThan(MILLIMETRE);
      if (degrees >= 3) expect(told).toBeLessThan(1);
    },
  );

  it('should not graze an edge that it comes down on beside its wall', () => {
    const world = new World(ground(), kerb(0.5, 0.28));
    const memory = remembered(world, new Vector3(0, 1.2, 0));
    const capsule = capsuleAt(0, 0.6, 0);
    const way = { x: 0, y: -0.4, z: 0 };
    const told = timeOfImpact(memory, capsule, way, 0.02, 0.02, null, 0.01);
    const off = (told - march(world, capsule, way, 0.02)) * length(way);
    expect(Math.abs(off)).toBeLessThan(MILLIMETRE);
  });

  it('should stop at nothing but one object, if asked', () => {
    const near = wall(0.405);
    const far = wall(-0.505);
    const floor = ground();
    const memory = remembered(new World(near, far, floor), new Vector3(0, 0.9, 0));
    const capsule = capsuleAt(0, 0.05, 0);
    const to = { x: 0.4, y: -0.1, z: 0 };
    expect(timeOfImpact(memory, capsule, to, 0)).toBeCloseTo(0.25, 3);
    expect(timeOfImpact(memory, capsule, to, 0, 0, floor.object)).toBeCloseTo(0.5, 3);
    expect(timeOfImpact(memory, capsule, to, 0, 0, far.object)).toBe(1);
    expect(timeOfImpact(memory, capsule, { ...to, x: -0.4 }, 0, 0, far.object)).toBeCloseTo(0.5, 3);
    expect(timeOfImpact(memory, capsule, to, 0, 0, new Box(1, 1, 1).object)).toBe(1);
  });
});
