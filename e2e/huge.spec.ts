import type huge from './harness/huge.js';
import { expect, runInPage, testOnOnePage as test } from './support/test.js';

const CELLS = 300;
const TRIANGLES = 2 * CELLS * CELLS;

for (const shuffled of [false, true]) {
  test(`${shuffled ? 'a shuffled' : '@three a'} huge mesh should be seen as if it were drawn whole, and less of it be drawn`, async ({
    page,
  }) => {
    const report = await runInPage<Awaited<ReturnType<typeof huge>>>(page, '/e2e/harness/huge.ts', {
      shuffled,
      cells: CELLS,
    });
    expect(report.first.restored).toBe(true);
    // In each face that it touches.
    expect(report.first.drawn).toBeGreaterThanOrEqual(TRIANGLES);
    expect(report.atOnce).toBeGreaterThanOrEqual(TRIANGLES);
    for (const seen of [report.indexed, report.edited]) {
      expect(seen.hits).toBeGreaterThan(5000);
      expect(seen.differing).toBe(0);
      expect(seen.parts).toBeGreaterThan(0);
      expect(seen.parts).toBeLessThan(seen.whole / 10);
    }
    expect(report.geometries).toBe(2);
    expect(report.left).toBe(0);
  });
}
