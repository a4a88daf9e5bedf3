import { Euler, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { FieldMemory } from '../../src/field/FieldMemory.js';
import {
  capsuleAt,
  cornersOf,
  dice,
  drawn,
  polygonDistance,
  remembered,
  UPRIGHT,
} from '../support/fields.js';
import { block, ground, wall } from '../support/world/scenes.js';
import { randomWorld } from '../support/world/randomWorld.js';
import { World } from '../support/world/World.js';

/** A box in front of the field's centre, at (0, 0.9, 0): its shadow lies behind it. */
const shadowed = () => new World(ground(), block([0.5, 0, -0.3], [0.9, 1.5, 0.3]));
const EYE = new Vector3(0, 0.9, 0);

describe('FieldMemory', () => {
  const world = new World(ground());
  const at = (x: number, options = {}) => drawn(world, new Vector3(x, 0.9, 0), options);
  const places = (memory: FieldMemory) => memory.kept.map(({ surfels }) => surfels.center.x);

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

  it('should gather every surfel within reach of the body (seed 61)', () => {
    const between = dice(61);
    const memory = remembered(
      new World(ground(), wall(0.6), block([-0.8, 0, -0.3], [-0.5, 0.4, 0.3])),
      EYE,
    );
    const { surfels, near } = memory.kept[0]!;
    for (let run = 0; run < 20; run++) {
      const body = capsuleAt(between(-0.2, 0.2), between(0, 0.2), between(-0.2, 0.2));
      const reach = between(0.05, 0.3);
      memory.gather(body, reach);
      const gathered = new Set(near.subarray(0, memory.kept[0]!.nearCount));
      for (let i = 0; i < surfels.count; i++) {
        if (gathered.has(i)) continue;
        const corners = cornersOf(surfels, i);
        for (let k = 0; k <= 8; k++) {
          const y = body.y + 0.3 + (k / 8) * 1.2;
          const away = polygonDistance(new Vector3(body.x, y, body.z), corners);
          expect(away - body.radius, `run ${run}, surfel ${i}`).toBeGreaterThan(reach);
        }
      }
    }
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
