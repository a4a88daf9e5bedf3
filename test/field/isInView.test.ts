import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { isInView, place } from '../../src/field/isInView.js';
import { dice, drawn, remembered } from '../support/fields.js';
import { block, ground, room, wall } from '../support/world/scenes.js';
import { World } from '../support/world/World.js';

describe('isInView', () => {
  it('should tell inside from outside to a centimetre, however coarse the texels', () => {
    const [hx, hy, hz] = [2, 1.2, 3];
    const center = new Vector3(0.4, 0.3, -1);
    const memory = remembered(new World(room(hx, hy, hz)), center, { resolution: 16, far: 8 });
    const roll = dice(3);
    let inside = 0;
    for (let i = 0; i < 5000; i++) {
      place.set([roll(-2.4, 2.4), roll(-1.6, 1.6), roll(-3.4, 3.4)]);
      const [x, y, z] = place;
      const depth = Math.max(Math.abs(x!) - hx, Math.abs(y!) - hy, Math.abs(z!) - hz);
      if (Math.abs(depth) < 0.01) continue;
      // Where two walls meet in one texel, only one is known: looked at where the ray leaves the room.
      const way = new Vector3(x!, y!, z!).sub(center);
      const rest = [hx, hy, hz].map((half, a) => {
        const d = way.getComponent(a);
        return (Math.sign(d) * half - center.getComponent(a)) / d;
      });
      const exit = way.multiplyScalar(Math.min(...rest)).add(center);
      const corner = [hx - Math.abs(exit.x), hy - Math.abs(exit.y), hz - Math.abs(exit.z)];
      if (corner.sort((a, b) => a - b)[1]! < 0.8) continue;
      expect(isInView(memory), `${x}, ${y}, ${z}`).toBe(depth < 0);
      if (depth < 0) inside++;
    }
    expect(inside).toBeGreaterThan(300);
  });

  it('should not see behind a wall, nor beyond its reach, until another field looks there', () => {
    const world = new World(ground(), block([-0.5, 0, -2.1], [0.5, 3, -2]));
    const memory = remembered(world, new Vector3(0, 1.6, 0), { far: 5 });
    const sees = (x: number, y: number, z: number) => {
      place.set([x, y, z]);
      return isInView(memory);
    };
    expect(sees(0, 1.6, -1.9)).toBe(true);
    expect(sees(0, 1.6, -3)).toBe(false);
    expect(sees(0, 1.6, 5.1)).toBe(false);
    expect(sees(0, -0.1, 1)).toBe(false);
    memory.take(drawn(world, new Vector3(3, 1.6, -3), { far: 5 }));
    expect(sees(0, 1.6, -3)).toBe(true);
  });

  it('should see along a floor and a wall at a slant', () => {
    const world = new World(ground(), wall(1));
    const memory = remembered(world, new Vector3(0, 1.6, 0), { resolution: 16, far: 8 });
    for (let z = 0; z < 6; z += 0.1) {
      for (const [x, y, seen] of [
        [0.9, 1.2, true],
        [1.02, 1.2, false],
        [0, 0.1, true],
        [0, -0.02, false],
      ] as const) {
        place.set([x, y, z]);
        expect(isInView(memory), `${x}, ${y}, ${z}`).toBe(seen);
      }
    }
  });
});
