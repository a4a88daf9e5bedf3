// `npm run build:picture [-- demo.jpg … | --moving]`: README's pictures of the demo, in docs/; the moving one alone if asked.

import { basename } from 'node:path';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { ADVICE, findBrowser } from './browser.mjs';
import { makeMovingPicture } from './movingPicture.mjs';

/** Each with the function that puts everything in its place, run in the page. */
const PICTURES = [
  {
    file: 'docs/demo.jpg',
    size: { width: 1280, height: 640 },
    query: 'helper=1',
    async arrange() {
      const { demo } = window;
      demo.helper.size = 300;
      // On the bridge, between its railings.
      demo.character.teleport(demo.spawn.clone().set(-13.2, 3.02, -11));
      demo.controls.yaw = -0.75;
      demo.controls.pitch = -0.08;
      demo.controls.distance = 3.6;
      await demo.step(4);
    },
  },
  {
    file: 'docs/hall.jpg',
    size: { width: 1280, height: 720 },
    query: 'place=hall',
    async arrange() {
      const { demo } = window;
      const { hall, character } = demo;
      // On the creature's back, the tower far behind.
      hall.time = 41;
      hall.update(0, character.position);
      hall.root.updateMatrixWorld(true);
      const back = hall.creature.joint(3.2).getWorldPosition(demo.spawn.clone());
      character.teleport(back.setY(back.y + 1.1));
      demo.controls.yaw = -0.68;
      demo.controls.pitch = -0.37;
      demo.controls.distance = 7;
      await demo.step(12);
    },
  },
];

const asked = process.argv.slice(2);
const found = await findBrowser();
if (!found) throw new Error(ADVICE);
const server = await createServer({ logLevel: 'error', server: { port: 0, host: '127.0.0.1' } });
await server.listen();
const { port } = server.httpServer.address();
const browser = await chromium.launch({
  executablePath: found.path,
  args: ['--use-angle=swiftshader'],
});
/** The demo without words over it, its camera where it is put at once. */
async function open(query, size) {
  const page = await browser.newPage({ viewport: size });
  // A software GPU draws a frame in seconds.
  page.setDefaultTimeout(300_000);
  await page.goto(`http://127.0.0.1:${port}/?ui=0&output=surface&view=third&dpr=1&${query}`);
  await page.evaluate(async () => {
    await window.demo.ready;
    window.demo.controls.smoothing = Infinity;
  });
  return page;
}

if (asked.includes('--moving')) await makeMovingPicture(open);
else {
  for (const { file, size, query, arrange } of PICTURES) {
    if (asked.length > 0 && !asked.includes(basename(file))) continue;
    const page = await open(query, size);
    await page.evaluate(arrange);
    await page.screenshot({ path: file, type: 'jpeg', quality: 88 });
    await page.close();
  }
}
await browser.close();
await server.close();
