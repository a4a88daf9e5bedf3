import type { CubeColliderOptions } from 'three-cube-collider';
import type contextLoss from './harness/contextLoss.js';
import type clipping from './harness/clipping.js';
import type fallback from './harness/fallback.js';
import type lifecycle from './harness/lifecycle.js';
import type onThePlane from './harness/onThePlane.js';
import type readbacks from './harness/readbacks.js';
import type surface from './harness/surface.js';
import type untouched from './harness/untouched.js';
import { expect, runInPage, test, testOnOnePage } from './support/test.js';

/** Parts of the texels that must agree with three's Raycaster: the rest are silhouettes. */
const AGREEMENT = 0.997;

test.describe('every texel against three’s Raycaster (32² faces, centre inside a box)', () => {
  const cases: [string, Parameters<typeof surface>[0]][] = [
    ['@three RGBA32F, read asynchronously', { collider: { format: 'RGBA32F' } }],
    ['RGBA32F, read synchronously', { collider: { format: 'RGBA32F', readback: 'sync' } }],
    ['@three RGBA16F', { collider: { format: 'RGBA16F' } }],
    ['@three RGBA8', { collider: { format: 'RGBA8' } }],
    ['@three a draw four times finer', { collider: { supersample: 4 } }],
    ['@three a draw twice as fine, RGBA16F', { collider: { supersample: 2, format: 'RGBA16F' } }],
    ['a draw four times finer, RGBA8', { collider: { supersample: 4, format: 'RGBA8' } }],
    ['@three a reversed depth buffer', { renderer: { reversedDepthBuffer: true } }],
    ['@three a logarithmic depth buffer', { renderer: { logarithmicDepthBuffer: true } }],
    ['1,000 km from the origin', { center: [1e6, 2, 3] }],
    [
      '1,118 km from the origin, aslant, RGBA8',
      { center: [6e5, -5e5, 8e5], collider: { format: 'RGBA8' } },
    ],
  ];
  for (const [name, options] of cases) {
    testOnOnePage(`should agree with ${name}`, async ({ page }) => {
      const report = await runInPage<Awaited<ReturnType<typeof surface>>>(
        page,
        '/e2e/harness/surface.ts',
        options,
      );
      const share = report.good / report.texels;
      console.log(
        `    ${report.format}: ${report.good} of ${report.texels} texels (${(100 * share).toFixed(2)} %) within ` +
          `1 cm and 0.02; worst of these ${(1e6 * report.worstDistance).toFixed(1)} µm, normal ${report.worstNormal.toFixed(4)}; ` +
          `${report.unexplained} of the rest not at a silhouette`,
      );
      expect(report.format).toBe(options.collider?.format ?? 'RGBA32F');
      expect(report.reversed).toBe(options.renderer?.reversedDepthBuffer ?? false);
      expect(share).toBeGreaterThanOrEqual(AGREEMENT);
      expect(report.unexplained).toBe(0);
      expect(report.wrongSide).toBe(0);
      expect(report.reads).toBe(1);
    });
  }
});

test.describe('texel formats', () => {
  const cases: [string, string[], string][] = [
    ['RGBA32F where floats can be drawn', [], 'RGBA32F'],
    ['RGBA16F where only half floats can', ['EXT_color_buffer_float'], 'RGBA16F'],
    ['RGBA8 where neither can', ['EXT_color_buffer_float', 'EXT_color_buffer_half_float'], 'RGBA8'],
  ];
  for (const [name, missing, format] of cases) {
    test(`should take ${name}`, async ({ page }) => {
      const report = await runInPage<Awaited<ReturnType<typeof fallback>>>(
        page,
        '/e2e/harness/fallback.ts',
        missing,
      );
      expect(report).toEqual({ format, seen: report.texels, texels: 6144 });
    });
  }
});

test.describe('the user’s frame', () => {
  const cases: [string, CubeColliderOptions][] = [
    ['@three an asynchronous surface probe', {}],
    ['a synchronous surface probe in bytes', { readback: 'sync', format: 'RGBA8' }],
    ['@three a surface probe drawn four times finer', { supersample: 4 }],
    ['@three a probe of the paper’s mode', { output: 'axis' }],
  ];
  for (const [name, options] of cases) {
    testOnOnePage(`should be identical with ${name} between its frames`, async ({ page }) => {
      const report = await runInPage<Awaited<ReturnType<typeof untouched>>>(
        page,
        '/e2e/harness/untouched.ts',
        options,
      );
      console.log(
        `    ${report.differing} of ${report.bytes} bytes differ, ${report.changed.length} of ${report.compared} states`,
      );
      // The picture is one: neither empty nor flat.
      expect(report.drawn).toBeGreaterThan(report.bytes / 10);
      expect(report.differing).toBe(0);
      expect(report.changed).toEqual([]);
      expect(report.compared).toBeGreaterThan(90);
      expect(report.objectsKept).toBe(true);
    });
  }
});

