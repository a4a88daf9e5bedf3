// The moving picture of the demo: walked with real keys, a picture at a time, in the page itself.

import { statSync } from 'node:fs';
import sharp from 'sharp';

const FILE = 'docs/demo.webp';
const SIZE = { width: 640, height: 360 };
/** Pictures a second; no fewer, for a character takes no longer frames. */
const RATE = 10;
/** What a reader of README may be asked to load, bytes, and the qualities tried for it. */
const LARGEST = 1.49e6;
const QUALITIES = [62, 54, 46, 38, 30];

/** Each begins at a place of its own, run in the page, and goes on for some seconds with keys held down. */
const SCENES = [
  {
    query: 'helper=1',
    seconds: 3.5,
    keys: ['KeyW'],
    // Over the bridge, along its railing.
    async begin() {
      const { demo } = window;
      demo.helper.size = 190;
      demo.character.teleport(demo.spawn.clone().set(-22.4, 3.02, -10.6));
      demo.controls.yaw = -1.42;
      demo.controls.pitch = -0.1;
      demo.controls.distance = 3.8;
      await demo.step(4);
    },
    each() {},
  },
  {
    query: 'place=hall',
    seconds: 2.5,
    keys: ['KeyW', 'ShiftLeft'],
    // Through the hole of the fence.
    async begin() {
      const { demo } = window;
      const { entry } = demo.hall;
      demo.character.teleport(demo.spawn.clone().set(entry.x, entry.y + 0.1, entry.z + 4.5));
      demo.controls.pitch = -0.12;
      await demo.step(6);
    },
    each() {},
  },
  {
    query: 'place=hall',
    seconds: 3,
    keys: [],
    // On the creature's back.
    async begin() {
      const { demo } = window;
      const { hall, character } = demo;
      hall.time = 40;
      hall.update(0, character.position);
      hall.root.updateMatrixWorld(true);
      const back = hall.creature.joint(3.2).getWorldPosition(demo.spawn.clone());
      character.teleport(back.setY(back.y + 1.1));
      demo.controls.yaw = -0.68;
      demo.controls.pitch = -0.46;
      demo.controls.distance = 5.6;
      await demo.step(12);
    },
    each: () => void (window.demo.controls.yaw += 0.01),
  },
];

/** @param {(query: string, size: object) => Promise<import('@playwright/test').Page>} open the demo, ready */
export async function makeMovingPicture(open) {
  const pictures = [];
  for (const { query, seconds, keys, begin, each } of SCENES) {
    const page = await open(query, SIZE);
    await page.evaluate(begin);
    await page.evaluate(() => (window.demo.controls.smoothing = 1));
    for (const key of keys) await page.keyboard.down(key);
    for (let i = 0; i < seconds * RATE; i++) {
      await page.evaluate(each);
      await page.evaluate((delta) => window.demo.step(1, delta), 1 / RATE);
      pictures.push(await page.screenshot());
    }
    await page.close();
  }
  for (const quality of QUALITIES) {
    await sharp(pictures, { join: { animated: true } })
      .webp({ quality, effort: 5, loop: 0, delay: pictures.map(() => Math.round(1000 / RATE)) })
      .toFile(FILE);
    const { size } = statSync(FILE);
    console.log(`${FILE}: ${pictures.length} pictures, quality ${quality}, ${size} bytes`);
    if (size <= LARGEST) return;
  }
  throw new Error(`${FILE} is larger than ${LARGEST} bytes, whatever its quality.`);
}
