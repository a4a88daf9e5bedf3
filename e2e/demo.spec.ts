import type { Page } from '@playwright/test';
import { expect, test } from './support/test.js';

// The level's plan (scripts/level): the start looks along -Z; ahead lie eight steps of 0.06 m and a wall whose niche
// ends at z = -13.7; behind, from z = 14 to z = 18, the pit, and a footbridge along x = 0 over it. The character's radius is 0.35 m.
const STAGE_HEIGHT = 0.48;
const STAGE_WALL = -13.7;
const PIT_EDGE = 14;
const PIT_END = 18;
/** East of the footbridge over the pit. */
const BESIDE_BRIDGE = 1.4;
const RADIUS = 0.35;
/** What the body keeps to what it touches: 20 mm at rest. */
const [LEAST_GAP, MOST_GAP] = [0.01, 0.025];

/** Opens the demo and waits until one can walk. */
async function open(page: Page, query: string): Promise<void> {
  await page.goto(`/demo/index.html?dpr=1&${query}&quality=low`);
  await page.evaluate(() => window.demo.ready);
}

/** Looks soon again: a poll's own waits grow to a second. */
const soon = { intervals: [100], timeout: 20_000 };

const foot = (page: Page) => page.evaluate(() => window.demo.character.position.toArray());

/** Where the character ends up, however slow the machine: looks until it has stood still for a few frames. */
async function whereItStops(page: Page): Promise<number[]> {
  return page.evaluate(async () => {
    const { demo } = window;
    const last = demo.character.position.clone();
    let waited = 0;
    for (let still = 0; still < 6;) {
      const frame = demo.renderer.info.render.frame;
      while (demo.renderer.info.render.frame === frame) await new Promise(requestAnimationFrame);
      // Standing for want of a field, held, slowed to nothing or by the word of an old one, is no stop: on a busy machine
      // one may take that long.
      const { held, slowed } = demo.character.stats;
      const { field, stats } = demo.collider;
      const stands =
        held + slowed === waited &&
        field?.serial === stats.draws &&
        demo.character.position.distanceTo(last) < 1e-3;
      still = stands ? still + 1 : 0;
      waited = held + slowed;
      last.copy(demo.character.position);
    }
    return last.toArray();
  });
}

