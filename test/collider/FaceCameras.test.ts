import { Matrix4, Vector3, Vector4 } from 'three';
import { describe, expect, it } from 'vitest';
import { seeded } from '../../e2e/support/axisScenes.js';
import { FaceCameras } from '../../src/collider/FaceCameras.js';
import { faceProjection } from '../../src/cube/faceMatrices.js';
import { texelDirection } from '../../src/cube/texelDirections.js';

describe('the six cameras', () => {
  it('should together be the paper’s matrices (1)-(8)', () => {
    const cameras = new FaceCameras(32, 0.02, 2);
    for (let face = 0; face < 6; face++) {
      const camera = cameras.cameras[face]!;
      const product = new Matrix4().multiplyMatrices(
        camera.projectionMatrix,
        camera.matrixWorldInverse,
      );
      const paper = faceProjection(face, 0.02, 2, new Matrix4());
      product.elements.forEach((entry, i) => expect(entry).toBeCloseTo(paper.elements[i]!, 12));
    }
  });

  it('should draw each texel’s direction onto the texel, wherever they stand (seed 3)', () => {
    const random = seeded(3);
    const n = 16;
    const cameras = new FaceCameras(n, 0.02, 2);
    const point = new Vector4();
    const direction = [0, 0, 0];
    for (let i = 0; i < 5000; i++) {
      const center = new Vector3(random(), random(), random()).multiplyScalar(i % 2 ? 1e6 : 10);
      cameras.moveTo([center]);
      const face = Math.floor(6 * random());
      const x = Math.floor(n * random());
      const y = Math.floor(n * random());
      texelDirection(face, x, y, n, direction);
      const distance = 0.1 + random();
      const camera = cameras.cameras[face]!;
      point.set(
        center.x + distance * direction[0]!,
        center.y + distance * direction[1]!,
        center.z + distance * direction[2]!,
        1,
      );
      point.applyMatrix4(camera.matrixWorldInverse).applyMatrix4(camera.projectionMatrix);
      expect(((point.x / point.w + 1) / 2) * n).toBeCloseTo(x + 0.5, 5);
      expect(((point.y / point.w + 1) / 2) * n).toBeCloseTo(y + 0.5, 5);
      expect(point.w).toBeGreaterThan(0);
    }
  });

  it('should invert its world matrices exactly', () => {
    const cameras = new FaceCameras(8, 0.1, 1);
    cameras.moveTo([new Vector3(1234567.125, -89.5, 0.0625)]);
    for (const camera of [cameras, ...cameras.cameras]) {
      const product = new Matrix4().multiplyMatrices(camera.matrixWorld, camera.matrixWorldInverse);
      expect(product.elements.map((entry) => entry + 0)).toEqual(new Matrix4().elements);
    }
  });

  it('should give every face a tile of its own and a layer of its own', () => {
    const { cameras } = new FaceCameras(8, 0.1, 1);
    const tiles = cameras.map((camera) => camera.viewport!.toArray().join());
    expect(new Set(tiles).size).toBe(6);
    expect(cameras.map((camera) => camera.layers.mask)).toEqual([1, 2, 4, 8, 16, 32]);
  });
});
