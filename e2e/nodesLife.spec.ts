import type { Page } from '@playwright/test';
import type { LifeCases } from './harness/nodesLife.js';
import type { Backend } from './support/rendering.js';
import { expect, runInPage, test } from './support/test.js';

const BACKENDS: Backend[] = ['WebGPU', 'fallback'];

type Seen<Name extends keyof LifeCases> = Awaited<ReturnType<LifeCases[Name]>> & {
  warnings: string[];
};

function run<Name extends keyof LifeCases>(
  page: Page,
  name: Name,
  args: Parameters<LifeCases[Name]>[0],
): Promise<Seen<Name>> {
  return runInPage(page, '/e2e/harness/nodesLife.ts', { name, args });
}

for (const backend of BACKENDS) {
  test(`should give back all that it took, twenty times, ${backend}`, async ({ page }) => {
    const { before, during, first, last, reads, skins, built, builtLate, warnings } = await run(
      page,
      'rounds',
      backend,
    );
    console.log(`    ${JSON.stringify({ before, during, last })}`);
    expect(skins).toBe(1);
    // Nothing is left to build once compiled.
    expect(built).toBeGreaterThan(0);
    expect(builtLate).toBe(0);
    expect(reads).toBeGreaterThanOrEqual(20);
    expect(during.renderTargets - before.renderTargets).toBe(2);
    expect(during.programs).toBeGreaterThan(before.programs);
    for (const name of ['textures', 'renderTargets', 'programs', 'uniformBuffers'] as const) {
      expect(last[name], name).toBe(before[name]);
    }
    // The user's geometries stay.
    expect(last).toEqual(first);
    expect(warnings).toEqual([]);
  });

  test(`should hold until the renderer is initialised, and then go, ${backend}`, async ({
    page,
  }) => {
    const { held, walked, warnings } = await run(page, 'early', backend);
    expect(held).toBe(true);
    expect(walked).toBeGreaterThan(0.1);
    expect(warnings).toEqual([]);
  });

  test.describe(`without its device, ${backend}`, () => {
    test.use({ allowedMessages: [[/Device Lost/, /CONTEXT_LOST/], { scope: 'test' }] });

    for (const how of ['told', 'gone'] as const) {
      test(`should hold, warn once, and go on with a new renderer: ${how}`, async ({ page }) => {
        const seen = await run(page, 'loss', { backend, how });
        console.log(`    ${JSON.stringify(seen)}`);
        expect(seen.began).toBeGreaterThan(0.1);
        expect(seen.still).toBe(true);
        expect(seen.pending).toBeNull();
        expect(seen.resumed).toBeLessThan(-0.1);
        expect(seen.reads).toBeGreaterThan(0);
        expect(seen.foot).toBeCloseTo(-1, 1);
        expect(seen.warnings).toEqual([
          expect.stringMatching(/^CubeCollider: the renderer has lost its device/),
        ]);
      });
    }
  });
}
