import type { Page } from '@playwright/test';
import type thin from './harness/thin.js';
import type thinStop from './harness/thinStop.js';
import { tries } from '../test/support/soak.js';
import { expect, runInPage, testOnOnePage as test } from './support/test.js';

type Case = Parameters<typeof thin>[0];

async function see(page: Page, options: Case) {
  const report = await runInPage<ReturnType<typeof thin>>(page, '/e2e/harness/thin.ts', options);
  console.log(
    `    ${report.format}: ${report.missed.length} of ${options.count} missed; of ${report.texels} texels on them ` +
      `${report.beside} not within 1 mm of what their own ray meets, ${report.off} of these off the thing by more than ` +
      `2 mm; worst of the others ${(1e6 * report.worst).toFixed(0)} µm`,
  );
  return report;
}

test.describe('thin things, 32 texels a face edge, anywhere around the centre', () => {
  const cases: [string, Case][] = [
    [
      '@three a 10 mm pole at 0.1 to 0.6 m',
      { kind: 'pole', count: tries(200, 600), seed: 1, collider: { supersample: 4 } },
    ],
    [
      'a 30 mm rail at 0.2 to 1.6 m',
      { kind: 'rail', count: tries(200, 600), seed: 2, collider: { supersample: 4 } },
    ],
    [
      'a 10 mm pole in RGBA16F',
      { kind: 'pole', count: 50, seed: 3, collider: { supersample: 4, format: 'RGBA16F' } },
    ],
    [
      'a 10 mm pole in RGBA8',
      { kind: 'pole', count: 50, seed: 4, collider: { supersample: 4, format: 'RGBA8' } },
    ],
    [
      'a 20 mm pole drawn twice as fine',
      { kind: 'pole', width: 0.02, count: 100, seed: 5, collider: { supersample: 2 } },
    ],
  ];
  for (const [name, options] of cases) {
    test(`should always be seen where they are: ${name}`, async ({ page }) => {
      const report = await see(page, options);
      expect(report.format).toBe(options.collider?.format ?? 'RGBA32F');
      expect(report.missed).toEqual([]);
      expect(report.texels).toBeGreaterThan(10 * options.count);
      expect(report.strangers).toBe(0);
      expect(report.beside / report.texels).toBeLessThan(0.015);
      expect(report.off / report.texels).toBeLessThan(0.01);
    });
  }

  test('should be missed now and then, drawn no finer: the test above can fail', async ({
    page,
  }) => {
    const poles = await see(page, {
      kind: 'pole',
      count: 150,
      seed: 1,
      collider: { supersample: 1 },
    });
    expect(poles.missed.length).toBeGreaterThan(4);
    const rails = await see(page, {
      kind: 'rail',
      count: 150,
      seed: 2,
      collider: { supersample: 1 },
    });
    expect(rails.missed.length).toBeGreaterThan(4);
  });
});

test.describe('walking at a thin thing, from any side, at 1 to 6 m/s', () => {
  /** The deepest that each walk got into it, metres, largest first; below 0 a gap. */
  async function walkAt(page: Page, options: Parameters<typeof thinStop>[0]): Promise<number[]> {
    const report = await runInPage<ReturnType<typeof thinStop>>(
      page,
      '/e2e/harness/thinStop.ts',
      options,
    );
    expect(report.through).toEqual([]);
    const depths = report.penetrations.sort((a, b) => b - a);
    expect(depths).toHaveLength(options.count);
    console.log(
      `    deepest ${(1000 * depths[0]!).toFixed(1)} mm, median ${(1000 * depths[depths.length >> 1]!).toFixed(1)} mm`,
    );
    return depths;
  }

  for (const kind of ['pole', 'rail'] as const) {
    test(`should stop at a ${kind}, drawn four times finer`, async ({ page }) => {
      const depths = await walkAt(page, {
        kind,
        count: tries(20, 60),
        seed: 3,
        collider: { supersample: 4 },
      });
      expect(depths[0]).toBeLessThan(0);
      // Stopped at it, not before it: the skin, and what a slanted walk leaves.
      expect(depths[depths.length >> 1]).toBeGreaterThan(-0.03);
    });
  }

  test('should enter a pole now and then, drawn no finer: the test above can fail', async ({
    page,
  }) => {
    const depths = await walkAt(page, {
      kind: 'pole',
      count: 40,
      seed: 3,
      collider: { supersample: 1 },
    });
    expect(depths[0]).toBeGreaterThan(0.02);
  });
});
