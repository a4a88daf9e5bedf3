import { readFile } from 'node:fs/promises';
import { join, relative, sep } from 'node:path';
import type { Page } from '@playwright/test';
import { bundle, BUNDLER_NAMES } from '../consumers/bundlers.mjs';
import { packed } from '../consumers/packed.mjs';
import { expect, test } from './support/test.js';

let folder: string;
let installed: string;
test.beforeAll(() => {
  ({ folder, installed } = packed('app'));
});

for (const bundler of BUNDLER_NAMES) {
  test(`the packed package should walk in a page that ${bundler} built`, async ({ page }) => {
    const { file } = await bundle(bundler, 'app', folder);
    const url = `/${relative('.', file).split(sep).join('/')}`;
    await open(page, `<script type="module" src="${url}"></script>`);
    await walks(page);
  });
}

test('the packed package should walk in a page without a bundler', async ({ page }) => {
  const roots: [string, string][] = [
    ['/plain/three/', 'node_modules/three'],
    ['/plain/three-cube-collider/', installed],
    ['/plain/app/', 'consumers/projects/app'],
  ];
  await page.route('**/plain/**', async (route) => {
    const { pathname } = new URL(route.request().url());
    const [prefix, place] = roots.find(([each]) => pathname.startsWith(each))!;
    const body = await readFile(join(place, pathname.slice(prefix.length)));
    return route.fulfill({ contentType: 'text/javascript', body });
  });
  const imports = {
    three: '/plain/three/build/three.module.js',
    'three-cube-collider': '/plain/three-cube-collider/dist/index.js',
  };
  await open(
    page,
    `<script type="importmap">${JSON.stringify({ imports })}</script>
     <script type="module" src="/plain/app/main.js"></script>`,
  );
  await walks(page);
});

async function open(page: Page, scripts: string): Promise<void> {
  await page.route('**/consumer.html', (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<!doctype html><link rel="icon" href="data:,"><body>${scripts}`,
    }),
  );
  await page.goto('/consumer.html');
}

/** It lands on the floor, a skin above it, and stops at the wall, a radius and a skin before it. */
async function walks(page: Page): Promise<void> {
  await expect(page).toHaveTitle(/^at 0\.02 -1\.1[23]$/, { timeout: 60_000 });
}
