import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { supportDepth } from '../../src/field/supportDepth.js';
import { capsuleAt, remembered } from '../support/fields.js';
import { ground, kerb } from '../support/world/scenes.js';
import { World } from '../support/world/World.js';

describe('supportDepth', () => {
  it('should be how far it is to the ground, less the gap left', () => {
    const memory = remembered(new World(ground()), new Vector3(0, 0.9, 0));
    for (const y of [0.02, 0.1, 0.3]) {
      expect(supportDepth(memory, capsuleAt(0.01, y, 0), 0.4, 0.01)).toBeCloseTo(y - 0.01, 4);
    }
  });

  it('should be infinite where nothing carries within the depth', () => {
    const memory = remembered(new World(ground()), new Vector3(0, 0.9, 0));
    expect(supportDepth(memory, capsuleAt(0, 0.2, 0), 0.15, 0.01)).toBe(Infinity);
    expect(supportDepth(remembered(new World(), new Vector3()), capsuleAt(0, 0, 0), 1, 0)).toBe(
      Infinity,
    );
  });

  it('should sink until a kerb under the side of the foot carries it', () => {
    const at = 0.2;
    const memory = remembered(new World(ground(), kerb(0.1, at)), new Vector3(0, 0.95, 0));
    const foot = 0.25;
    // The sphere of the foot comes to rest on the edge.
    const depth = foot - 0.1 + 0.3 - Math.sqrt(0.3 ** 2 - at ** 2);
    expect(supportDepth(memory, capsuleAt(0, foot, 0), 0.4, 0)).toBeCloseTo(depth, 3);
  });
});
