import type xr from './harness/xr.js';
import type { XrCase } from './harness/xr.js';
import { expect, runInPage, test } from './support/test.js';

const CASES: XrCase[] = [
  { ownFramebuffer: false, collider: { readback: 'sync' } },
  { ownFramebuffer: true, collider: { readback: 'sync', format: 'RGBA8' } },
  { ownFramebuffer: true, collider: { readback: 'async' } },
];

// The session draws a picture of the window's size.
test.use({ viewport: { width: 320, height: 160 } });

for (const options of CASES) {
  const where = options.ownFramebuffer ? 'a framebuffer of the session’s' : 'the canvas';
  const { readback, format } = options.collider!;
  test(`should leave XR that presents on ${where} as it is, and see as without: ${readback} ${format ?? ''}`, async ({
    page,
  }) => {
    const report = await runInPage<Awaited<ReturnType<typeof xr>>>(
      page,
      '/e2e/harness/xr.ts',
      options,
    );
    expect(report).toMatchObject({ presenting: true, ended: true, eyes: 2, astray: 0 });
    expect(report.colours).toBeGreaterThan(100);
    expect(report.eyesDiffer).toBeGreaterThan(1000);
    expect(report.differing).toBe(0);
    expect(report.changed).toEqual([]);
    expect(report.fields).toBe(4);
    expect(report.texels).toBeGreaterThan(15_000);
    expect(report.wrong).toBe(0);
  });
}
