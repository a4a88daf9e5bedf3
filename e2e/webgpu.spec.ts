import type surface from './harness/surface.js';
import type { Agreement } from './harness/agreement.js';
import type { AxisReport } from './harness/axis.js';
import type { KindCase, KindReport } from './harness/kinds.js';
import type { SurfaceCase } from './harness/surface.js';
import { KINDS, OUTLINES } from './support/kinds/names.js';
import { quantisedModel } from './support/kinds/quantisedModel.js';
import { writeRow } from './support/solidRows.js';
import { expect, runInPage, testOnOnePage as test } from './support/test.js';
import type { Backend } from './support/rendering.js';

/** As for WebGL. */
const AGREEMENT = 0.997;

const BACKENDS: Backend[] = ['WebGPU', 'fallback'];

for (const backend of BACKENDS) {
  test.describe(`every texel against three’s Raycaster, ${backend}`, () => {
    const cases: [string, SurfaceCase][] = [
      ['as shipped', {}],
      ['a draw as coarse as it is read', { collider: { supersample: 1 } }],
      ['a reversed depth buffer', { renderer: { reversedDepthBuffer: true } }],
      ['a logarithmic depth buffer', { renderer: { logarithmicDepthBuffer: true } }],
      ['1,000 km from the origin', { center: [1e6, 2, 3] }],
      ['faces of 20², whose rows are padded', { collider: { resolution: 20, supersample: 1 } }],
    ];
    for (const [name, options] of cases) {
      test(`should agree with ${name}`, async ({ page }) => {
        const report = await runInPage<Awaited<ReturnType<typeof surface>>>(
          page,
          '/e2e/harness/surface.ts',
          { ...options, backend },
        );
        const share = report.good / report.texels;
        console.log(
          `    ${report.good} of ${report.texels} texels (${(100 * share).toFixed(2)} %) within 1 cm and 0.02; worst of ` +
            `these ${(1e6 * report.worstDistance).toFixed(1)} µm, normal ${report.worstNormal.toFixed(4)}`,
        );
        expect(report.format).toBe('RGBA32F');
        expect(report.reversed).toBe(options.renderer?.reversedDepthBuffer ?? false);
        expect(share).toBeGreaterThanOrEqual(AGREEMENT);
        expect(report.unexplained).toBe(0);
        expect(report.wrongSide).toBe(0);
        expect(report.reads).toBe(1);
      });
    }
  });
}

for (const backend of BACKENDS) {
  for (const kind of KINDS) {
    test(`should be as solid as drawn on ${backend}: ${kind}`, async ({ page }) => {
      const report = await runInPage<KindReport>(page, '/e2e/harness/kinds.ts', {
        name: kind,
        backend,
        glb: kind.includes('GLB') ? await quantisedModel() : undefined,
      } satisfies KindCase);
      const { texels, worst, draws, programs } = report;
      console.log(
        `    ${texels} texels on it, ${report.outlines} outlines, ${(1000 * worst).toFixed(2)} mm`,
      );
      expect(report.wrong).toEqual([]);
      expect(report.strangers).toEqual([]);
      expect(texels).toBeGreaterThan(150);
      expect(report.outlines / report.all).toBeLessThanOrEqual(OUTLINES);
      expect(worst).toBeLessThanOrEqual(0.01);
      writeRow({ kind, group: 'geometry', backend, worst, texels, draws, programs });
    });
  }
}

for (const backend of BACKENDS) {
  test(`should find each face’s highest red as the equations do, ${backend}`, async ({ page }) => {
    for (const [resolution, poses] of [
      [32, 30],
      [8, 4],
      [64, 4],
    ]) {
      const reports = await runInPage<AxisReport[]>(page, '/e2e/harness/axis.ts', {
        poses,
        seed: 3,
        resolution,
        backend,
      });
      for (const { scene, seen, failures, plainFailures } of reports) {
        console.log(
          `    ${resolution}², ${scene}: ${seen} faces saw something, ${plainFailures} off by more than a step`,
        );
        expect(failures).toBe(0);
        expect(seen).toBeGreaterThan(2 * poses!);
      }
    }
  });
}

test('should see what WebGLRenderer sees, within a millimetre', async ({ page }) => {
  const reports = await runInPage<Agreement[]>(page, '/e2e/harness/agreement.ts', [
    'WebGL2',
    ...BACKENDS,
  ]);
  reports.forEach(({ same, seen, distance, normal, strangers }, i) => {
    console.log(
      `    ${BACKENDS[i]}: ${same} of ${seen} texels see the same plane; distances differ by up to ` +
        `${(1e6 * distance).toFixed(1)} µm, normals by ${normal.toFixed(5)}`,
    );
    expect(same / seen).toBeGreaterThan(0.99);
    expect(distance).toBeLessThan(0.001);
    expect(strangers).toBe(0);
  });
});
