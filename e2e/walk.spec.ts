import type { CubeWalkerOptions } from '../bench/walk/CubeWalker.js';
import type { WalkResult, WalkSettings } from '../bench/walk/Walk.js';
import type stairs from './harness/stairs.js';
import { expect, runInPage, test, testOnOnePage } from './support/test.js';

type Settings = WalkSettings & CubeWalkerOptions;

/** Short legs: many places, each begun by a teleport. The long walks are `npm run walk` and `npm run soak`. */
const SETTINGS: Settings = { hz: 60, frames: 700, seed: 5, leg: 3, latency: 0 };

for (const [title, settings] of Object.entries<Partial<Settings>>({
  'with fields at once': {},
  'at 20 Hz': { hz: 20, frames: 300 },
  'with fields three frames late': { latency: 3 },
  'with asynchronous reads': { latency: 'real', frames: 300 },
  'on WebGPU': { backend: 'WebGPU', latency: 1, frames: 300 },
  'on WebGPU at 20 Hz, with reads as shipped': {
    backend: 'WebGPU',
    latency: 'real',
    hz: 20,
    frames: 200,
  },
  'on the WebGL 2 fallback of WebGPURenderer': { backend: 'fallback', latency: 1, frames: 300 },
})) {
  test(`should walk the demo's level ${title} and never get into what is drawn`, async ({
    page,
  }) => {
    const result = await runInPage<WalkResult>(page, '/e2e/harness/walk.ts', {
      ...SETTINGS,
      ...settings,
    });
    expect(result).toMatchObject({ crossed: 0, fellThrough: 0, fellOff: 0, nan: 0 });
    expect(result.penetration.p99).toBeLessThan(0.001);
    expect(result.penetration.max).toBeLessThan(0.01);
    // No safety by standing still: it gets about, and rests close to what it stands on.
    expect(result.distance).toBeGreaterThan(0.4 * 5 * (result.frames / (settings.hz ?? 60)));
    for (const gap of result.rest.gaps) {
      expect(gap).toBeGreaterThan(0.01);
      expect(gap).toBeLessThan(0.025);
    }
    expect(result.rest.drift).toBeLessThan(1e-4);
  });
}

for (const [rise, tread] of [
  [0.25, 0.4],
  [0.15, 0.31],
]) {
  testOnOnePage(`stairs of ${rise} by ${tread} m should never be stood at`, async ({ page }) => {
    const settings = { rise, tread, climbs: 16 };
    expect(
      await runInPage<ReturnType<typeof stairs>>(page, '/e2e/harness/stairs.ts', settings),
    ).toEqual([]);
  });
}
