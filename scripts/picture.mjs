// `npm run build:picture`: docs/demo.jpg, README's picture of the demo.

import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { ADVICE, findBrowser } from './browser.mjs';

const found = await findBrowser();
if (!found) throw new Error(ADVICE);
const server = await createServer({ logLevel: 'error', server: { port: 0, host: '127.0.0.1' } });
await server.listen();
const browser = await chromium.launch({
  executablePath: found.path,
  args: ['--use-angle=swiftshader'],
});
const page = await browser.newPage({ viewport: { width: 1280, height: 640 } });
const { port } = server.httpServer.address();
await page.goto(`http://127.0.0.1:${port}/?ui=0&helper=1&output=surface&view=third&dpr=1`);
await page.evaluate(async () => {
  const { demo } = window;
  await demo.ready;
  demo.controls.smoothing = Infinity;
  demo.helper.size = 300;
  // On the bridge, between its railings.
  demo.character.teleport(demo.spawn.clone().set(-13.2, 3.02, -11));
  demo.controls.yaw = -0.75;
  demo.controls.pitch = -0.08;
  demo.controls.distance = 3.6;
  await demo.step(4);
});
await page.screenshot({ path: 'docs/demo.jpg', type: 'jpeg', quality: 88 });
await browser.close();
await server.close();
