import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { seesAhead } from '../../src/character/seesAhead.js';
import { FieldMemory } from '../../src/field/FieldMemory.js';
import { capsuleAt, remembered, UPRIGHT } from '../support/fields.js';
import { block, ground } from '../support/world/scenes.js';
import { World } from '../support/world/World.js';

/** A box in front of the field's centre, at (0, 0.9, 0): its shadow lies behind it. */
const shadowed = () => new World(ground(), block([0.5, 0, -0.3], [0.9, 1.5, 0.3]));
const EYE = new Vector3(0, 0.9, 0);

describe('seesAhead', () => {
  const body = capsuleAt(0, 0, 0);

  it('should see where nothing is in the way, and not behind a box', () => {
    const memory = remembered(shadowed(), EYE);
    expect(seesAhead(memory, body, -0.5, 0, 0)).toBe(true);
    expect(seesAhead(memory, body, 0, 0, 0.7)).toBe(true);
    expect(seesAhead(memory, body, 0.15, 0, 0)).toBe(true);
    expect(seesAhead(memory, body, 1.1, 0, 0)).toBe(false);
  });

  it('should not see around a jamb', () => {
    // A long wall at x = 0.5 from z = 0.2 on: what is behind it cannot be known from before it.
    const memory = remembered(new World(ground(), block([0.5, 0, 0.2], [0.6, 3, 5])), EYE);
    expect(seesAhead(memory, body, 0.9, 0, 0.5)).toBe(false);
    expect(seesAhead(memory, body, 0.5, 0, -0.6)).toBe(true);
  });

  it('should look where it leads, not behind', () => {
    // Its back stands in the wall's shadow, its way leads out of it.
    const memory = remembered(
      new World(ground(), block([0.35, 0, -1], [0.5, 3, 1])),
      new Vector3(0, 0.9, 0),
    );
    const beside = capsuleAt(0.6, 0, 0);
    expect(seesAhead(memory, beside, 0.2, 0, 0)).toBe(false);
    const before = capsuleAt(0.15, 0, 0, 0.45);
    expect(seesAhead(memory, before, -0.05, 0, 0)).toBe(true);
    expect(seesAhead(memory, before, 0.05, 0, 0)).toBe(false);
  });

  it('should see down only to where something hides the depth', () => {
    const open = remembered(new World(), EYE);
    expect(seesAhead(open, body, 0, -0.5, 0)).toBe(true);
    const ledge = remembered(new World(block([-1, -0.2, -1], [1, 0, 1])), EYE);
    expect(seesAhead(ledge, body, 0, -0.02, 0)).toBe(true);
    expect(seesAhead(ledge, body, 0, -0.5, 0)).toBe(false);
  });

  it('should see everything while nothing is known', () => {
    expect(seesAhead(new FieldMemory(UPRIGHT), body, 1, 1, 1)).toBe(true);
  });
});
