import type { Page } from '@playwright/test';
import type { CubeColliderOptions } from 'three-cube-collider';
import type { RobustCases } from './harness/robust.js';
import { expect, runInPage, test, testOnOnePage } from './support/test.js';

function run<Name extends keyof RobustCases>(
  page: Page,
  name: Name,
  args?: Parameters<RobustCases[Name]>[0],
): Promise<Awaited<ReturnType<RobustCases[Name]>>> {
  return runInPage(page, '/e2e/harness/robust.ts', { name, args });
}

test.describe('contexts', () => {
  for (const options of [{}, { output: 'axis' }] satisfies CubeColliderOptions[]) {
    test(`should be free to go once all is disposed of: ${JSON.stringify(options)}`, async ({
      page,
    }) => {
      await run(page, 'makeContexts', { count: 4, options });
      const session = await page.context().newCDPSession(page);
      const alive = async () => {
        await session.send('HeapProfiler.collectGarbage');
        return page.evaluate(
          () =>
            (window as unknown as { canvases: WeakRef<object>[] }).canvases.filter((canvas) =>
              canvas.deref(),
            ).length,
        );
      };
      await expect.poll(alive, { timeout: 20_000 }).toBe(0);
    });
  }
});

test.describe('with an error of the user’s pending', () => {
  test.use({ allowedMessages: [/INVALID_ENUM: enable/] });

  test('should keep the best format, and the error for the user', async ({ page }) => {
    const report = await run(page, 'pendingError');
    expect(report.format).toBe('RGBA32F');
    expect(report.error).toBe(report.invalid);
  });
});

test.describe('on a page whose GPU never drains', () => {
  testOnOnePage('should read in time what it walks toward, once a reach', async ({ page }) => {
    const report = await run(page, 'neverDrained', { stride: 0.05, updates: 90 });
    expect(report.farthest).toBeLessThan(0.45 + 0.001);
    // 2.95 m at 0.45 m a read, after half a second before the first.
    expect(report.forced).toBeGreaterThanOrEqual(6);
    expect(report.forced).toBeLessThanOrEqual(8);
    expect(report.reads).toBe(report.forced);
  });

  testOnOnePage(
    'should not be waited for on the way, asked to be patient: only the age counts',
    async ({ page }) => {
      const report = await run(page, 'neverDrained', { stride: 0.2, updates: 120, patient: true });
      expect(report.farthest).toBeGreaterThan(1);
      expect(report.oldest).toBeLessThan(200 + 16);
      expect(report.forced).toBeGreaterThanOrEqual(6);
      expect(report.forced).toBeLessThanOrEqual(8);
    },
  );

  testOnOnePage('should see what changes beside one that stands', async ({ page }) => {
    const report = await run(page, 'neverDrained', { stride: 0, updates: 120 });
    expect(report.oldest).toBeLessThan(200 + 16);
    // 1.4 s at 0.2 s a read, after half a second before the first.
    expect(report.forced).toBeGreaterThanOrEqual(6);
    expect(report.forced).toBeLessThanOrEqual(8);
  });
});

testOnOnePage(
  'a character should run up steps where no read comes by itself, and never stand for long',
  async ({ page }) => {
    const { x, y, longest } = await run(page, 'stairsNeverDrained', undefined);
    console.log(`    ${x.toFixed(2)} m far, ${y.toFixed(2)} m up, stood ${longest} frames at most`);
    expect(y).toBeGreaterThan(0.48);
    // 0.5 s for a read, and a look from where it stood.
    expect(longest).toBeLessThanOrEqual(8);
  },
);

testOnOnePage('should tell fronts from backs, by either rule of sides', async ({ page }) => {
  expect(await run(page, 'sides')).toEqual({
    'both FrontSide inside': 'back at 1.0',
    'both FrontSide outside': 'front at 3.0',
    'both BackSide inside': 'front at 1.0',
    'both BackSide outside': 'back at 3.0',
    'both DoubleSide inside': 'front at 1.0',
    'both DoubleSide outside': 'front at 3.0',
    'drawn FrontSide inside': 'nothing',
    'drawn FrontSide outside': 'front at 3.0',
    'drawn BackSide inside': 'front at 1.0',
    'drawn BackSide outside': 'front at 5.0',
    'drawn DoubleSide inside': 'front at 1.0',
    'drawn DoubleSide outside': 'front at 3.0',
  });
});

testOnOnePage(
  'should pass through glass, hidden and missing groups of a mesh alone',
  async ({ page }) => {
    expect(await run(page, 'groups')).toEqual([true, false, false, true, false, true]);
  },
);

testOnOnePage('@three should survive being disposed of while it compiles', async ({ page }) => {
  expect(await run(page, 'disposeDuringCompile')).toBe(true);
});

testOnOnePage(
  'should warn once of a wrong renderer and of a filter that throws, and stay solid',
  async ({ page }) => {
    const { warnings, seen } = await run(page, 'misuse');
    expect(warnings).toHaveLength(2);
    expect(warnings[0]).toMatch(/^CubeCollider: .*WebGLRenderer/);
    expect(warnings[1]).toMatch(/^CubeCollider: "filter" threw SyntaxError/);
    expect(seen).toBeCloseTo(2, 2);
  },
);

testOnOnePage(
  'should warn of a format that cannot be drawn, and take one that can',
  async ({ page }) => {
    const { warnings, format, seen } = await run(page, 'forcedFormat');
    expect(warnings).toEqual([
      expect.stringMatching(/^CubeCollider: "format" RGBA32F .* RGBA8 is taken/),
    ]);
    expect(format).toBe('RGBA8');
    expect(seen).toBeCloseTo(2, 2);
  },
);

testOnOnePage(
  'should wait for no read that is asked for asynchronously, however far apart',
  async ({ page }) => {
    expect(await run(page, 'askedFarApart')).toEqual({ errors: [0, 0, 0, 0], forced: 0 });
  },
);

testOnOnePage('should lose no read to a bad call', async ({ page }) => {
  expect(await run(page, 'badCallBetween')).toEqual({ bad: null, good: true, field: true });
});

testOnOnePage('should say why a character can never move', async ({ page }) => {
  for (const count of await run(page, 'neverReady')) expect(count).toBe(1);
});

testOnOnePage('should read the paper’s maxima late as it reads them at once', async ({ page }) => {
  const report = await run(page, 'axisLate');
  expect(report.sync).toHaveLength(5);
  expect(new Set(report.sync.map((each) => JSON.stringify(each))).size).toBe(5);
  expect(report.async).toEqual(report.sync);
});
