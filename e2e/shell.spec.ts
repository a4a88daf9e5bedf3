import type { Page } from '@playwright/test';
import axe from 'axe-core';
import { floorLevel } from './support/floorLevel.js';
import { expect, test } from './support/test.js';

/** Few pixels: the software GPU draws a large page as fast as a small one. */
const FEW = 'dpr=0.2&quality=low';
/** A level that is there at once. */
const FLOOR = '/floor.glb';
const PHONE = { width: 390, height: 844 };

async function open(page: Page, query = ''): Promise<void> {
  await page.route(FLOOR, async (route) => route.fulfill({ body: await floorLevel() }));
  await page.goto(`/demo/index.html?${FEW}&level=${FLOOR}&${query}`);
  await page.evaluate(() => window.demo.ready);
}

const frames = (page: Page) => page.evaluate(() => window.demo.renderer.info.render.frame);
const foot = (page: Page) => page.evaluate(() => window.demo.character.position.toArray());
const paused = (page: Page) => page.getByRole('dialog', { name: 'Paused' });
const walk = (page: Page) => page.getByRole('button', { name: 'Walk', exact: true }).click();

/** Waits for some frames, each drawn anew. */
async function passFrames(page: Page, count: number): Promise<void> {
  const first = await frames(page);
  await expect.poll(() => frames(page), { intervals: [50] }).toBeGreaterThan(first + count);
}

test('keeps its settings over a reload, and brings the old ones back', async ({ page }) => {
  await open(page);
  const settings = page.getByRole('dialog', { name: 'Settings' });
  await page.getByRole('button', { name: 'Settings' }).click();
  await settings.getByLabel('Field of view').fill('90');
  await settings.locator('[name=view]').selectOption('third');
  await settings.getByLabel('Motion').selectOption('reduced');
  await settings.getByRole('button', { name: 'Forward: W, change' }).click();
  await page.keyboard.press('Escape'); // leaves the key, not the dialog
  await settings.getByRole('button', { name: 'Forward: W, change' }).click();
  await page.keyboard.press('KeyC');
  await expect(settings.getByText('taken from “Crouch”')).toBeVisible();
  await settings.getByRole('button', { name: 'Done' }).click();

  await open(page);
  const kept = await page.evaluate(() => {
    const { camera, controls, settings } = window.demo;
    const { forward, crouch } = controls.keys;
    return { fov: camera.fov, view: settings.view, rate: controls.smoothing, forward, crouch };
  });
  expect(kept).toEqual({
    fov: 90,
    view: 'third',
    rate: Infinity,
    forward: ['KeyC', 'ArrowUp'],
    crouch: [],
  });
  await expect(page.locator('#keys kbd').first()).toHaveText('C');
  await walk(page);
  const [, , start] = await foot(page);
  await page.keyboard.down('KeyC');
  await expect.poll(async () => (await foot(page))[2]).toBeLessThan(start! - 0.3);
  await page.keyboard.up('KeyC');

  await page.keyboard.press('Escape');
  await paused(page).getByRole('button', { name: 'Settings' }).click();
  await settings.getByRole('button', { name: 'Reset all' }).click();
  const reset = await page.evaluate(() => [window.demo.camera.fov, window.demo.controls.keys]);
  expect(reset).toMatchObject([70, { forward: ['KeyW', 'ArrowUp'], crouch: ['KeyC'] }]);
});

