import type { CDPSession, Page } from '@playwright/test';
import { expect, test } from './support/test.js';

test.use({ viewport: { width: 240, height: 136 } });

/** Opens the demo and waits until one can walk; from then on it goes on by `step` alone. */
async function open(page: Page, query: string): Promise<void> {
  await page.goto(`/demo/index.html?dpr=1&${query}&quality=low`);
  await page.evaluate(async () => {
    const { demo } = window;
    await demo.ready;
    // An empty picture, which the software GPU draws at once; no frame waits for another.
    demo.camera.layers.set(31);
    demo.settings.readback = 'sync';
    demo.apply('collider');
  });
}

/** Some frames; how far it went in them along x and z, and turned, and what it does now. */
function step(page: Page, frames = 6) {
  return page.evaluate(async (frames) => {
    const { character, controls } = window.demo;
    const { x, z } = character.position;
    const { yaw, pitch } = controls;
    await window.demo.step(frames);
    return {
      x: character.position.x - x,
      z: character.position.z - z,
      yaw: controls.yaw - yaw,
      pitch: controls.pitch - pitch,
      speed: character.velocity.length(),
      rise: character.velocity.y,
      height: character.body.height,
    };
  }, frames);
}

/** Until it stands. */
async function stop(page: Page): Promise<void> {
  const stands = await page.evaluate(async () => {
    const { character, step } = window.demo;
    for (let i = 0; i < 40; i++) {
      await step(3, 0.05);
      if (character.grounded && character.velocity.length() < 0.01) return true;
    }
    return false;
  });
  expect(stands).toBe(true);
}

