import type renderers from './harness/renderer.js';
import type { FrameWay } from './harness/renderer.js';
import { expect, runInPage, testOnOnePage as test } from './support/test.js';

const WAYS: FrameWay[] = [
  'plainly',
  'through an EffectComposer',
  'without clearing by itself',
  'with an ArrayCamera',
];

for (const way of WAYS) {
  test(`should leave a frame with shadows, a mirror and water as it is, drawn ${way}`, async ({
    page,
  }) => {
    // One is enough to have a second renderer look at the same scene.
    const others = way === 'plainly';
    const report = await runInPage<ReturnType<typeof renderers>>(page, '/e2e/harness/renderer.ts', {
      way,
      others,
    });
    expect(report.colours).toBeGreaterThan(100);
    expect(report.differing).toBe(0);
    expect(report.stateKept).toBe(true);
    // The wall, the mirror, the ceiling and the water.
    for (const seen of others ? [report.seen, report.otherSeen!] : [report.seen]) {
      [2, 1, 2, 1].forEach((distance, i) => expect(seen[i]).toBeCloseTo(distance, 2));
    }
  });
}
