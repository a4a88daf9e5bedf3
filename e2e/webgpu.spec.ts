import type surface from './harness/surface.js';
import type { AxisReport } from './harness/axis.js';
import type { KindCase, KindReport } from './harness/kinds.js';
import type { SurfaceCase } from './harness/surface.js';
import { KINDS, OUTLINES } from './support/kinds/names.js';
import { quantisedModel } from './support/kinds/quantisedModel.js';
import { callInPage, expect, openPage, runInPage, test } from './support/test.js';
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
  test(`should be as solid as drawn: every kind of object, ${backend}`, async ({ page }) => {
    await openPage(page);
    for (const name of KINDS) {
      await test.step(name, async () => {
        const report = await callInPage<KindReport>(page, '/e2e/harness/kinds.ts', {
          name,
          backend,
          glb: name.includes('GLB') ? await quantisedModel() : undefined,
        } satisfies KindCase);
        const millimetres = (1000 * report.worst).toFixed(2);
        console.log(
          `    ${name}: ${report.texels} texels on it, ${report.outlines} outlines, ${millimetres} mm, ` +
            `${report.draws} draws, ${report.programs} programs`,
        );
        expect.soft(report.wrong, name).toEqual([]);
        expect.soft(report.strangers, name).toEqual([]);
        expect.soft(report.texels, name).toBeGreaterThan(150);
        expect.soft(report.outlines / report.all, name).toBeLessThanOrEqual(OUTLINES);
        expect.soft(report.worst, name).toBeLessThanOrEqual(0.01);
      });
    }
  });
}

for (const backend of BACKENDS) {
  test(`should find each face’s highest red as the equations do, ${backend}`, async ({ page }) => {
    await openPage(page);
    for (const [resolution, poses] of [
      [32, 30],
      [8, 4],
      [64, 4],
    ]) {
      const reports = await callInPage<AxisReport[]>(page, '/e2e/harness/axis.ts', {
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