test('rests while nobody walks, and goes on just there, with no key down', async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 240 });
  await open(page, 'view=third');
  await walk(page);
  await expect.poll(() => page.evaluate(() => window.demo.controls.isLocked)).toBe(true);
  const [, , start] = await foot(page);
  await page.keyboard.down('KeyW');
  await expect.poll(async () => (await foot(page))[2]).toBeLessThan(start! - 0.3);

  // As Escape does where a browser has captured the mouse.
  await page.evaluate(() => document.exitPointerLock());
  await expect(paused(page)).toBeVisible();
  await expect(page.locator('#told')).toHaveText('Paused');
  const [drawn, place] = [await frames(page), await foot(page)];
  await page.waitForTimeout(200);
  expect([await frames(page), await foot(page)]).toEqual([drawn, place]);

  await page.mouse.click(10, 10); // anywhere
  await expect(paused(page)).toBeHidden();
  await passFrames(page, 6);
  const went = (await foot(page)).map((value, i) => value - place[i]!);
  // W is still down, but nobody could have seen it come up: the step that it was in ends, 3 m/s for 1/60 s.
  expect(Math.hypot(went[0]!, went[2]!)).toBeLessThan(0.06);
  await page.keyboard.up('KeyW');

  for (const leave of [
    () => window.dispatchEvent(new Event('blur')),
    () => {
      Object.defineProperty(document, 'hidden', { value: true, configurable: true });
      document.dispatchEvent(new Event('visibilitychange'));
      Reflect.deleteProperty(document, 'hidden');
    },
  ]) {
    await page.evaluate(leave);
    await expect(paused(page)).toBeVisible();
    await page.keyboard.press('Enter');
    await expect(paused(page)).toBeHidden();
  }

  // The panel frees the mouse without a pause; Escape then is the page's own.
  const panel = page.getByRole('group', { name: 'Collider' }).getByText('read-back');
  await page.keyboard.press('KeyP');
  await expect(panel).toBeVisible();
  await expect(paused(page)).toBeHidden();
  // Its key closes it again: it took no keys.
  await page.keyboard.press('KeyP');
  await expect(panel).toBeHidden();
  await page.keyboard.press('KeyP');
  await expect(panel).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(paused(page)).toBeVisible();
  await page.getByRole('button', { name: 'Back to the start' }).click();
  await expect.poll(async () => (await foot(page))[2]).toBeCloseTo(start!, 1);

  // What lies beside the picture goes on without the mouse.
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Level…' }).click();
  await expect(paused(page)).toBeHidden();
  await expect(page.getByRole('button', { name: 'Open a level…' })).toBeVisible();
  expect(await page.evaluate(() => window.demo.controls.isLocked)).toBe(false);
});

test('leaves axe nothing to find, and no button too small for a thumb', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 720 });
  await open(page);
  await page.evaluate(axe.source);
  const look = async (state: string, ...there: string[]) => {
    for (const selector of there) await expect(page.locator(selector)).toBeVisible();
    const found = await page.evaluate(async () => {
      const { axe } = window as unknown as { axe: typeof import('axe-core') };
      const { violations } = await axe.run();
      return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join()}`);
    });
    expect.soft(found, state).toEqual([]);
  };
  const reach = async (scope: string) => {
    const boxes = await page
      .locator(`${scope} button:visible`)
      .evaluateAll((all) => all.map((button) => button.getBoundingClientRect().toJSON()));
    expect(boxes.length).toBeGreaterThan(0);
    for (const { left, right, top, bottom } of boxes as DOMRect[]) {
      expect.soft(left, scope).toBeGreaterThanOrEqual(0);
      expect.soft(right, scope).toBeLessThanOrEqual(PHONE.width);
      expect.soft(bottom, scope).toBeLessThanOrEqual(PHONE.height);
      expect.soft(bottom - top, scope).toBeGreaterThanOrEqual(42);
    }
  };
  await look('start', '#start');
  await page.setViewportSize(PHONE);
  await look('start on a phone', '#start');
  await reach('#start');
  await page.getByRole('button', { name: 'Settings' }).click();
  await look('settings on a phone', '#settings');
  await page.keyboard.press('Escape');
  await walk(page);
  await look('walking on a phone', '#pause');
  await reach('#hud');
  await page.keyboard.press('KeyP');
  await look('panel on a phone', '.lil-gui select >> nth=0');
  await page.setViewportSize({ width: 1280, height: 720 });
  await look('panel', '.lil-gui select >> nth=0', '.overlays');
  await page.keyboard.press('Escape');
  await look('paused', '#paused');
  await page.getByRole('button', { name: 'Settings' }).click();
  await look('settings', '#settings', '#paused');
});
