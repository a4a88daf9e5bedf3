import { Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import type { Capsule } from '../../src/field/Capsule.js';
import { ContactSet } from '../../src/field/ContactSet.js';
import { FieldMemory } from '../../src/field/FieldMemory.js';
import { findContacts } from '../../src/field/findContacts.js';
import { SurfaceField, type SurfaceSampler } from '../../src/field/SurfaceField.js';
import { SlideResponse } from '../../src/response/SlideResponse.js';

const LIMITS = { skin: 0.02, slope: Math.cos((50 * Math.PI) / 180), stepHeight: 0.4 };
const contacts = new ContactSet();
const [RADIUS, HEIGHT] = [0.35, 1.8];

describe('a walk on the edge of a ledge that runs along a wall', () => {
  /**
   * The wall x <= 0 and a ledge before it, 0.14 m deep and 0.7 m high. Of its top, texels end `unseen` metres before the
   * edge; its front they see up to `front`.
   */
  function ledge(unseen: number, front: number): SurfaceSampler {
    return (center, [x, y]) => {
      const toTop = y < 0 ? (0.7 - center.y) / y : Infinity;
      const toFront = x < 0 ? (0.14 - center.x) / x : Infinity;
      if (center.y + toFront * y < front) return { distance: toFront, normal: [1, 0, 0] };
      const at = center.x + toTop * x;
      if (at > 0 && at < 0.14) {
        return at < 0.14 - unseen ? { distance: toTop, normal: [0, 1, 0] } : null;
      }
      return x < 0 ? { distance: -center.x / x, normal: [1, 0, 0] } : null;
    };
  }

  function gapBelow(memory: FieldMemory, body: Capsule): number {
    const { count, gap, normal } = findContacts(memory, body, 0.2, contacts);
    let least = Infinity;
    for (let i = 0; i < count; i++) {
      if (normal[3 * i + 1]! > 0.3) least = Math.min(least, gap[i]!);
    }
    return least;
  }

  it('should not be pressed into the wall, however little of the top is seen', () => {
    for (const unseen of [0, 0.02, 0.04]) {
      for (const front of [0.695, 0.7, 0.705]) {
        const memory = new FieldMemory(new Quaternion());
        const center = new Vector3(0.37, 1.3, 0);
        memory.take(SurfaceField.from(ledge(unseen, front), { resolution: 128, far: 2.2, center }));
        const response = new SlideResponse();
        // It touches the wall, and almost the edge.
        const body = { x: 0.37, y: 0.75, z: 0, radius: RADIUS, height: HEIGHT };
        while (gapBelow(memory, body) > 0.0215) body.y -= 0.0005;
        for (let step = 0; step < 10; step++) {
          response.walk(memory, body, -0.074, -0.038, LIMITS);
          const say = `${unseen} m unseen, front ${front} m, step ${step}`;
          expect(body.x - RADIUS, say).toBeGreaterThan(0.009);
        }
      }
    }
  });
});
