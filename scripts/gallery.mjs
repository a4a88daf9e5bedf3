// `npm run build:gallery [-- name …]`: the pictures of docs/guides, of every example or of those named.

import { readdirSync } from 'node:fs';
import { writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { chromium } from '@playwright/test';
import sharp from 'sharp';
import { createServer } from 'vite';
import { ADVICE, findBrowser } from './browser.mjs';

/** Drawn at twice the size of the picture that is kept. */
const SIZE = { width: 960, height: 540 };
/** A software GPU walks faster in a small window. */
const SMALL = { width: 192, height: 108 };
/** What a reader may be asked to load for each, bytes, and the qualities tried for it. */
const LARGEST = 30e3;
const QUALITIES = [82, 74, 66, 58, 50, 42];
/** How far each walks before its picture is taken, metres. */
const WALK = 1.5;
const WALKS = {
  'moving-platforms': 2.2,
  sensors: 2,
  ghosts: 7.5,
  'from-octree': 0.6,
  'skinned-creatures': 0.6,
  'beside-rapier': 0.6,
};
/** Those that keep the size they began with. */
const FIXED = ['webxr'];
/** Until what a page lets move or load has come to rest, milliseconds. */
const REST = 2000;

const asked = process.argv.slice(2);
const names = readdirSync('examples')
  .filter((name) => name.endsWith('.html'))
  .map((name) => name.replace('.html', ''))
  .filter((name) => asked.length === 0 || asked.includes(name));
const found = await findBrowser();
if (!found) throw new Error(ADVICE);
const server = await createServer({
  configFile: fileURLToPath(new URL('../e2e/vite.config.ts', import.meta.url)),
  logLevel: 'error',
  server: { port: 0, host: '127.0.0.1' },
});
await server.listen();
const { port } = server.httpServer.address();
const browser = await chromium.launch({
  executablePath: found.path,
  args: ['--use-angle=swiftshader'],
});

/** Walks forward so far, from where it stands. */
async function walk(page, metres) {
  const [x, , z] = await page.evaluate(() => window.character.position.toArray());
  await page.keyboard.down('KeyW');
  await page.waitForFunction(
    ([x, z, metres]) => {
      const { position } = window.character;
      return Math.hypot(position.x - x, position.z - z) >= metres;
    },
    [x, z, metres],
  );
  await page.keyboard.up('KeyW');
}

/** A headset whose eyes are drawn side by side, with hands before them. */
async function addHeadset(page) {
  await page.addInitScript({ path: 'node_modules/iwer/build/iwer.min.js' });
  await page.addInitScript(() => {
    const { XRDevice, metaQuest3 } = window.IWER;
    const headset = new XRDevice(metaQuest3, { stereoEnabled: true });
    headset.installRuntime({ forceInstall: true });
    headset.position.set(0, 1.6, 0);
    headset.quaternion.set(-0.1, 0, 0, 0.995);
    headset.controllers.left.position.set(-0.2, 1.3, -0.7);
    headset.controllers.right.position.set(0.2, 1.3, -0.7);
  });
}

async function photograph(name) {
  const headset = name === 'webxr';
  const page = await browser.newPage({ viewport: FIXED.includes(name) ? SIZE : SMALL });
  page.setDefaultTimeout(120_000);
  if (headset) await addHeadset(page);
  await page.goto(`http://127.0.0.1:${port}/examples/${name}.html`);
  await page.waitForFunction(() => window.character?.grounded);
  if (headset) {
    await page.evaluate(() => document.getElementById('VRButton').click());
    await page.waitForFunction(() => window.camera.position.y > 1.5);
    await page.addStyleTag({ content: '#VRButton { visibility: hidden }' });
  } else await walk(page, WALKS[name] ?? WALK);
  await page.setViewportSize(SIZE);
  await page.waitForTimeout(REST);
  const picture = await page.screenshot();
  await page.close();
  return picture;
}

for (const name of names) {
  const picture = sharp(await photograph(name)).resize({ width: SIZE.width / 2 });
  for (const quality of QUALITIES) {
    const bytes = await picture.clone().webp({ quality, effort: 6 }).toBuffer();
    if (bytes.length > LARGEST && quality !== QUALITIES.at(-1)) continue;
    await writeFile(`docs/guides/${name}.webp`, bytes);
    console.log(`docs/guides/${name}.webp: quality ${quality}, ${bytes.length} bytes`);
    break;
  }
}
await browser.close();
await server.close();
