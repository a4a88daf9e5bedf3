// `node scripts/avatar/sheet.mjs [folder]`: pictures of every clip of public/avatar.glb at eight moments, from the side and
// from the front, to look at after a change.

import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { ADVICE, findBrowser } from '../browser.mjs';

const folder = process.argv[2] ?? 'test-results/avatar';
const found = await findBrowser();
if (!found) throw new Error(ADVICE);
await mkdir(folder, { recursive: true });
const server = await createServer({
  configFile: 'e2e/vite.config.ts',
  logLevel: 'error',
  server: { port: 0, host: '127.0.0.1' },
});
await server.listen();
const { port } = server.httpServer.address();
const browser = await chromium.launch({
  executablePath: found.path,
  args: ['--use-angle=swiftshader'],
});
const page = await browser.newPage({ viewport: { width: 1440, height: 440 } });
await page.goto(`http://127.0.0.1:${port}/e2e/harness/index.html`);
const names = await page.evaluate(async () => {
  const { openSheet } = await import('/scripts/avatar/sheetPage.js');
  window.sheet = await openSheet('/avatar.glb');
  return window.sheet.names;
});
for (const name of names) {
  await page.evaluate((name) => window.sheet.draw(name), name);
  await page.screenshot({ path: join(folder, `${name}.png`) });
}
await browser.close();
await server.close();
