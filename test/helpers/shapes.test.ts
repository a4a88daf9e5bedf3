import { Matrix4, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { SurfaceField } from 'three-cube-collider';
import { capsuleHull, capsuleLines } from '../../src/helpers/capsuleShape.js';
import { placeAlong } from '../../src/helpers/placeAlong.js';
import { texelDisc } from '../../src/helpers/texelDisc.js';
import { viridis } from '../../src/helpers/viridis.js';

describe('a texel’s disc', () => {
  // A room of 2 × 2 × 2.4 m, seen from a place off its middle.
  const [low, high] = [
    [-0.7, -1.1, -1],
    [1.3, 1.3, 1],
  ];
  const field = SurfaceField.from(
    (_, direction) => {
      let best = Infinity;
      let normal: [number, number, number] = [0, 0, 0];
      direction.forEach((part, axis) => {
        const distance = (part > 0 ? high : low)[axis]! / part;
        if (distance >= best) return;
        best = distance;
        normal = [0, 0, 0];
        normal[axis] = -Math.sign(part);
      });
      return { distance: best, normal };
    },
    { resolution: 32, far: 4, center: new Vector3(5, 6, 7) },
  );
  const matrix = new Matrix4();
  const disc = (texel: number) => {
    texelDisc(field, texel, matrix.elements, 0);
    return matrix;
  };

  it('should lie on the surface, facing as it does', () => {
    const [x, y, z] = [new Vector3(), new Vector3(), new Vector3()];
    const point = new Vector3();
    for (let texel = 0; texel < field.count; texel++) {
      disc(texel).extractBasis(x, y, z);
      const normal = new Vector3().fromArray(field.normal, 3 * texel);
      expect(z.distanceTo(normal)).toBeLessThan(1e-6);
      expect(Math.abs(x.dot(y)) + Math.abs(x.dot(z)) + Math.abs(y.dot(z))).toBeLessThan(1e-6);
      // A mirrored one would show its back.
      expect(x.clone().cross(y).dot(z)).toBeGreaterThan(0);
      field.point(texel, point).sub(field.center);
      const off = new Vector3().setFromMatrixPosition(matrix).sub(point);
      expect(off.dot(normal)).toBeGreaterThan(0);
      expect(off.length()).toBeLessThan(0.005);
    }
  });

  it('should be as large as its texel: together they cover the room', () => {
    let area = 0;
    for (let texel = 0; texel < field.count; texel++) {
      const { elements: e } = disc(texel);
      // Of the squares around them, without the gaps.
      area += (4 * Math.hypot(e[0]!, e[1]!, e[2]!) * Math.hypot(e[4]!, e[5]!, e[6]!)) / 0.86 ** 2;
    }
    const room = 2 * (2 * 2 + 2 * 2.4 + 2 * 2.4);
    expect(area / room).toBeGreaterThan(0.93);
    expect(area / room).toBeLessThan(1.07);
  });

  it('should have no size where nothing was seen', () => {
    const empty = SurfaceField.from(() => null, { resolution: 4, far: 1, center: new Vector3() });
    texelDisc(empty, 0, matrix.elements, 0);
    expect(matrix.elements.every((element) => element === 0)).toBe(true);
  });
});

describe('an arrow', () => {
  it('should point along any normal, unmirrored', () => {
    const matrix = new Matrix4();
    const origin = new Vector3(100, 0, -3);
    const normals = [0, 1, 2, 3, 4, 5, 6].map((i) => new Vector3().randomDirection().setX(i - 3));
    normals.push(new Vector3(0, 0, 1), new Vector3(0, 0, -1), new Vector3(0, 1, 0));
    for (const normal of normals) {
      normal.normalize();
      const point = origin.clone().addScaledVector(normal, 2);
      placeAlong(matrix.elements, 0, point, origin, normal, 0.5);
      const [at, turn, size] = [new Vector3(), new Quaternion(), new Vector3()];
      matrix.decompose(at, turn, size);
      expect(at.distanceTo(normal.clone().multiplyScalar(2))).toBeLessThan(1e-9);
      expect(size.distanceTo(new Vector3(0.5, 0.5, 0.5))).toBeLessThan(1e-9);
      expect(new Vector3(0, 1, 0).applyQuaternion(turn).distanceTo(normal)).toBeLessThan(1e-9);
      expect(matrix.determinant()).toBeCloseTo(0.125, 9);
    }
  });
});

describe('a capsule', () => {
  it.each([
    ['lines', capsuleLines()],
    ['hull', capsuleHull()],
  ])('should have all its %s on its surface, at any size', (_, shape) => {
    for (const [radius, low, high] of [
      [0.35, 0, 1.8],
      [0.37, -0.02, 1.12],
      [0.5, 0, 1],
    ] as const) {
      shape.fit(radius, low, high);
      const position = shape.geometry.getAttribute('position');
      const [point, axis] = [new Vector3(), new Vector3()];
      let [lowest, highest] = [Infinity, -Infinity];
      for (let i = 0; i < position.count; i++) {
        point.fromBufferAttribute(position, i);
        axis.set(0, Math.min(high - radius, Math.max(low + radius, point.y)), 0);
        expect(point.distanceTo(axis)).toBeCloseTo(radius, 5);
        lowest = Math.min(lowest, point.y);
        highest = Math.max(highest, point.y);
      }
      expect(lowest).toBeCloseTo(low, 5);
      expect(highest).toBeCloseTo(high, 5);
    }
  });
});

describe('viridis', () => {
  it.each([
    [0, [68, 1, 84]],
    [0.5, [33, 145, 140]],
    [1, [253, 231, 37]],
  ])('should be matplotlib’s at %d', (t, color) => {
    const found = ([0, 1, 2] as const).map((channel) => 255 * viridis(t, channel));
    found.forEach((value, i) => expect(Math.abs(value - color[i]!)).toBeLessThan(5));
  });
});
