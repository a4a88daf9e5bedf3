import type { CrowdReport, GroupCase, GroupReport } from './harness/group.js';
import type { Backend } from './support/rendering.js';
import { expect, runInPage, testOnOnePage as test } from './support/test.js';

const BACKENDS: Backend[] = ['WebGL2', 'WebGPU', 'fallback'];

/** Twelve places, seven cubemaps an update, five a render. */
const PLACES = 12;

const cases: GroupCase[] = [
  ...BACKENDS.map((backend) => ({ backend })),
  { backend: 'WebGL2', collider: { supersample: 1 } },
  { backend: 'WebGL2', collider: { format: 'RGBA16F' } },
  { backend: 'WebGL2', collider: { format: 'RGBA8', resolution: 16 } },
];

for (const options of cases) {
  const title = [options.backend, ...Object.values(options.collider ?? {})].join(', ');
  test(`colliders drawn together should see what each sees alone: ${title}`, async ({ page }) => {
    const report = await runInPage<GroupReport>(page, '/e2e/harness/group.ts', options);
    console.log(`    ${report.same} of ${report.texels} texels the same`);
    expect(report.same).toBe(report.texels);
    expect(report.seen).toBeGreaterThan(0.6 * report.texels);
    expect(report.cubemaps).toBe(PLACES);
    expect(report.draws).toBe(2);
    expect(report.reads).toBe(2);
    expect(report.calls).toBeGreaterThan(PLACES);
    if (options.backend === 'WebGL2') expect(report.left).toBe(0);
  });
}

for (const backend of BACKENDS) {
  test(`thirty characters should walk about in a room together on ${backend}, and one on its own`, async ({
    page,
  }) => {
    const frames = 120;
    const report = await runInPage<CrowdReport>(page, '/e2e/harness/crowd.ts', { backend, frames });
    console.log(
      `    ${report.cubemaps} cubemaps in ${report.draws} draws and ${report.reads} reads; held ${report.held} of ${report.steps} steps; ways ${report.shortest.toFixed(2)} to ${report.longest.toFixed(2)} m`,
    );
    expect(report.lowest).toBeGreaterThan(0.015);
    expect(report.highest).toBeLessThan(0.025);
    expect(report.deepest).toBeLessThan(0);
    expect(report.shortest).toBeGreaterThan(1);
    expect(report.longest).toBeLessThan((3 * report.frames) / 60);
    expect(report.cubemaps).toBeGreaterThan(3 * report.draws);
    expect(report.reads).toBeGreaterThan(0);
    expect(report.reads).toBeLessThanOrEqual(report.draws);
    expect(report.walkedAlone).toBe(true);
  });
}
