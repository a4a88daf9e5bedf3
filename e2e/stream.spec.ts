import type stream from './harness/stream.js';
import { expect, runInPage, testOnOnePage as test } from './support/test.js';

test('@three tiles added and dropped every frame should be seen from their first one on, and leave nothing behind', async ({
  page,
}) => {
  const report = await runInPage<Awaited<ReturnType<typeof stream>>>(
    page,
    '/e2e/harness/stream.ts',
    { tiles: 2, seconds: 2 },
  );
  expect(report.asked).toBeGreaterThan(30);
  expect(report.missed).toBe(0);
  // Of the level none is within reach, and of the tiles none is left.
  expect(report.held).toBe(0);
  expect(report.geometries[0]).toBeGreaterThan(0);
  expect(report.geometries.at(-1)).toBe(0);
});
