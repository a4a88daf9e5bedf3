import { mkdir, readFile, writeFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { buildReactPage } from './support/reactPage.js';
import { expect, test } from './support/test.js';

const readme = await readFile('README.md', 'utf8');

const quickStart = /<!-- quick start.*?-->\s*```js\n(.*?)```/s.exec(readme)![1]!;

test('@three the quick start of README should run as it stands, and walk', async ({ page }) => {
  expect(quickStart.trimEnd().split('\n').length).toBeLessThanOrEqual(25);
  await walk(page, await write(quickStart));
});

test('it should walk with WebGPURenderer, changed as README says', async ({ page }) => {
  const [, diff] = /```diff\n(.*?)```/s.exec(readme)!;
  const lines = diff!.trimEnd().split('\n');
  let code = quickStart;
  for (let i = 0; i < lines.length; i += 2) {
    expect(code).toContain(lines[i]!.slice(1));
    code = code.replace(lines[i]!.slice(1), lines[i + 1]!.slice(1));
  }
  // On the fallback: a headless browser shows no picture of WebGPU's.
  code = code.replace(
    'new WebGLRenderer({ antialias: true })',
    'new WebGPURenderer({ antialias: true, forceWebGL: true })',
  );
  await walk(page, await write(code));
});

test('it should walk with React, as README says', async ({ page }) => {
  const code = /<!-- react quick start.*?-->\s*```jsx\n(.*?)```/s.exec(readme)![1]!;
  expect(code.trimEnd().split('\n').length).toBeLessThanOrEqual(25);
  await walk(page, await buildReactPage(code, '.', 'quickstart'));
});

/** @returns the address of a module with this code */
async function write(code: string): Promise<string> {
  await mkdir('.cache', { recursive: true });
  await writeFile('.cache/quickstart.js', code);
  return '/.cache/quickstart.js';
}

async function walk(page: Page, script: string): Promise<void> {
  await page.route('**/quickstart.html', (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<!doctype html><body style="margin:0"><script type="module" src="${script}"></script>`,
    }),
  );
  await page.setViewportSize({ width: 240, height: 160 });
  await page.goto('/quickstart.html');
  const canvas = page.locator('canvas');
  await expect(canvas).toBeVisible();
  const picture = async () => (await canvas.screenshot()).toString('base64');
  await expect
    .poll(async () => (await picture()).length, { timeout: 60_000 })
    .toBeGreaterThan(10_000);
  // It has landed once two pictures in a row are the same.
  const rest = async () => {
    let last = '';
    await expect
      .poll(
        async () => {
          const now = await picture();
          const same = now === last;
          last = now;
          return same;
        },
        { timeout: 60_000, intervals: [500] },
      )
      .toBe(true);
    return last;
  };
  const before = await rest();
  await canvas.click();
  await page.keyboard.down('KeyW');
  await expect.poll(picture, { timeout: 60_000, intervals: [500] }).not.toBe(before);
  await page.keyboard.up('KeyW');
  // It stops elsewhere than it began.
  expect(await rest()).not.toBe(before);
}
