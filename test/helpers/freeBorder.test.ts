import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { SurfaceField, type SurfaceSampler } from 'three-cube-collider';
import { cubeQuads, freeBorder } from '../../src/helpers/freeBorder.js';

const center = new Vector3();

function borderOf(sampler: SurfaceSampler, resolution = 16, far = 3) {
  const field = SurfaceField.from(sampler, { resolution, far, center });
  const room = cubeQuads(resolution).length;
  const border = {
    triangles: new Uint32Array(1.5 * room),
    lines: new Uint32Array(room),
    triangleEnd: 0,
    lineEnd: 0,
  };
  freeBorder(field, border);
  return { field, triangles: [...border.triangles.subarray(0, border.triangleEnd)] };
}

/** The nearest of the planes x = ±half and so on: a room. */
const room =
  (half: number): SurfaceSampler =>
  (_, direction) => {
    const sizes = direction.map(Math.abs);
    const axis = sizes.indexOf(Math.max(...sizes));
    const normal: [number, number, number] = [0, 0, 0];
    normal[axis] = -Math.sign(direction[axis]!);
    return { distance: half / sizes[axis]!, normal };
  };

const floor: SurfaceSampler = (_, [, y]) =>
  y < 0 ? { distance: 1 / -y, normal: [0, 1, 0] } : null;

describe('the quads around a cubemap', () => {
  it.each([4, 7, 32])('should close it, at %d texels an edge', (n) => {
    const quads = cubeQuads(n);
    const uses = new Map<string, number>();
    for (let q = 0; q < quads.length; q += 4) {
      const corners = [...new Set(quads.subarray(q, q + 4))];
      corners.forEach((a, i) => {
        const b = corners[(i + 1) % corners.length]!;
        const edge = a < b ? `${a} ${b}` : `${b} ${a}`;
        uses.set(edge, (uses.get(edge) ?? 0) + 1);
      });
    }
    expect([...new Set(uses.values())]).toEqual([2]);
    // Euler: corners - edges + faces of a ball.
    expect(6 * n * n - uses.size + quads.length / 4).toBe(2);
  });
});

describe('the border of what was seen to be free', () => {
  it('should be nowhere in a closed room', () => {
    expect(borderOf(room(1)).triangles).toEqual([]);
  });

  it('should be all around where nothing is within reach', () => {
    const quads = cubeQuads(16).length / 4;
    expect(borderOf(room(4)).triangles).toHaveLength(3 * (2 * quads - 8));
  });

  it('should hang over a floor, but not lie on it', () => {
    const { field, triangles } = borderOf(floor);
    let [above, on] = [0, 0];
    for (let t = 0; t < triangles.length; t += 3) {
      const corners = triangles.slice(t, t + 3);
      const seen = corners.filter((texel) => field.distance[texel]! < Infinity);
      if (seen.length === 0) above++;
      if (seen.length === 3) on++;
    }
    expect(above).toBeGreaterThan(500);
    // Quads that only touch what is seen.
    expect(on).toBeLessThan(40);
  });

  it('should hang behind what hides something', () => {
    // Before a wall at 2 m stands a plate of 0.6 m at 1 m.
    const behindPlate: SurfaceSampler = (at, direction) => {
      const [x, y, z] = direction;
      const plate = z < 0 && Math.abs(x / z) < 0.3 && Math.abs(y / z) < 0.3;
      return plate ? { distance: 1 / -z, normal: [0, 0, 1] } : room(1.6)(at, direction);
    };
    const { field, triangles } = borderOf(behindPlate, 32);
    expect(triangles.length).toBeGreaterThan(0);
    for (let t = 0; t < triangles.length; t += 3) {
      for (const texel of triangles.slice(t, t + 3)) {
        const [x, y, z] = [0, 1, 2].map((i) => field.direction[3 * texel + i]!);
        expect(z!).toBeLessThan(0);
        // Within two texels of the plate's edge.
        expect(Math.max(Math.abs(x! / z!), Math.abs(y! / z!))).toBeGreaterThan(0.3 - 2 / 16);
        expect(Math.max(Math.abs(x! / z!), Math.abs(y! / z!))).toBeLessThan(0.3 + 2 / 16);
      }
    }
  });
});
