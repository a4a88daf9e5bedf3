import type { Page } from '@playwright/test';
import type { CubeColliderOptions, TexelFormat } from 'three-cube-collider';
import type encoding from './harness/encoding.js';
import type { IdCases } from './harness/ids.js';
import { expect, runInPage, testOnOnePage as test } from './support/test.js';

const FORMATS: TexelFormat[] = ['RGBA32F', 'RGBA16F', 'RGBA8'];

/** Part of the texels that must agree with three's Raycaster: the rest are silhouettes. */
const AGREEMENT = 0.995;

/**
 * Largest errors of distance (of a reach of 2.5 m) and normal: half a step of either octahedral coordinate moves a unit
 * normal by at most √18 / steps.
 */
const PRECISION = {
  RGBA32F: { distance: 1e-7, normal: 4.25 / 4094 },
  RGBA16F: { distance: 1e-6, normal: 4.25 / 2046 },
  RGBA8: { distance: 5e-5, normal: 4.25 / 254 },
} as const;

function run<Name extends keyof IdCases>(
  page: Page,
  name: Name,
  args: CubeColliderOptions,
): Promise<Awaited<ReturnType<IdCases[Name]>>> {
  return runInPage(page, '/e2e/harness/ids.ts', { name, args });
}

for (const format of FORMATS) {
  test(`should bring surfaces, objects and instances through ${format} (seed 11)`, async ({
    page,
  }) => {
    const report = await runInPage<ReturnType<typeof encoding>>(page, '/e2e/harness/encoding.ts', {
      format,
      seed: 11,
    });
    expect(report.surfaces).toBeGreaterThan(1000);
    expect(report.misses).toBeGreaterThan(100);
    expect(report.wrong).toEqual([]);
    expect(report.distance).toBeLessThanOrEqual(PRECISION[format].distance);
    expect(report.normal).toBeLessThanOrEqual(PRECISION[format].normal);
    expect(report.axisNormal).toBe(0);
  });

  for (const readback of ['sync', 'async'] as const) {
    const tag = readback === 'async' ? '@three ' : '';
    test(`${tag}should tell object and instance as three’s Raycaster does: ${format}, ${readback}`, async ({
      page,
    }) => {
      const report = await run(page, 'texels', { format, readback });
      const share = report.agreed / report.texels;
      console.log(`    ${format}, ${readback}: ${(100 * share).toFixed(2)} % of texels agree`);
      expect(report.format).toBe(format);
      expect(share).toBeGreaterThanOrEqual(AGREEMENT);
      expect(report.objects).toBe(4);
      expect(report.instances.length).toBeGreaterThan(8);
    });
  }

  test(`should tell 70,000 instances of a batch apart: ${format}`, async ({ page }) => {
    const { seen, drawCalls } = await run(page, 'limits', { format });
    expect(seen).toEqual([
      ['batch', 69_999],
      ['batch', 4096],
    ]);
    expect(drawCalls).toBe(6);
  });

  test(`should give each field the objects of its own draw: ${format}`, async ({ page }) => {
    const report = await run(page, 'inFlight', { format });
    expect(report.agreed / report.texels).toBeGreaterThanOrEqual(AGREEMENT);
    expect(report).toMatchObject({ drawnAt: 1.1, hasFloor: false, keptWhole: true, objects: 3 });
  });

  test(`should see as far as it is told, from the next draw on: ${format}`, async ({ page }) => {
    const { seen, untilDrawn, autoFar } = await run(page, 'reach', { format });
    expect(autoFar).toBe(true);
    expect(untilDrawn).toBe(1.8);
    expect(seen.map(([far]) => far)).toEqual([1.8, 4, 2.5]);
    const [near, all, part] = seen.map(([, share]) => share);
    expect(near).toBe(0);
    expect(all).toBe(1);
    // Of each wall a circle 1.5 m about, on a face 4 m wide.
    expect(part).toBeCloseTo((Math.PI * 1.5 ** 2) / 16, 1);
    for (const [, , wall] of seen.slice(1)) expect(Math.abs(wall - 2)).toBeLessThan(0.005);
  });
}
