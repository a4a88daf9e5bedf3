import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { hasTread } from '../../src/field/hasTread.js';
import { capsuleAt, remembered } from '../support/fields.js';
import { block, ground, ramp, rampFrom0, wall } from '../support/world/scenes.js';
import { World } from '../support/world/World.js';

const EYE = new Vector3(0, 0.9, 0);

describe('hasTread', () => {
  const body = capsuleAt(0, 0, 0);
  const SLOPE = Math.cos(0.8);
  const before = (height: number) =>
    remembered(new World(ground(), block([0.4, -1, -1], [2, height, 1])), EYE);

  it('should find a step within reach and height, and no other', () => {
    for (const height of [0.1, 0.2, 0.35]) {
      expect(hasTread(before(height), body, 0.05, 0.4, 0.2, SLOPE)).toBe(true);
    }
    expect(hasTread(before(0.03), body, 0.05, 0.4, 0.2, SLOPE)).toBe(false);
    expect(hasTread(before(0.5), body, 0.05, 0.4, 0.2, SLOPE)).toBe(false);
    expect(hasTread(remembered(new World(ground()), EYE), body, 0.05, 0.4, 0.2, SLOPE)).toBe(false);
  });

  it('should not find a step that is too far away', () => {
    const memory = remembered(
      new World(ground(), block([0.8, -1, -1], [2, 0.2, 1])),
      new Vector3(0.5, 0.9, 0),
    );
    expect(hasTread(memory, body, 0.05, 0.4, 0.3, SLOPE)).toBe(false);
    expect(hasTread(memory, body, 0.05, 0.4, 0.6, SLOPE)).toBe(true);
  });

  it('should not take a wall or what is too steep for a tread', () => {
    expect(hasTread(remembered(new World(wall(0.4)), EYE), body, 0.05, 0.4, 0.2, SLOPE)).toBe(
      false,
    );
    const steep = new World(ground(), rampFrom0(1, 3));
    steep.solids[1]!.object.position.x += 0.4;
    expect(hasTread(remembered(steep, EYE), body, 0.05, 0.4, 0.2, SLOPE)).toBe(false);
    expect(hasTread(remembered(new World(ramp(0.5)), EYE), body, 0.05, 0.4, 0.2, SLOPE)).toBe(true);
  });
});
