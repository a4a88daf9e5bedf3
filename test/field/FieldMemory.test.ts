import { Euler, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { ContactSet } from '../../src/field/ContactSet.js';
import { FieldMemory } from '../../src/field/FieldMemory.js';
import { findContacts } from '../../src/field/findContacts.js';
import { hasTread } from '../../src/field/hasTread.js';
import { timeOfImpact } from '../../src/field/timeOfImpact.js';
import { SIDES } from '../../src/field/neighbours.js';
import { axis, isOutOfReach, PIECE } from '../../src/field/pieces.js';
import {
  capsuleAt,
  cornersOf,
  dice,
  drawn,
  polygonDistance,
  remembered,
  unionDistance,
  UPRIGHT,
} from '../support/fields.js';
import { block, Box, ground, wall } from '../support/world/scenes.js';
import { randomWorld } from '../support/world/randomWorld.js';
import { World } from '../support/world/World.js';

/** A box in front of the field's centre, at (0, 0.9, 0): its shadow lies behind it. */
const shadowed = () => new World(ground(), block([0.5, 0, -0.3], [0.9, 1.5, 0.3]));
const EYE = new Vector3(0, 0.9, 0);

describe('gather', () => {
  it('should leave out nothing that a question is about, wherever the body goes (seed 62)', () => {
    const between = dice(62);
    let met = 0;
    for (let run = 0; run < 8; run++) {
      const yard = randomWorld(() => between(0, 1));
      const memory = new FieldMemory(UPRIGHT);
      const anew = new FieldMemory(UPRIGHT);
      const foot = new Vector3(between(-6, 6), between(0, 0.4), between(-6, 6));
      for (let k = 0; k < 3; k++) {
        const field = drawn(yard, new Vector3(foot.x + 0.3 * k, foot.y + 0.7, foot.z));
        for (const each of [memory, anew]) each.take(field);
      }
      for (let step = 0; step < 60; step++) {
        foot.add(new Vector3(between(-0.1, 0.1), between(-0.05, 0.05), between(-0.1, 0.1)));
        const body = capsuleAt(foot.x, foot.y, foot.z);
        const way = { x: between(-0.3, 0.3), y: between(-0.5, 0.5), z: between(-0.3, 0.3) };
        const reach = between(0.02, 0.3);
        const ask = (memory: FieldMemory) => {
          const { count, gap, normal } = findContacts(memory, body, reach, new ContactSet());
          return {
            gaps: gap.slice(0, count),
            normals: normal.slice(0, 3 * count),
            part: timeOfImpact(memory, body, way, 0.01),
            tread: hasTread(memory, body, 0.01, 0.4, reach, 0.7),
          };
        };
        const first = ask(memory);
        if (first.part < 1) met++;
        // Collected anew, just for this.
        anew.revision++;
        expect(ask(anew), `run ${run}, step ${step}`).toEqual(first);
      }
    }
    expect(met).toBeGreaterThan(50);
  });
});

describe('FieldMemory', () => {
  const world = new World(ground());
  const at = (x: number, options = {}) => drawn(world, new Vector3(x, 0.9, 0), options);
  const places = (memory: FieldMemory) => memory.kept.map(({ surfels }) => surfels.center.x);

  it('should know what an older field alone shows, however often the newest is drawn anew', () => {
    const memory = new FieldMemory(UPRIGHT);
    const scene = shadowed();
    memory.take(drawn(scene, new Vector3(1.4, 0.9, 0)));
    for (let i = 0; i < 600; i++) memory.take(drawn(scene, EYE, { resolution: 32 }));
    const { surfels } = memory.kept[1]!;
    let own = 0;
    for (let b = 0; b < surfels.first.length - 1; b++) if (memory.hasOwn(1, b)) own++;
    expect(own).toBeGreaterThan(20);
  });

  it('should keep three fields, the newest first', () => {
    const memory = new FieldMemory(UPRIGHT);
    expect(memory.newest).toBe(null);
    for (const x of [0, 1, 2, 3, 4]) expect(memory.take(at(x))).toBe(true);
    expect(places(memory)).toEqual([4, 3, 2]);
    expect(memory.newest!.center.x).toBe(4);
  });

  it('should take a field only once', () => {
    const memory = new FieldMemory(UPRIGHT);
    const field = at(0);
    expect(memory.take(field)).toBe(true);
    const { revision } = memory;
    expect(memory.take(field)).toBe(false);
    expect(memory.revision).toBe(revision);
  });

  it('should keep one field of one place, the newest', () => {
    const memory = new FieldMemory(UPRIGHT);
    for (const x of [0, 1, 0.03]) memory.take(at(x));
    expect(places(memory)).toEqual([0.03, 1]);
    for (const x of [0.04, 0.05, 1.01]) memory.take(at(x));
    expect(places(memory)).toEqual([1.01, 0.05]);
    memory.take(at(2));
    expect(places(memory)).toEqual([2, 1.01, 0.05]);
  });

  it('should outlive the field it was filled from', () => {
    const memory = new FieldMemory(UPRIGHT);
    const field = at(0);
    memory.take(field);
    field.distance.fill(Infinity);
    expect(memory.isHidden(0, -0.5, 0, 0.1)).toBe(true);
    expect(memory.isKnownFree(0, 0.5, 0, 0, 0)).toBe(true);
  });

  it('should forget all but the newest, or everything', () => {
    const memory = new FieldMemory(UPRIGHT);
    for (const x of [0, 1, 2]) memory.take(at(x));
    let { revision } = memory;
    memory.forgetOlder();
    expect(places(memory)).toEqual([2]);
    expect(memory.revision).toBeGreaterThan(revision);
    ({ revision } = memory);
    memory.forgetOlder();
    expect(memory.revision).toBe(revision);
    memory.forget();
    expect(memory.kept.length).toBe(0);
    expect(memory.newest).toBe(null);
    expect(memory.revision).toBeGreaterThan(revision);
    memory.take(at(5));
    expect(places(memory)).toEqual([5]);
  });

  it('should forget fields of another resolution', () => {
    const memory = new FieldMemory(UPRIGHT);
    for (const x of [0, 1]) memory.take(at(x));
    memory.take(at(2, { resolution: 16 }));
    expect(places(memory)).toEqual([2]);
    expect(memory.newest!.resolution).toBe(16);
  });

  it('should pass over in older fields what newer ones show again, and nothing else (seed 61)', () => {
    const between = dice(61);
    let passed = 0;
    let left = 0;
    for (let run = 0; run < 4; run++) {
      const yard = randomWorld(() => between(0, 1));
      const memory = new FieldMemory(UPRIGHT);
      for (const x of [0, 0.3, 0.5]) memory.take(drawn(yard, new Vector3(x, 0.9, 0.4 * x), {}));
      for (const { surfels } of memory.kept) surfels.findAll();
      for (let k = 1; k < 3; k++) {
        const { surfels, again } = memory.kept[k]!;
        for (let b = 0; b < surfels.first.length - 1; b++) memory.hasOwn(k, b);
        for (let i = 0; i < surfels.count; i += 37) {
          if (again[i] === 0) {
            left++;
            continue;
          }
          passed++;
          const corners = cornersOf(surfels, i);
          const middle = corners
            .reduce((sum, corner) => sum.add(corner), new Vector3())
            .divideScalar(corners.length);
          for (const point of [middle, ...corners]) {
            const newer = memory.kept
              .slice(0, k)
              .map(({ surfels }) => unionDistance(surfels, point));
            expect(Math.min(...newer), `run ${run}, field ${k}, surfel ${i}`).toBeLessThan(0.0011);
          }
        }
      }
    }
    // Most of a yard is seen again.
    expect(passed).toBeGreaterThan(2 * left);
  });

  it('should ask again of a newer field what an older newest one did not show', () => {
    const memory = new FieldMemory(UPRIGHT);
    const own = (k: number) => {
      const blocks = memory.kept[k]!.surfels.first.length - 1;
      return Array.from({ length: blocks }, (_, b) => memory.hasOwn(k, b)).filter(Boolean).length;
    };
    memory.take(at(0));
    const all = own(0);
    memory.take(at(0.8));
    const some = own(1);
    expect(some).toBeGreaterThan(0);
    expect(some).toBeLessThan(all);
    memory.take(at(-0.8));
    expect(own(2)).toBeLessThan(some);
  });
});

/** Distance of a polygon from an upright segment; along that it is convex. */
function axisDistance(x: number, z: number, low: number, high: number, corners: Vector3[]): number {
  const at = (y: number) => polygonDistance(new Vector3(x, y, z), corners);
  for (let round = 0; round < 40; round++) {
    const third = (high - low) / 3;
    if (at(low + third) < at(high - third)) high -= third;
    else low += third;
  }
  return at((low + high) / 2);
}

describe('pieces', () => {
  it('should pass over no surfel within reach that is not some neighbour’s to tell of (seed 62)', () => {
    const between = dice(62);
    const box = new Box(0.3, 0.4, 0.3, 'box').at(-0.7, 0.2, 0).turn({ yaw: 0.4, roll: 0.3 });
    const memory = remembered(new World(ground(), wall(0.6), box), EYE);
    const surfels = memory.kept[0]!.surfels.findAll();
    const { block, first, link, origin, piece } = surfels;
    let near = 0;
    for (let run = 0; run < 4; run++) {
      const body = capsuleAt(between(-0.2, 0.2), between(0, 0.2), between(-0.2, 0.2));
      const [low, high] = [body.y + 0.3, body.y + 1.5];
      const reached = body.radius + between(0.05, 0.3);
      const distances = Array.from({ length: surfels.count }, (_, i) => {
        const corners = cornersOf(surfels, i);
        return axisDistance(body.x, body.z, low, high, corners);
      });
      axis.set([body.x - origin.x, body.z - origin.z, low - origin.y, high - origin.y, reached]);
      for (let b = 0; b < first.length - 1; b++) {
        const without = isOutOfReach(block, PIECE * b);
        for (let i = first[b]!; i < first[b + 1]!; i++) {
          if (distances[i]! >= reached) continue;
          near++;
          if (!without && !isOutOfReach(piece, PIECE * i)) continue;
          const around = [0, 1, 2, 3].map((side) => distances[link[SIDES * i + side]!]!);
          expect(Math.min(...around), `run ${run}, surfel ${i}`).toBeLessThan(distances[i]! + 1e-4);
        }
      }
    }
    expect(near).toBeGreaterThan(1000);
  });
});

describe('isHidden and isKnownFree', () => {
  it('should tell what lies behind a box from what was seen', () => {
    const memory = remembered(shadowed(), EYE);
    const seen: [number, number, number][] = [
      [0.4, 0.9, 0],
      [0, 0.1, 0],
      [0, 0.9, 1],
      [1.2, 0.9, 1.2],
      [-1, 0.5, 0.5],
    ];
    for (const [x, y, z] of seen) {
      expect(memory.isKnownFree(x, y, z, 0, 0), `${x}, ${y}, ${z}`).toBe(true);
      expect(memory.isHidden(x, y, z, 0.1), `${x}, ${y}, ${z}`).toBe(false);
    }
    for (const [x, y, z] of [
      [1.1, 0.9, 0],
      [1.3, 0.8, 0.1],
      [0.8, 0.9, 0],
      [0, -0.2, 0],
    ] as const) {
      expect(memory.isKnownFree(x, y, z, 0, 0), `${x}, ${y}, ${z}`).toBe(false);
      expect(memory.isHidden(x, y, z, 0.1), `${x}, ${y}, ${z}`).toBe(true);
    }
    // Not deep enough behind it.
    expect(memory.isHidden(0.55, 0.9, 0, 0.1)).toBe(false);
    expect(memory.isHidden(0.55, 0.9, 0, 0.04)).toBe(true);
  });

  it('should not hide what an older field saw', () => {
    const world = shadowed();
    const memory = new FieldMemory(UPRIGHT);
    memory.take(drawn(world, new Vector3(1.2, 0.9, 0.8)));
    memory.take(drawn(world, EYE));
    expect(memory.isHidden(1.1, 0.9, 0, 0.1)).toBe(false);
    memory.forgetOlder();
    expect(memory.isHidden(1.1, 0.9, 0, 0.1)).toBe(true);
  });

  it('should hide nothing while nothing is known', () => {
    const memory = new FieldMemory(UPRIGHT);
    expect(memory.isHidden(1, 1, 1, 0)).toBe(false);
    expect(memory.isKnownFree(0, 0, 0, 0, 0)).toBe(false);
  });

  it('should keep to the margin, and to what the whole reach lies in view of', () => {
    const memory = remembered(new World(wall(1)), EYE);
    expect(memory.isKnownFree(0.8, 0.9, 0, 0.1, 0)).toBe(true);
    expect(memory.isKnownFree(0.8, 0.9, 0, 0.25, 0)).toBe(false);
    expect(memory.isKnownFree(-1.2, 0.9, 0, 0.1, 0.5)).toBe(true);
    expect(memory.isKnownFree(-1.2, 0.9, 0, 0.1, 0.7)).toBe(false);
    // It sees 1.8 m far.
    expect(memory.isKnownFree(-1.75, 0.9, 0, 0.1, 0)).toBe(false);
  });

  it('should ask in the body frame, whatever way the body is turned (seed 62)', () => {
    const between = dice(62);
    const upright = remembered(shadowed(), EYE);
    const toBody = new Quaternion().setFromEuler(new Euler(0.9, -0.4, 1.8));
    const turned = remembered(shadowed(), EYE, { toBody });
    let hidden = 0;
    for (let i = 0; i < 500; i++) {
      const p = new Vector3(between(-1.5, 1.5), between(0, 1.8), between(-1.5, 1.5));
      const told = upright.isHidden(p.x, p.y, p.z, 0.1);
      const { x, y, z } = p.applyQuaternion(toBody);
      expect(turned.isHidden(x, y, z, 0.1), `${i}`).toBe(told);
      if (told) hidden++;
    }
    expect(hidden).toBeGreaterThan(20);
  });

  it('should never call a place free from which the centre is not seen, but for a texel (seed 63)', () => {
    const between = dice(63);
    for (let run = 0; run < 4; run++) {
      const world = randomWorld(() => between(0, 1));
      world.refresh();
      const eye = new Vector3(between(-0.5, 0.5), 0.9, between(-0.5, 0.5));
      const memory = remembered(world, eye, { far: 8 });
      let told = 0;
      let wrong = 0;
      for (let i = 0; i < 400; i++) {
        const way = new Vector3(between(-1, 1), between(-1, 1), between(-1, 1)).normalize();
        const away = between(0.2, 7);
        let free = Infinity;
        for (const solid of world.solids) {
          const o = eye.clone().applyMatrix4(solid.inverse);
          const d = way.clone().transformDirection(solid.inverse);
          free = Math.min(free, solid.cast(o.x, o.y, o.z, d.x, d.y, d.z));
        }
        const { x, y, z } = way.multiplyScalar(away).add(eye);
        if (!memory.isKnownFree(x, y, z, 0, 0)) continue;
        told++;
        if (away > free) wrong++;
      }
      expect(told).toBeGreaterThan(50);
      // One texel tells of all of it, edges too.
      expect(wrong / told, `run ${run}`).toBeLessThan(0.06);
    }
  });
});