test.describe('reading back', () => {
  testOnOnePage(
    'should stamp late fields with their own place, with two reads in flight at most',
    async ({ page }) => {
      const report = await runInPage<Awaited<ReturnType<typeof readbacks>>>(
        page,
        '/e2e/harness/readbacks.ts',
        {
          frames: 60,
          stride: 0.02,
          options: {},
        },
      );
      expect(report.fields).toBeGreaterThan(3);
      expect(report.stampError).toBe(0);
      expect(report.worst).toBeLessThan(0.005);
      expect(report.mostInFlight).toBeLessThanOrEqual(2);
      expect(report.buffers).toBe(2);
      expect(report.stats.blocked).toBeGreaterThan(0);
      expect(report.stats.latency).toBeGreaterThan(0);
    },
  );

  testOnOnePage(
    'should wait for one read when the reach runs out, and count it',
    async ({ page }) => {
      const report = await runInPage<Awaited<ReturnType<typeof readbacks>>>(
        page,
        '/e2e/harness/readbacks.ts',
        {
          frames: 5,
          stride: 0.02,
          options: {},
        },
      );
      expect(report.forcedAtStart).toBe(1);
      expect(report.forcedByMoving).toBe(3);
    },
  );

  testOnOnePage('should have each field at once when synchronous', async ({ page }) => {
    const report = await runInPage<Awaited<ReturnType<typeof readbacks>>>(
      page,
      '/e2e/harness/readbacks.ts',
      {
        frames: 20,
        stride: 0.02,
        options: { readback: 'sync' },
      },
    );
    expect(report.fields).toBe(20);
    expect(report.stats.reads).toBe(report.stats.draws);
    expect(report.stats.latencyUpdates).toBe(0);
    expect(report.stampError).toBe(0);
    expect(report.buffers).toBe(0);
  });
});

testOnOnePage(
  'should lose no triangle that reaches through a face camera’s plane',
  async ({ page }) => {
    const reports = await runInPage<Awaited<ReturnType<typeof onThePlane>>>(
      page,
      '/e2e/harness/onThePlane.ts',
    );
    for (const { expected, missed, worst } of reports) {
      expect(expected).toBeGreaterThan(2000);
      expect(missed).toBe(0);
      expect(worst).toBeLessThan(0.001);
    }
  },
);

testOnOnePage(
  'should cut the cubemap by the user’s clipping planes as the picture is cut',
  async ({ page }) => {
    const report = await runInPage<Awaited<ReturnType<typeof clipping>>>(
      page,
      '/e2e/harness/clipping.ts',
      null,
    );
    expect(report.cut).toBeGreaterThan(1000);
    expect(report.wrong).toBe(0);
  },
);

test.describe('a collider’s life', () => {
  for (const options of [
    {},
    { output: 'axis' },
    { format: 'RGBA8' },
    { supersample: 4, format: 'RGBA16F' },
  ] satisfies CubeColliderOptions[]) {
    test(`should give back all it took and warn once of each misuse: ${JSON.stringify(options)}`, async ({
      page,
    }) => {
      const report = await runInPage<Awaited<ReturnType<typeof lifecycle>>>(
        page,
        '/e2e/harness/lifecycle.ts',
        options,
      );
      expect(report.during.textures).toBeGreaterThan(report.before.textures);
      expect(report.after).toEqual(report.before);
      expect(report.warnings).toHaveLength(4);
      for (const warning of report.warnings) expect(warning).toMatch(/^CubeCollider: /);
      expect(report.recovered).toBe(1);
    });
  }
});

test.describe('a lost context', () => {
  for (const options of [{}, { output: 'axis' }] satisfies CubeColliderOptions[]) {
    test(`should hold the character, and let it walk on once restored: ${JSON.stringify(options)}`, async ({
      page,
    }) => {
      const report = await runInPage<Awaited<ReturnType<typeof contextLoss>>>(
        page,
        '/e2e/harness/contextLoss.ts',
        options,
      );
      expect(report.began).toBeGreaterThan(0.05);
      expect(report.heldStill).toBe(0);
      expect(report.readyWhileLost).toBe(false);
      expect(report.resumed).toBeGreaterThan(0.05);
      expect(report.again).toBeGreaterThan(0.05);
      // Of surfaces one field serves many frames; the paper's mode draws in each.
      expect(report.readsAfter).toBeGreaterThan('output' in options ? 5 : 0);
      // The floor is at -1; over surfaces it keeps its skin of 20 mm.
      const skin = 'output' in options ? 0 : 0.02;
      expect(Math.abs(report.foot + 1 - skin)).toBeLessThan(0.01);
    });
  }
});
