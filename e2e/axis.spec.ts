import type { CubeColliderOptions } from 'three-cube-collider';
import type { AxisReport } from './harness/axis.js';
import type axisWalk from './harness/axisWalk.js';
import { expect, runInPage, testOnOnePage as test } from './support/test.js';

const POSES = 170;
/** How far before a kerb of 0.45 R a sphere of half a metre touches its edge. */
const TOUCHES = Math.sqrt(0.5 ** 2 - (0.55 * 0.5) ** 2);

for (const seed of [1]) {
  test(`should find each face’s highest red as the equations do, ${3 * POSES} poses, seed ${seed}`, async ({
    page,
  }) => {
    const reports = await runInPage<AxisReport[]>(page, '/e2e/harness/axis.ts', {
      poses: POSES,
      seed,
    });
    let faces = 0;
    let plainFailures = 0;
    for (const report of reports) {
      console.log(
        `    ${report.scene}: ${report.poses} poses, ${report.seen} faces saw something; ${report.plainFailures} off ` +
          `the rays through texel middles by more than a step; ${report.failures} by more than the rasteriser's ` +
          `grid of 1/${2 ** report.subpixelBits} texel explains`,
      );
      faces += 6 * report.poses;
      plainFailures += report.plainFailures;
      expect(report.failures).toBe(0);
      expect(report.seen).toBeGreaterThan(2 * report.poses);
      expect(report.bytesRead).toBe(24);
    }
    console.log(`    plainly within 1/255: ${faces - plainFailures} of ${faces} faces`);
    // What is left are texels whose middle lies within the grid's step of a silhouette.
    expect(plainFailures).toBeLessThanOrEqual(faces / 300);
  });
}

test('should find them at other resolutions too', async ({ page }) => {
  for (const resolution of [8, 64]) {
    const reports = await runInPage<AxisReport[]>(page, '/e2e/harness/axis.ts', {
      poses: 12,
      seed: 2,
      resolution,
    });
    for (const report of reports) expect(report.failures).toBe(0);
  }
});

test.describe('a sphere of the paper’s', () => {
  const cases: [string, number, CubeColliderOptions][] = [
    ['@three the paper’s mode, 60 Hz', 60, { output: 'axis' }],
    ['the paper’s mode, 20 Hz', 20, { output: 'axis' }],
    ['surfaces read synchronously, 30 Hz', 30, { output: 'surface', readback: 'sync' }],
    ['surfaces read asynchronously, 60 Hz', 60, { output: 'surface' }],
  ];
  for (const [name, rate, options] of cases) {
    test(`should stand, stop, climb and not creep: ${name}`, async ({ page }) => {
      const walk = await runInPage<Awaited<ReturnType<typeof axisWalk>>>(
        page,
        '/e2e/harness/axisWalk.ts',
        { rate, options },
      );
      const mm = (metres: number) => `${(1000 * metres).toFixed(2)} mm`;
      console.log(
        `    stands ${mm(walk.standsAt)} over the floor; in 5 s creeps ${mm(walk.creep)}, sinks ${mm(walk.sinks)}; ` +
          `walks ${mm(walk.intoWall)} into a wall; climbs 0.25 R to ${mm(walk.onLow.y)} over its top; ` +
          `stops ${mm(-3 - walk.againstHigh.z + TOUCHES)} past touching 0.45 R`,
      );
      expect(walk.grounded).toBe(true);
      expect(Math.abs(walk.standsAt)).toBeLessThan(0.01);
      expect(walk.creep).toBeLessThan(1e-4);
      expect(walk.sinks).toBeLessThan(0.002);
      expect(walk.intoWall).toBeGreaterThan(-0.02);
      expect(walk.intoWall).toBeLessThan(0.02);
      expect(Math.abs(walk.onLow.y)).toBeLessThan(0.01);
      expect(walk.onLow.z).toBeGreaterThan(4);
      expect(walk.againstHigh.z).toBeGreaterThan(-3);
      expect(walk.againstHigh.y).toBeLessThan(0.1);
    });
  }
});