test('keys, mouse and gamepad each drive the character, and let go of it', async ({ page }) => {
  await page.addInitScript(() => {
    const pad = {
      mapping: 'standard',
      axes: [0, 0, 0, 0],
      buttons: Array.from({ length: 17 }, () => ({ pressed: false })),
    };
    Object.assign(window, { pad });
    navigator.getGamepads = () => [pad as unknown as Gamepad];
  });
  await open(page, 'ui=0');
  await stop(page);

  await test.step('arrows walk, Shift runs, Space jumps, C crouches', async () => {
    await page.keyboard.down('ArrowUp');
    expect((await step(page)).z).toBeLessThan(-0.1);
    await page.keyboard.down('ShiftLeft');
    expect((await step(page, 12)).speed).toBeGreaterThan(4.5);
    await page.keyboard.up('ShiftLeft');
    await page.keyboard.up('ArrowUp');
    await page.keyboard.press('Space');
    expect((await step(page, 3)).rise).toBeGreaterThan(3);
    await stop(page);
    await page.keyboard.down('KeyC');
    expect((await step(page, 3)).height).toBeCloseTo(1.1, 6);
    await page.keyboard.up('KeyC');
    expect((await step(page, 3)).height).toBeCloseTo(1.8, 6);
  });

  await test.step('arrows turn, if asked to', async () => {
    await page.evaluate(() => void (window.demo.controls.turnKeys = true));
    await page.keyboard.down('ArrowRight');
    const { yaw, speed } = await step(page);
    expect(yaw).toBeCloseTo(-0.2, 6);
    expect(speed).toBeLessThan(0.01);
    await page.keyboard.up('ArrowRight');
    await page.evaluate(() => void (window.demo.controls.turnKeys = false));
  });

  await test.step('a dragged mouse looks', async () => {
    const before = await page.evaluate(() => window.demo.controls.yaw);
    await page.mouse.move(100, 60);
    await page.mouse.down();
    await page.mouse.move(150, 60, { steps: 3 });
    await page.mouse.up();
    const after = await page.evaluate(() => window.demo.controls.yaw);
    expect(after - before).toBeCloseTo(-0.1, 6);
  });

  await test.step('a captured pointer looks, and its loss lets go of the keys', async () => {
    await page.mouse.click(100, 60);
    await expect.poll(() => page.evaluate(() => window.demo.controls.isLocked)).toBe(true);
    const before = await page.evaluate(() => window.demo.controls.yaw);
    await page.mouse.move(130, 60);
    const after = await page.evaluate(() => window.demo.controls.yaw);
    expect(after - before).toBeCloseTo(-0.06, 6);
    await page.keyboard.down('KeyS');
    expect((await step(page)).speed).toBeGreaterThan(1);
    await page.evaluate(() => document.exitPointerLock());
    await expect.poll(() => page.evaluate(() => window.demo.controls.isLocked)).toBe(false);
    await stop(page);
    await page.keyboard.up('KeyS');
    await page.evaluate(() => window.demo.pause.resume());
  });

  await test.step('the focus lost, or the tab hidden, lets go of keys and sticks', async () => {
    for (const [target, type] of [
      ['window', 'blur'],
      ['document', 'visibilitychange'],
    ] as const) {
      await page.keyboard.down('KeyD');
      await page.evaluate(() => void (window.pad.axes = [0.9, 0, 0, 0]));
      expect((await step(page)).speed).toBeGreaterThan(1);
      await page.evaluate(([target, type]) => window[target].dispatchEvent(new Event(type)), [
        target,
        type,
      ] as const);
      await stop(page);
      await page.keyboard.up('KeyD');
      await page.evaluate(() => void (window.pad.axes = [0, 0, 0, 0]));
      await page.evaluate(() => window.demo.pause.resume());
      await step(page, 2);
    }
  });

  await test.step('a gamepad walks, looks, jumps, and switches the view', async () => {
    const pad = (axes: number[], pressed: number[] = []) =>
      page.evaluate(
        ({ axes, pressed }) => {
          window.pad.axes = axes;
          window.pad.buttons.forEach((button, i) => (button.pressed = pressed.includes(i)));
        },
        { axes, pressed },
      );
    await page.evaluate(() => void (window.demo.controls.yaw = 0));
    await pad([0, -0.6, 0, 0]);
    const walk = await step(page, 15);
    expect(walk.z).toBeLessThan(-0.1);
    expect(walk.speed).toBeLessThan(2);
    await pad([0, 0, 1, 0]);
    expect((await step(page)).yaw).toBeCloseTo(-0.3, 6);
    await stop(page);
    await pad([0, 0, 0, 0], [0]);
    expect((await step(page, 3)).rise).toBeGreaterThan(3);
    await pad([0, 0, 0, 0], [3]);
    await step(page, 2);
    await pad([0, 0, 0, 0]);
    const { settings, view } = await page.evaluate(() => ({
      settings: window.demo.settings.view,
      view: window.demo.controls.view,
    }));
    expect([settings, view]).toEqual(['third', 'third']);
  });
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 240, height: 320 }, hasTouch: true, isMobile: true });

  test('one thumb walks, the other looks, two zoom, and a button jumps', async ({
    page,
    context,
  }) => {
    const cdp = await context.newCDPSession(page);
    await open(page, '');
    await page.getByRole('button', { name: 'Walk' }).tap();
    await stop(page);
    const stick = page.locator('.thumbs .stick');
    await expect(stick).toBeVisible();

    await touch(cdp, 'touchStart', [50, 220]);
    await touch(cdp, 'touchMove', [50, 165]);
    const walk = await step(page, 10);
    expect(walk.z).toBeLessThan(-0.2);
    await expect(stick).toHaveClass(/held/);
    const ring = (await stick.boundingBox())!;
    expect(Math.hypot(ring.x + ring.width / 2 - 50, ring.y + ring.height / 2 - 220)).toBeLessThan(
      5,
    );

    await touch(cdp, 'touchStart', [50, 165], [180, 150]);
    await touch(cdp, 'touchMove', [50, 165], [200, 140]);
    // The browser hands moves on with its frames.
    await expect.poll(() => page.evaluate(() => window.demo.controls.yaw)).toBeCloseTo(-0.12, 2);
    expect(await page.evaluate(() => window.demo.controls.pitch)).toBeCloseTo(0.06, 2);
    expect((await step(page, 2)).speed).toBeGreaterThan(1);
    await touch(cdp, 'touchEnd');
    await stop(page);
    await expect(stick).not.toHaveClass(/held/);

    await page.evaluate(() => void (window.demo.controls.view = 'third'));
    await touch(cdp, 'touchStart', [140, 130], [140, 180]);
    await touch(cdp, 'touchMove', [140, 122], [140, 197]);
    const distance = () => page.evaluate(() => window.demo.controls.distance);
    await expect.poll(distance).toBeCloseTo((4 * 50) / 75, 1);
    await touch(cdp, 'touchEnd');

    const jump = page.getByRole('button', { name: 'Jump' });
    const box = (await jump.boundingBox())!;
    expect(Math.min(box.width, box.height)).toBeGreaterThanOrEqual(44);
    await jump.tap();
    expect((await step(page, 3)).rise).toBeGreaterThan(3);
  });
});

/** Fingers as the browser gets them from a screen. */
function touch(cdp: CDPSession, type: 'touchStart' | 'touchMove' | 'touchEnd', ...at: number[][]) {
  const touchPoints = at.map(([x, y], id) => ({ x: x!, y: y!, id }));
  return cdp.send('Input.dispatchTouchEvent', { type, touchPoints });
}

declare global {
  interface Window {
    /** The gamepad that the page gets. */
    pad: { axes: number[]; buttons: { pressed: boolean }[] };
  }
}
