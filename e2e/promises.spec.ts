import type { Page } from '@playwright/test';
import type { CubeColliderOptions } from 'three-cube-collider';
import type { PromiseCases } from './harness/promises.js';
import { expect, runInPage, testOnOnePage as test } from './support/test.js';

function run<Name extends keyof PromiseCases>(
  page: Page,
  name: Name,
  args?: Parameters<PromiseCases[Name]>[0],
): Promise<Awaited<ReturnType<PromiseCases[Name]>>> {
  return runInPage(page, '/e2e/harness/promises.ts', { name, args });
}

test('should obey filter, exclusion and layers in what it draws', async ({ page }) => {
  expect(await run(page, 'rules')).toEqual({
    plain: 1,
    filtered: 2,
    excluded: 2,
    included: 1,
    'on another layer': 2,
    'on a layer of the collider’s': 1,
  });
});

test('@three should see meshes where instances, batches, bones and morphs put them', async ({
  page,
}) => {
  expect(await run(page, 'displacements')).toEqual({
    instanced: 1,
    batched: 1,
    skinned: 1,
    morphed: 1,
  });
});

test('should see nothing beyond its reach, in corners too', async ({ page }) => {
  const { farthest, wrong } = await run(page, 'reach');
  expect(wrong).toBe(0);
  expect(farthest).toBeLessThanOrEqual(2.5);
  expect(farthest).toBeGreaterThan(2.4);
});

test('should leave XR, a cube target’s face and a scissor test as its first update found them', async ({
  page,
}) => {
  expect(await run(page, 'firstUpdate')).toEqual([]);
});

test('should clear what it saw last, whatever masks the user left closed', async ({ page }) => {
  expect(await run(page, 'masks')).toEqual([2, null]);
});

test('should keep the newest field whole while the next is written', async ({ page }) => {
  expect(await run(page, 'held')).toEqual({ whole: true, next: 1.5 });
});

test('should give the newest of two reads, and never leave a promise hanging', async ({ page }) => {
  expect(await run(page, 'inFlight')).toEqual({
    skipped: [1, 1],
    newest: 0.1,
    asked: 0.5,
    lost: [null, null],
  });
});

test('should give a read that is asked for although the GPU never drains', async ({ page }) => {
  expect(await run(page, 'urgent')).toBe(true);
});

test('should have every program once compiled, and not say so before', async ({ page }) => {
  for (const options of [{}, { output: 'axis' }] satisfies CubeColliderOptions[]) {
    const report = await run(page, 'compile', options);
    expect(report).toMatchObject({ waits: true, made: 0 });
    expect(report.before).toBeGreaterThan(1);
  }
});

test('should push straight back from walls met head-on, where many texels are as near', async ({
  page,
}) => {
  expect(await run(page, 'headOn')).toBe(0.5);
});

test('should move to another renderer and back', async ({ page }) => {
  expect(await run(page, 'renderers')).toEqual([1, 2, 1, 2]);
});

for (const [options, buffers] of [
  // A pack buffer a read (two with ids of their own), and the triangle of the pass that keeps the nearest.
  [{}, 3],
  [{ supersample: 1 }, 2],
  [{ format: 'RGBA8' }, 5],
] satisfies [CubeColliderOptions, number][]) {
  test(`should leave no listener, buffer, fence or scenery behind: ${JSON.stringify(options)}`, async ({
    page,
  }) => {
    const { during, after } = await run(page, 'leftovers', options);
    expect(during).toMatchObject({ listeners: 1, buffers });
    expect(during.fences).toBeGreaterThan(0);
    expect(after).toEqual({ listeners: 0, buffers: 0, fences: 0 });
    const session = await page.context().newCDPSession(page);
    const held = async () => {
      await session.send('HeapProfiler.collectGarbage');
      return page.evaluate(
        () => (window as unknown as { held: WeakRef<object> }).held.deref() !== undefined,
      );
    };
    await expect.poll(held, { timeout: 10_000 }).toBe(false);
  });
}
