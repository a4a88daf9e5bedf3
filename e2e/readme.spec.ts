import { mkdir, readFile, writeFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import sharp from 'sharp';
import { buildReactPage } from './support/reactPage.js';
import { expect, test } from './support/test.js';

const readme = await readFile('README.md', 'utf8');

/** The block of code below a comment that begins so. */
const block = (comment: string) =>
  new RegExp(`<!-- ${comment}:.*?-->\\s*\`\`\`jsx?\\n(.*?)\`\`\``, 's').exec(readme)![1]!;

const quickStart = block('quick start');
const withLevel = replace(quickStart, /const box = .*?\n(?=\n)/s, block('level'));
const reactQuickStart = block('react quick start');

test('@three the quick start of README should run as it stands, and walk', async ({ page }) => {
  expect(lines(quickStart)).toBeLessThanOrEqual(25);
  await walk(page, await write(quickStart));
});

test('it should walk in a level by GLTFLoader, as README says', async ({ page }) => {
  await walk(page, await write(withLevel));
});

test('it should walk with WebGPURenderer, changed as README says', async ({ page }) => {
  await walk(page, await write(onWebGPU(quickStart)));
});

test('it should walk in a level with WebGPURenderer, as README says', async ({ page }) => {
  expect(readme).toContain('wants `await renderer.init()` before it');
  const code = replace(onWebGPU(withLevel), 'scene.add((await', 'await renderer.init();\n$&');
  await walk(page, await write(code));
});

test('it should walk with React, as README says', async ({ page }) => {
  expect(lines(reactQuickStart)).toBeLessThanOrEqual(25);
  await walk(page, await bundle(reactQuickStart, 'quickstart'));
});

test('it should walk in a level with React, as README says', async ({ page }) => {
  expect(readme).toContain('in a `<Canvas onCreated={surround} …>`');
  let code = replace(reactQuickStart, /import \{ Canvas \}.*\n/, block('react level'));
  code = replace(code, '<Canvas ', '<Canvas onCreated={surround} ');
  code = replace(code, / *<Box color=\{0x8f.*(?=<\/Canvas>)/s, block('inside the react level'));
  await walk(page, await bundle(code, 'quickstart-level'));
});

test('it should walk with React and WebGPURenderer, as README says', async ({ page }) => {
  expect(readme).toContain('in a `<Canvas gl={gl} …>`');
  let code = replace(reactQuickStart, /import \{ Character \}.*\n/, block('react webgpu'));
  code = replace(code, '<Canvas ', '<Canvas gl={gl} ');
  code = replace(code, / *<Character .*\n/, block('inside the react webgpu'));
  code = replace(code, 'WebGPURenderer(props)', 'WebGPURenderer({ ...props, forceWebGL: true })');
  await walk(page, await bundle(code, 'quickstart-webgpu'));
});

const lines = (code: string) => code.trimEnd().split('\n').length;

function replace(code: string, what: string | RegExp, by: string): string {
  const changed = code.replace(what, by);
  expect(changed).not.toBe(code);
  return changed;
}

/** Changed as README's difference says; on the fallback, since a headless browser shows no picture of WebGPU's. */
function onWebGPU(code: string): string {
  const [, diff] = /```diff\n(.*?)```/s.exec(readme)!;
  const pairs = [...diff!.matchAll(/^-(.*)\n\+(.*)\n/gm)];
  expect(pairs.length).toBe(3);
  for (const [, from, to] of pairs) code = replace(code, from!, to!);
  return replace(code, '{ antialias: true }', '{ antialias: true, forceWebGL: true }');
}

/** @returns the address of a module with this code, after which the tests see its character */
async function write(code: string): Promise<string> {
  await mkdir('.cache', { recursive: true });
  await writeFile('.cache/quickstart.js', `${code}\nwindow.character = character;\n`);
  return '/.cache/quickstart.js';
}

/** The same of a page of React. */
function bundle(code: string, name: string): Promise<string> {
  const seen = 'controls ref={(it) => void (window.character = it)} />';
  return buildReactPage(replace(code, 'controls />', seen), '.', name);
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
  // Neither white nor black: something is lit.
  await expect
    .poll(async () => contrast(await canvas.screenshot()), { timeout: 60_000 })
    .toBeGreaterThan(20);
  await page.waitForFunction(() => window.character?.grounded, undefined, { timeout: 60_000 });
  await canvas.click();
  // Without a key nothing changes once the eyes have sunk after the landing.
  let before = '';
  const rests = async () => {
    const last = before;
    before = await picture();
    return last === before;
  };
  await expect.poll(rests, { timeout: 60_000, intervals: [300] }).toBe(true);
  const [x, , z] = await page.evaluate(() => window.character.position.toArray());
  await page.keyboard.down('KeyW');
  await page.waitForFunction(
    ([x, z]) => Math.hypot(window.character.position.x - x, window.character.position.z - z) > 0.5,
    [x, z] as const,
    { timeout: 60_000 },
  );
  await page.keyboard.up('KeyW');
  expect((await picture()) !== before, 'the picture walks, too').toBe(true);
}

/** How much a picture's lights and darks differ, of 255. */
async function contrast(png: Buffer): Promise<number> {
  const { channels } = await sharp(png).stats();
  return Math.max(...channels.slice(0, 3).map(({ stdev }) => stdev));
}
