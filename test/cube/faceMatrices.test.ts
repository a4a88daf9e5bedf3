import fc from 'fast-check';
import { Matrix4, PerspectiveCamera, Vector3, Vector4 } from 'three';
import { describe, expect, it } from 'vitest';
import { clipPlanes, faceProjection, faceRotation } from '../../src/cube/faceMatrices.js';
import { FACES } from '../../src/cube/faces.js';

// near 1, far 3: A = -(3 + 1)/(3 - 1) = -2 and B = -2·3·1/(3 - 1) = -3, put into the audit's table by hand.
const BY_HAND: Record<string, number[]> = {
  front: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -3, 0, 0, -1, 0],
  back: [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2, -3, 0, 0, 1, 0],
  bottom: [1, 0, 0, 0, 0, 0, -1, 0, 0, -2, 0, -3, 0, -1, 0, 0],
  top: [1, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, -3, 0, 1, 0, 0],
  left: [0, 0, -1, 0, 0, 1, 0, 0, -2, 0, 0, -3, -1, 0, 0, 0],
  right: [0, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0, -3, 1, 0, 0, 0],
};

const rows = (m: Matrix4) => m.clone().transpose().toArray();

describe('faceProjection', () => {
  it.each(FACES.map((face, i) => [face.side, i] as const))(
    'should be the printed matrix, mended, for the %s',
    (side, face) => {
      expect(rows(faceProjection(face, 1, 3, new Matrix4()))).toEqual(BY_HAND[side]);
    },
  );

  it("should be three's 90° camera turned to the face, for any planes (seed 1)", () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 0, max: 5 }),
        fc.double({ min: 1e-4, max: 1, noNaN: true }),
        fc.double({ min: 1.01, max: 1000, noNaN: true }),
        (face, near, ratio) => {
          const camera = new PerspectiveCamera(90, 1, near, near * ratio);
          camera.matrixWorld.copy(faceRotation(face, new Matrix4()));
          camera.matrixWorldInverse.copy(camera.matrixWorld).invert();
          const want = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse);
          const got = faceProjection(face, near, near * ratio, new Matrix4());
          const scale = Math.max(...want.elements.map(Math.abs));
          got.elements.forEach((v, i) =>
            expect(Math.abs(v - want.elements[i]!)).toBeLessThan(1e-12 * scale),
          );
        },
      ),
      { numRuns: 2000, seed: 1 },
    );
  });

  it('should map near to -1 and far to +1 with w the depth, and keep the winding', () => {
    for (let face = 0; face < 6; face++) {
      const projection = faceProjection(face, 0.1, 2, new Matrix4());
      for (const [depth, z] of [
        [0.1, -1],
        [2, 1],
      ] as const) {
        const point = new Vector3(...FACES[face]!.forward).multiplyScalar(depth);
        const clip = new Vector4(point.x, point.y, point.z, 1).applyMatrix4(projection);
        expect(clip.w).toBeCloseTo(depth, 14);
        expect(clip.z / clip.w).toBeCloseTo(z, 12);
      }
      expect(faceRotation(face, new Matrix4()).determinant()).toBe(1);
    }
  });
});

describe('faceRotation', () => {
  it('should have the columns right, up and -forward, of exact 0 and ±1', () => {
    const columns = [new Vector3(), new Vector3(), new Vector3()] as const;
    FACES.forEach((face, i) => {
      const rotation = faceRotation(i, new Matrix4());
      rotation.extractBasis(...columns);
      expect(columns[0].toArray()).toEqual([...face.right]);
      expect(columns[1].toArray()).toEqual([...face.up]);
      expect(
        columns[2]
          .negate()
          .toArray()
          .map((v) => v + 0),
      ).toEqual([...face.forward]);
      expect(rotation.elements.every((v) => Object.is(v, 0) || Math.abs(v) === 1)).toBe(true);
    });
  });
});

describe('clipPlanes', () => {
  it('should lose no direction at rMin, corners included (mend of (12))', () => {
    for (const [rMin, rMax] of [
      [0.25, 0.5],
      [0.001, 0.5],
      [0.49, 0.5],
    ] as const) {
      const { near, far } = clipPlanes(rMin, rMax);
      const cornerDepth = rMin * new Vector3(1, 1, 1).normalize().x;
      expect(near).toBeLessThanOrEqual(cornerDepth * (1 + 1e-15));
      expect(near).toBeGreaterThan(0);
      expect(far).toBe(rMax);
    }
    expect(clipPlanes(0.25, 0.5).near).toBeCloseTo(0.005, 12);
    expect(clipPlanes(0.005, 0.5).near).toBeCloseTo(0.0028867513, 9);
  });
});
