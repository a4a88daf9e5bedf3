import type helper from './harness/helper.js';
import { expect, runInPage, testOnOnePage as test } from './support/test.js';

test('should show what each collider sees, where it is, and leave the renderer as it was', async ({
  page,
}) => {
  const report = await runInPage<ReturnType<typeof helper>>(page, '/e2e/harness/helper.ts');
  expect(report.shown).toEqual([
    { ordered: true, balls: 6, rings: 0 },
    { ordered: true, balls: 6, rings: 0 },
    { ordered: true, balls: 6, rings: 0 },
    { ordered: true, balls: 6, rings: 0 },
    { ordered: true, balls: 6, rings: 6 },
  ]);
  expect(report.changed).toEqual([]);
  // Bottom left, bottom right, top left, top right.
  expect(report.corners).toEqual({
    'bottom-left': [true, false, false, false],
    'bottom-right': [false, true, false, false],
    'top-left': [false, false, true, false],
    'top-right': [false, false, false, true],
  });
  expect([report.beforeFirst, report.hidden]).toEqual([0, 0]);
});