test.describe('walking', () => {
  // A small picture: the software GPU draws it several times as fast.
  test.use({ viewport: { width: 240, height: 136 } });

  test('walks up the gentle steps, switching views, and stops at the wall', async ({ page }) => {
    await open(page, '');
    await page.getByRole('button', { name: 'Walk' }).click();
    await expect(page.locator('#start')).toBeHidden();
    const [, , start] = await foot(page);

    await page.keyboard.down('ShiftLeft');
    await page.keyboard.down('KeyW');
    await expect.poll(async () => (await foot(page))[2], soon).toBeLessThan(start! - 1);

    // Walking on, the camera leaves the head and comes back.
    const cameraBehind = () =>
      page.evaluate(() => window.demo.camera.position.z - window.demo.character.position.z);
    const avatarDrawn = () => page.evaluate(() => window.demo.character.avatar?.visible);
    await expect.poll(cameraBehind, soon).toBe(0);
    expect(await avatarDrawn()).toBe(false);
    await page.keyboard.press('KeyV');
    await expect.poll(cameraBehind, soon).toBeGreaterThan(2);
    expect(await avatarDrawn()).toBe(true);
    await page.keyboard.press('KeyV');
    await expect.poll(cameraBehind, soon).toBe(0);
    expect(await avatarDrawn()).toBe(false);

    const [x, y, z] = await whereItStops(page);
    await page.keyboard.up('KeyW');
    await page.keyboard.up('ShiftLeft');
    expect(x).toBeCloseTo(0, 1);
    for (const gap of [y! - STAGE_HEIGHT, z! - RADIUS - STAGE_WALL]) {
      expect(gap).toBeGreaterThan(LEAST_GAP);
      expect(gap).toBeLessThan(MOST_GAP);
    }
  });

  test('walks into the hall with ?renderer=webgpu, and says so', async ({ page }) => {
    // `window.demo` comes once the renderer is there.
    await page.goto('/demo/index.html?dpr=1&quality=low&renderer=webgpu&place=hall');
    await page.waitForFunction(() => window.demo !== undefined);
    await page.evaluate(() => window.demo.ready);
    await page.getByRole('button', { name: 'Walk' }).click();
    const row = page.locator('.lil-gui .lil-controller', { hasText: 'drawn by' });
    await expect(row.locator('input')).toHaveValue('WebGPU');
    const [, , start] = await foot(page);
    await page.keyboard.down('KeyW');
    await page.evaluate(() => window.demo.step(15));
    await page.keyboard.up('KeyW');
    const [, , z] = await foot(page);
    expect(z! - start!).toBeGreaterThan(0.4);

    // A rival walks on from there, and ours again.
    for (const id of ['bvh', 'cube'] as const) {
      await page.evaluate((id) => window.demo.race.choose(id), id);
      await page.keyboard.down('KeyW');
      const way = await page.evaluate(async () => {
        const { demo } = window;
        await demo.step(4);
        const { z } = demo.race.character.position;
        await demo.step(10);
        return demo.race.character.position.z - z;
      });
      await page.keyboard.up('KeyW');
      expect(way, id).toBeGreaterThan(0.25);
    }
    expect(await page.evaluate(() => window.demo.race.current)).toBe('cube');
  });

  test('falls into the pit and comes back at the start', async ({ page }) => {
    await open(page, 'ui=0');
    // From just before its edge, backward, beside the footbridge.
    await page.evaluate(
      ([x, z]) => {
        const { character, spawn } = window.demo;
        character.teleport(spawn.clone().setX(x!).setZ(z!));
      },
      [BESIDE_BRIDGE, PIT_EDGE - 1],
    );
    await page.keyboard.down('KeyS');
    await expect.poll(async () => (await foot(page))[1], soon).toBeLessThan(-1);
    await page.keyboard.up('KeyS');
    await expect.poll(async () => (await foot(page))[1], soon).toBeGreaterThan(-0.1);
    await expect(page.locator('#notice')).toHaveText('Back at the start');
    const spawn = await page.evaluate(() => window.demo.spawn.toArray());
    const end = await whereItStops(page);
    end.forEach((value, i) => expect(Math.abs(value - spawn[i]!)).toBeLessThan(0.05));
    expect(await page.evaluate(() => window.demo.character.grounded)).toBe(true);
  });

  test('stays dry on the straight way to the hall', async ({ page }) => {
    await open(page, 'ui=0');
    const walked = await page.evaluate(async (z) => {
      const { demo } = window;
      demo.character.teleport(demo.spawn.clone().setZ(z));
      await demo.step(6);
      const south = demo.spawn.clone().set(0, 0, 3);
      let lowest = Infinity;
      for (let i = 0; i < 45; i++) {
        demo.character.walk(south);
        await demo.step(1, 0.05);
        lowest = Math.min(lowest, demo.character.position.y);
      }
      return { lowest, end: demo.character.position.z };
    }, PIT_EDGE - 1.5);
    expect(walked.lowest).toBeGreaterThan(0);
    expect(walked.end).toBeGreaterThan(PIT_END + 0.5);
  });

  test('goes on where it is with another collider', async ({ page }) => {
    await open(page, 'ui=0');
    await page.evaluate(() => window.demo.step(6));
    const before = await foot(page);
    const resolution = await page.evaluate(async () => {
      const { demo } = window;
      Object.assign(demo.settings, { resolution: 16, helper: true });
      demo.apply('collider');
      await demo.step(4);
      return demo.collider.field?.resolution;
    });
    expect(resolution).toBe(16);
    (await foot(page)).forEach((value, i) => expect(value).toBeCloseTo(before[i]!, 2));
  });

  test('walks on with the paper’s response, and with its six maxima', async ({ page }) => {
    await open(page, 'ui=0');
    const walked = await page.evaluate(async () => {
      const { demo } = window;
      const walk = demo.spawn.clone().set(0, 0, -3);
      const ways: number[] = [];
      for (const [response, output] of [
        ['slide', 'surface'],
        ['axis', 'surface'],
        ['axis', 'axis'],
        ['slide', 'surface'],
      ] as const) {
        Object.assign(demo.settings, { response, output });
        demo.apply(output === demo.collider.output ? 'response' : 'collider');
        await demo.step(10);
        const { z } = demo.character.position;
        for (let i = 0; i < 20; i++) {
          demo.character.walk(walk);
          await demo.step(1);
        }
        ways.push(z - demo.character.position.z);
      }
      return ways;
    });
    // A third of a second at 3 m/s.
    for (const way of walked) expect(Math.abs(way - 1)).toBeLessThan(0.15);
  });

  test('rides its lift up to the balcony', async ({ page }) => {
    await open(page, 'ui=0');
    const ride = await page.evaluate(async () => {
      const { demo } = window;
      demo.movers!.time = 0;
      demo.character.teleport(demo.spawn.clone().set(-24.75, 0.2, -7.2));
      await demo.step(20);
      const began = demo.character.position.clone();
      const ground = demo.character.ground?.object?.name;
      await demo.step(65, 0.1);
      return { ground, way: demo.character.position.clone().sub(began).toArray() };
    });
    expect(ride.ground).toBe('lift');
    expect(Math.hypot(ride.way[0]!, ride.way[2]!)).toBeLessThan(0.01);
    expect(ride.way[1]).toBeCloseTo(2.9, 2);
  });
});

test('looks as it did in first and in third person', async ({ page }) => {
  await page.setViewportSize({ width: 640, height: 360 });
  await open(page, 'ui=0&helper=1&quality=high');
  await page.evaluate(async () => {
    const { demo } = window;
    // However many frames the page has drawn by now, it stands.
    const { position } = demo.character;
    for (let last = Infinity, i = 0; i < 10 && Math.abs(position.y - last) > 1e-5; i++) {
      last = position.y;
      await demo.step(3);
    }
    demo.movers!.time = 0;
    await demo.step(3);
  });
  await expect(page).toHaveScreenshot('first-person.png');
  await page.evaluate(async () => {
    const { demo } = window;
    demo.controls.smoothing = Infinity;
    demo.controls.view = 'third';
    demo.controls.yaw = -0.6;
    demo.controls.pitch = -0.12;
    await demo.step(2);
  });
  await expect(page).toHaveScreenshot('third-person.png');
});

test.describe('without its level', () => {
  test.use({ allowedMessages: [/404|could not be loaded/] });

  test('says which level failed to load', async ({ page }) => {
    await open(page, 'level=/no-such-level.glb');
    const alert = page.getByRole('alert');
    await expect(alert).toContainText('/no-such-level.glb');
    await expect(alert).toContainText('?level=');
    await expect(page.getByRole('button', { name: 'Try again' })).toBeVisible();
  });
});
