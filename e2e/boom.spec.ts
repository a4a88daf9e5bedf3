import type { BoomReport } from './harness/boom.js';
import type { Backend } from './support/rendering.js';
import { expect, runInPage, test } from './support/test.js';

for (const backend of ['WebGL2', 'WebGPU'] satisfies Backend[]) {
  test(`no wall ever comes between head and camera, ${backend}`, async ({ page }) => {
    const report = await runInPage<BoomReport>(page, '/e2e/harness/boom.ts', {
      backend,
      frames: backend === 'WebGPU' ? 56 : 120,
    });
    const { frames, draws, given, walked, reach, update, blocked } = report;
    console.log(
      `    ${frames} frames, ${walked.toFixed(1)} m walked, given ${(100 * given).toFixed(0)} % of what a ray has free, ${draws} draws; ` +
        `a frame: ${reach.toFixed(3)} ms asked, ${update.toFixed(2)} ms updated, ${(blocked / frames).toFixed(2)} ms of that blocked`,
    );
    expect(report.hidden).toEqual([]);
    expect(report.cut).toEqual([]);
    // No safety by staying in the head, nor by standing still.
    expect(given).toBeGreaterThan(0.5);
    expect(walked).toBeGreaterThan(frames / 15);
  });
}
