import type { SmokeResult } from './harness/smoke.js';
import { expect, runInPage, test, testOnOnePage } from './support/test.js';

const { THREE_VERSION } = process.env;
const REVISION =
  THREE_VERSION === 'oldest' ? '180' : (/^0\.(\d+)/.exec(THREE_VERSION ?? '')?.[1] ?? '187');

test('@three the page has a real WebGL2 context and the expected three revision', async ({
  page,
  browser,
}) => {
  const result = await runInPage<SmokeResult>(page, '/e2e/harness/smoke.ts');
  // For the log only: a machine without float buffers is one that we support.
  console.log(
    `Chromium ${browser.version()}, ${result.renderer}, ` +
      `${result.floatBuffers ? 'with' : 'without'} float colour buffers`,
  );
  expect(result).toMatchObject({ revision: REVISION, oneCopy: true, webgl2: true });
});

test.describe('the tests’ own watch over the page', () => {
  test('should fail a test whose page logs an error', async ({ page }) => {
    // Expected to fail, and counted as a failure if it passes: the watch alone can make it fail.
    test.fail();
    await page.evaluate(() => console.error('wrong'));
  });

  test.describe('with a warning allowed', () => {
    test.use({ allowedMessages: [/console\.warning: WebGL: INVALID_ENUM/] });

    test('should fail a test that leaves a WebGL error pending', async ({ page }) => {
      // As above. Chromium's warning of it passes, so the error itself is what fails the test.
      test.fail();
      await page.goto('/e2e/harness/index.html');
      await page.evaluate(
        () => void document.createElement('canvas').getContext('webgl2')!.enable(0),
      );
    });
  });

  test('should report a misuse of WebGL', async ({ page, complaints }) => {
    await page.evaluate(() => {
      const gl = document.createElement('canvas').getContext('webgl2')!;
      gl.enable(0);
      gl.getError();
    });
    await expect.poll(() => complaints.splice(0).join()).toContain('INVALID_ENUM');
  });

  test('should report an exception that nobody catches', async ({ page, complaints }) => {
    await page.evaluate(() => {
      void Promise.reject(new Error('wrong'));
    });
    await expect.poll(() => complaints.splice(0).join()).toContain('uncaught: Error: wrong');
  });

  test.describe('with allowed messages', () => {
    test.use({
      allowedMessages: [[/console\.error: one/, /uncaught: Error: two/], { scope: 'test' }],
    });

    test('should let just those pass', async ({ page, complaints }) => {
      await page.evaluate(() => {
        console.error('one');
        void Promise.reject(new Error('two'));
        console.error('three');
      });
      await expect.poll(() => complaints.splice(0)).toEqual(['console.error: three']);
    });
  });
});

testOnOnePage.describe('a page that tests share', () => {
  testOnOnePage.use({ allowedMessages: [/console\.warning: WebGL: INVALID_ENUM/] });

  testOnOnePage('should fail the test that leaves a WebGL error pending', async ({ page }) => {
    test.fail();
    await runInPage(page, '/e2e/harness/smoke.ts');
    await page.evaluate(() => {
      const gl = document.createElement('canvas').getContext('webgl2')!;
      Object.assign(window, { gl }).gl.enable(0);
    });
  });

  testOnOnePage('should leave the next one nothing of it but the page', async ({ page }) => {
    await runInPage(page, '/e2e/harness/smoke.ts');
    const lost = await page.evaluate(() =>
      (window as unknown as { gl?: WebGLRenderingContext }).gl?.isContextLost(),
    );
    expect(lost).toBe(true);
  });
});
