import type { CubeColliderOptions } from 'three-cube-collider';
import type survey from './harness/survey.js';
import { expect, runInPage, testOnOnePage as test } from './support/test.js';

for (const options of [{}, { readback: 'sync', format: 'RGBA8' }] satisfies CubeColliderOptions[]) {
  test(`@three should tell, between draws, what became of what was drawn: ${JSON.stringify(options)}`, async ({
    page,
  }) => {
    const report = await runInPage<Awaited<ReturnType<typeof survey>>>(
      page,
      '/e2e/harness/survey.ts',
      options,
    );
    expect(report.said).toEqual([
      'no draw yet: changed/1 changed/1 -> /1',
      'nothing: /1 /1 -> /1',
      'a lift rose: moved/1 moved/1 -> /1',
      'a door hid: changed/1 changed/1 -> /1',
      'an instance moved: changed/1 changed/1 -> /1',
      'a skin came: changed+deforms/1 changed+deforms/1 -> deforms/1',
      'a bone moved: deforms/1 deforms/1 -> deforms/1',
      // What was drawn farther away still stands; the next draw has left it out, and what it left out is not missed.
      'the reach shrank: deforms/1 deforms/1 -> /1',
      'invalidated: changed/1 changed/1 -> /1',
    ]);
    expect(report.doorBefore).toBeGreaterThan(100);
    expect(report.doorAfter).toBe(0);
    expect(report.coin).toBe(0);
    expect(report.rigid.every((each) => each)).toBe(true);
    expect(report.deforming).toBe(0);
  });
}
