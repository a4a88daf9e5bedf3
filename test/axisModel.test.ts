import { DoubleSide, Mesh, type MeshBasicMaterial, Raycaster, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { judge, modelMaxima } from '../e2e/support/axisModel.js';
import { axisPoses, axisScenes } from '../e2e/support/axisScenes.js';
import { texelDirection } from '../src/cube/texelDirections.js';

const R_MIN = 0.25;
const R_MAX = 0.5;
const N = 8;

describe.each(axisScenes())('the model for the GPU in $name', ({ root, triangles }) => {
  root.traverse((object) => {
    if (object instanceof Mesh) (object.material as MeshBasicMaterial).side = DoubleSide;
  });

  it("should see what three's Raycaster sees, and let itself pass (seed 21)", () => {
    const raycaster = new Raycaster();
    for (const pose of axisPoses(triangles, R_MAX, 4, 21)) {
      const model = modelMaxima(triangles, pose, R_MIN, R_MAX, N);
      const reading = { red: [0, 0, 0, 0, 0, 0], texel: new Array<number>(12).fill(0) };
      const direction: number[] = [];
      for (let i = 0; i < 6 * N * N; i++) {
        const face = Math.floor(i / (N * N));
        texelDirection(face, i % N, Math.floor(i / N) % N, N, direction);
        raycaster.set(pose, new Vector3(...(direction as [number, number, number])));
        const distance = raycaster.intersectObject(root)[0]?.distance ?? Infinity;
        const red = Math.min(1, Math.max(0, 1 - (distance - R_MIN) / (R_MAX - R_MIN)));
        expect(Math.abs(model.red[i]! - red)).toBeLessThan(1e-5);
        if (Math.round(red * 255) / 255 <= reading.red[face]!) continue;
        reading.red[face] = Math.round(red * 255) / 255;
        reading.texel[2 * face] = i % N;
        reading.texel[2 * face + 1] = Math.floor(i / N) % N;
      }
      const verdict = judge(reading, model);
      expect(verdict).toMatchObject({ ok: true, plainFailures: 0, failures: 0 });
      expect(verdict.seen).toBeGreaterThan(0);
    }
  });

  it('should fail a reading that is two steps off, or of another texel (seed 22)', () => {
    const [pose] = axisPoses(triangles, R_MAX, 1, 22);
    const model = modelMaxima(triangles, pose!, R_MIN, R_MAX, N, 1 / 512);
    const face = model.max.indexOf(Math.max(...model.max));
    const first = face * N * N;
    const texels = model.red.slice(first, first + N * N);
    const best = texels.indexOf(Math.max(...texels));
    const worst = texels.indexOf(Math.min(...texels));
    const read = (red: number, winner: number) => {
      const texel = new Array<number>(12).fill(0);
      texel[2 * face] = winner % N;
      texel[2 * face + 1] = Math.floor(winner / N);
      return judge({ red: model.max.map((max, i) => (i === face ? red : max)), texel }, model);
    };
    const failuresElsewhere = read(model.max[face]!, best).plainFailures;
    expect(read(model.max[face]! - 3 / 255, best).plainFailures).toBe(failuresElsewhere + 1);
    expect(read(model.max[face]!, worst).plainFailures).toBe(failuresElsewhere + 1);
    expect(read(model.max[face]! - 60 / 255, best).ok).toBe(false);
  });
});
