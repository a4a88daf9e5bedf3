import type surface from './harness/surface.js';
import type { SurfaceCase } from './harness/surface.js';
import { expect, runInPage, test } from './support/test.js';
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
