import type { Page } from '@playwright/test';
import { expect, test } from './support/test.js';

// One page visits all that it shows. Its clock stands still but for the frames that it is asked for, so that what moves is
// alike on every machine: `npx playwright test looks --update-snapshots` makes the pictures anew. Look at them.

const DESK = { width: 960, height: 600 };
const PHONE = { width: 390, height: 844 };
const ON_ITS_SIDE = { width: 844, height: 390 };
/** Around the character in the picture of the desk: small, so that what is shown there is much of it. */
const CHARACTER = { x: 420, y: 350, width: 130, height: 245 };

/** What software GPUs may differ by: less than anything of what is shown takes, and than the film of free space tints. */
const LIKE = {
  page: { threshold: 0.2, maxDiffPixelRatio: 0.012 },
  character: { threshold: 0.1, maxDiffPixelRatio: 0.02 },
};

/** JPEG: a tenth of the bytes. */
async function looks(page: Page, name: string, clip?: typeof CHARACTER): Promise<void> {
  // What goes by itself may be there or not.
  const style = '#notice, #hint { visibility: hidden }';
  const picture = await page.screenshot({ type: 'jpeg', quality: 75, style, clip });
  expect.soft(picture).toMatchSnapshot(`${name}.jpg`, clip ? LIKE.character : LIKE.page);
}

/** A twentieth of a second each: few frames. */
const step = (page: Page, frames: number) =>
  page.evaluate(async (frames) => {
    for (let i = 0; i < frames; i++) {
      window.later(50);
      await window.demo.step(1, 0.05);
    }
  }, frames);

/** Walks straight on by a real key. */
async function walk(page: Page, frames: number): Promise<void> {
  await page.keyboard.down('KeyW');
  await step(page, frames);
  await page.keyboard.up('KeyW');
}

/** Shows these alone. */
const show = (page: Page, ...names: string[]) =>
  page.evaluate((names) => {
    const all = ['cubemap', 'surfels', 'contacts', 'free', 'body', 'timeline', 'numbers'] as const;
    for (const name of all) window.demo.overlays.set(name, names.includes(name));
  }, names);

/** Puts the character somewhere; where it looks, and from how far. */
const put = (page: Page, foot: number[], yaw: number, pitch: number, distance = 3) =>
  page.evaluate(
    ([foot, yaw, pitch, distance]) => {
      const { character, controls, spawn } = window.demo;
      character.teleport(spawn.clone().fromArray(foot));
      Object.assign(controls, { yaw, pitch, distance });
    },
    [foot, yaw, pitch, distance] as const,
  );

const look = (page: Page, view: 'first' | 'third') =>
  page.evaluate((view) => {
    window.demo.settings.view = view;
    window.demo.apply('view');
  }, view);

test('looks as it did: the start, the views, each overlay, the hall, on a desk and on a phone', async ({
  page,
}) => {
  test.skip(
    process.platform !== 'linux',
    'The pictures were taken on Linux; letters look otherwise elsewhere.',
  );
  test.slow();
  await page.addInitScript(() => {
    let now = 1000;
    performance.now = () => now;
    window.later = (milliseconds) => void (now += milliseconds);
    window.requestAnimationFrame = () => 0;
  });
  await page.setViewportSize(DESK);
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto('/demo/index.html?dpr=1&quality=low');
  await page.evaluate(() => window.demo.ready);
  await step(page, 4);
  await looks(page, 'start');

  await page.getByRole('button', { name: 'Walk', exact: true }).click();
  await page.evaluate(() => document.exitPointerLock());
  await page.evaluate(() => window.demo.pause.resume(false));
  await page.mouse.move(DESK.width / 2, DESK.height - 10);
  await step(page, 2);
  await looks(page, 'desk-first');
  await look(page, 'third');
  await show(page, 'cubemap', 'timeline', 'numbers');
  await walk(page, 12);
  await step(page, 8);
  await looks(page, 'desk-overlays');

  // At a wall, which it leans against.
  await put(page, [0, 0.5, -13], 0, -0.2);
  await walk(page, 5);
  await page.evaluate(() => void (window.demo.controls.yaw = -0.8));
  for (const name of ['surfels', 'contacts', 'free', 'body']) {
    await show(page, name);
    await step(page, 2);
    await looks(page, `overlay-${name}`, CHARACTER);
  }

  await show(page);
  await page.evaluate(() => {
    const { hall, controls, character } = window.demo;
    hall!.time = 2;
    character.teleport(hall!.entry);
    Object.assign(controls, { yaw: Math.PI, pitch: -0.15, distance: 4 });
  });
  await walk(page, 16);
  await page.evaluate(() => void (window.demo.controls.yaw = Math.PI - 0.3));
  await step(page, 4);
  await looks(page, 'hall');

  // A finger in place of the mouse.
  const cdp = await page.context().newCDPSession(page);
  await cdp.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 5 });
  await page.setViewportSize(PHONE);
  await page.getByRole('button', { name: 'What the collider sees' }).click();
  await page.mouse.move(PHONE.width / 2, PHONE.height / 2);
  await put(page, [0, 0.1, 2], 0, -0.1);
  await look(page, 'first');
  await step(page, 2);
  await looks(page, 'phone-first');
  await look(page, 'third');
  await show(page, 'cubemap', 'timeline', 'numbers');
  await walk(page, 6);
  await looks(page, 'phone-overlays');
  await page.setViewportSize(ON_ITS_SIDE);
  await step(page, 6);
  await looks(page, 'phone-on-its-side');
});

declare global {
  interface Window {
    /** Lets the page's clock go on. */
    later(milliseconds: number): void;
  }
}
