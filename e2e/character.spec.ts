import type { Page } from '@playwright/test';
import type { CubeColliderOptions } from 'three-cube-collider';
import type { pair } from './harness/character.js';
import { expect, runInPage, test } from './support/test.js';

// The level's plan (scripts/level): on the stage, 0.48 m high, a wall whose niche ends at z = -13.7.
const STAGE = [0, 0.5, -12] as const;
const STAGE_WALL = -13.7;
const RADIUS = 0.35;
/** What a body at rest keeps of its skin of 20 mm. */
const GAP = { least: 0.01, most: 0.025 };

async function open(page: Page, options: CubeColliderOptions = {}): Promise<void> {
  await runInPage(page, '/e2e/harness/character.ts', options);
}

const frames = (page: Page, count: number) =>
  page.evaluate((count) => window.world.frames(count), count);

test('@three walks to a wall by a key, stops a skin before it, and knows what it touches', async ({
  page,
}) => {
  await open(page);
  await page.evaluate(([x, y, z]) => window.world.put(x, y, z), STAGE);
  await page.keyboard.down('KeyW');
  await frames(page, 10);
  const [x, y, z] = await page.evaluate(() => window.world.untilItStops());
  const touched = await page.evaluate(() => window.world.touched());
  await page.keyboard.up('KeyW');

  const gap = z! - RADIUS - STAGE_WALL;
  expect(gap).toBeGreaterThan(GAP.least);
  expect(gap).toBeLessThan(GAP.most);
  expect(y! - 0.48).toBeGreaterThan(GAP.least);
  expect(y! - 0.48).toBeLessThan(GAP.most);
  expect(x).toBeCloseTo(0, 3);

  expect(touched.ground).toMatch(/^steps/);
  const wall = touched.contacts.find(({ normal }) => normal[2]! > 0.99);
  expect(wall?.object).toMatch(/^stage-wall/);
  for (const each of touched.contacts) {
    expect(each.gap).toBeGreaterThan(GAP.least);
    expect(each.gap).toBeLessThan(GAP.most);
  }
});

test('jumps by a key, and tells of it', async ({ page }) => {
  await open(page);
  await page.evaluate(([x, y, z]) => window.world.put(x, y, z), STAGE);
  await page.keyboard.press('Space');
  const highest = await page.evaluate(async () => {
    const { world } = window;
    let highest = 0;
    for (let i = 0; i < 90; i++) {
      await world.frame();
      highest = Math.max(highest, world.character.position.y);
    }
    return highest;
  });
  expect(highest - STAGE[1]).toBeGreaterThan(1.05);
  expect(highest - STAGE[1]).toBeLessThan(1.15);
  const { events, speeds, grounded } = await page.evaluate(() => {
    const { events, speeds, character } = window.world;
    return { events, speeds, grounded: character.grounded };
  });
  expect(grounded).toBe(true);
  expect(events.filter((event) => !event.startsWith('contact'))).toEqual(['leave', 'jump', 'land']);
  // Down again as fast as it went up: √(2 · 20 · 1.1).
  expect(speeds).toHaveLength(1);
  expect(Math.abs(speeds[0]! - 6.63)).toBeLessThan(0.4);
});

test('crouches while a key is held, and stands up where there is room', async ({ page }) => {
  await open(page);
  // Before the low ceiling, 1.5 m over the floor, looking west.
  await page.evaluate(async () => {
    await window.world.put(-17, 0.02, 4);
    window.world.controls.yaw = Math.PI / 2;
  });
  const height = () => page.evaluate(() => window.world.character.body.height);
  const walk = async () => {
    await page.keyboard.down('KeyW');
    await frames(page, 60);
    await page.keyboard.up('KeyW');
    return page.evaluate(async () => (await window.world.untilItStops())[0]!);
  };
  // The ceiling's edge is at x = -17.85.
  expect(await walk()).toBeGreaterThan(-17.85);
  await page.keyboard.down('KeyC');
  await frames(page, 2);
  expect(await height()).toBe(1.1);
  const under = await walk();
  expect(under).toBeLessThan(-18.5);
  expect(under).toBeGreaterThan(-21);
  await page.keyboard.up('KeyC');
  await frames(page, 5);
  expect(await height()).toBe(1.1);
  await page.keyboard.down('KeyS');
  await frames(page, 100);
  await page.keyboard.up('KeyS');
  expect(await height()).toBe(1.8);
});

for (const options of [{}, { readback: 'sync' }] satisfies CubeColliderOptions[]) {
  test(`rides a lift without slipping: ${JSON.stringify(options)}`, async ({ page }) => {
    await open(page, options);
    const ride = await page.evaluate(() => window.world.ride(4));
    console.log(
      `    slipped ${(1000 * ride.slip).toFixed(2)} mm, gap ${(1000 * ride.lowest).toFixed(1)} to ` +
        `${(1000 * ride.highest).toFixed(1)} mm`,
    );
    expect(ride.rode).toBeGreaterThan(0.5);
    expect(ride.slip).toBeLessThan(0.01);
    expect(ride.lowest).toBeGreaterThan(GAP.least);
    expect(ride.highest).toBeLessThan(GAP.most);
    expect(ride.grounds).toBe(ride.frames);
    expect(await page.evaluate(() => window.world.touched().ground)).toBe('lift');
  });
}

test('walks as two as each does alone', async ({ page }) => {
  await page.goto('/e2e/harness/index.html');
  const report = await page.evaluate(async (url): Promise<Awaited<ReturnType<typeof pair>>> => {
    const harness = await import(/* @vite-ignore */ url);
    return harness.pair();
  }, '/e2e/harness/character.ts');
  expect(report.apart).toEqual([0, 0]);
  for (const walked of report.walked) expect(walked).toBeGreaterThan(2.5);
});
