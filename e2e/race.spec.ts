import type { Page } from '@playwright/test';
import { expect, test } from './support/test.js';

// A small picture: the software GPU draws it several times as fast.
test.use({
  viewport: { width: 400, height: 400 },
  // Of the rival whose file does not come.
  allowedMessages: [/Failed to load resource/],
});

// The hall's floor is at 0; x to the east, z to the south (demo/hall/createHall.ts).
const HILL = { x: 7.4, y: 1.2, z: 5 };
const WAVES = { x: 8, y: 0.8, z: 13.4 };
/** A twentieth of a second: all that Octree's own example lives through at once. */
const DT = 0.05;

/** Opens the demo in its hall and the panel in it, by its key, which lets nobody else walk yet. From here on the page goes on by hand, alike on every machine. */
async function open(page: Page): Promise<void> {
  // Else the mouse would be captured and could not press the panel's buttons.
  await page.addInitScript(() => {
    Element.prototype.requestPointerLock = () => Promise.reject(new Error('refused'));
  });
  await page.goto('/demo/index.html?dpr=0.2&quality=low&place=hall');
  await page.evaluate(() => window.demo.ready);
  await page.getByRole('button', { name: 'Walk', exact: true }).click();
  await page.keyboard.press('KeyR');
  await expect(page.getByText('moved by another library. Choose one')).toBeVisible();
  await expect(page.getByRole('button', { name: /^Compare Cube collider/ })).toBeVisible();
  await page.evaluate(() => window.demo.step(2));
}

/** Lives through so many twentieths of a second. Returns the foot of who walks, in the hall's frame. */
const live = (page: Page, frames: number) =>
  page.evaluate(
    async ({ frames, dt }) => {
      const { demo } = window;
      await demo.step(frames, dt);
      demo.race.look();
      return demo.hall!.root.worldToLocal(demo.race.character.position.clone());
    },
    { frames, dt: DT },
  );

/** Puts ours somewhere in the hall. */
const put = (page: Page, at: { x: number; y: number; z: number }) =>
  page.evaluate((at) => {
    const { character, hall, spawn } = window.demo;
    hall!.time = 2;
    character.teleport(hall!.root.localToWorld(spawn.clone().copy(at)));
  }, at);

/** Is the capsule of ours to be seen? */
const shown = (page: Page) =>
  page.evaluate(() =>
    window.demo.scene.children.some(({ type, visible }) => type === 'CharacterHelper' && visible),
  );

const rowOf = (page: Page, name: string) => page.getByRole('row', { name });

/** Lets another one walk on. */
async function choose(page: Page, name: string): Promise<void> {
  const button = rowOf(page, name).getByRole('button');
  await button.click();
  await expect(button).toHaveAttribute('aria-pressed', 'true', { timeout: 60_000 });
}

/** Holds a real key for a quarter of a second. Returns how far south that went, metres. */
async function walk(page: Page): Promise<number> {
  const before = await live(page, 0);
  await page.keyboard.down('KeyW');
  const after = await live(page, 5);
  await page.keyboard.up('KeyW');
  return after.z - before.z;
}

/** Of a row: milliseconds until the first step, megabytes, median and worst milliseconds of a frame, millimetres inside. */
async function numbersOf(page: Page, name: string): Promise<number[]> {
  const texts = await rowOf(page, name).getByRole('cell').allTextContents();
  return texts.flatMap((text) => text.split(' / ').map((part) => Number(part.replace('<', ''))));
}

test('should let rivals walk on, and fall through what moves; ours stays on', async ({ page }) => {
  await open(page);

  await page.evaluate(() => window.demo.overlays.set('body', true));

  // Without a network ours walks on; the next time the rival comes.
  await page.route('**/OctreeWalker*', (route) => route.abort());
  await page.keyboard.press('KeyR');
  await expect(page.locator('#race')).toContainText('Octree could not be loaded');
  // Tests draw by software, and it says so.
  await expect(page.locator('#race')).toContainText('No GPU here');
  await expect(rowOf(page, 'Cube collider').getByRole('button')).toHaveAttribute(
    'aria-pressed',
    'true',
  );
  expect(await walk(page)).toBeGreaterThan(0.4);
  await page.unroute('**/OctreeWalker*');

  for (const [name, place] of [
    ['Octree', HILL],
    ['three-mesh-bvh', WAVES],
    ['Rapier', HILL],
  ] as const) {
    await choose(page, 'Cube collider');
    await put(page, place);
    const ours = await live(page, 8);
    const [, , , , gap] = await numbersOf(page, 'Cube collider');
    expect(await shown(page)).toBe(true);
    await choose(page, name);
    const fallen = await live(page, 7);
    // What is known of ours is nothing that the rival walks by.
    expect(await shown(page)).toBe(false);
    await expect(page.locator('.overlay-list .resting')).toBeVisible();
    const walked = await walk(page);
    const [build, bytes, median, worst, inside] = await numbersOf(page, name);
    console.log(
      `    ${name}: from ${ours.y.toFixed(2)} m to ${fallen.y.toFixed(2)} m, built in ${build} ms, ` +
        `${bytes} MB, ${median} ms a frame, ${inside} mm inside`,
    );
    expect.soft(ours.y, name).toBeGreaterThan(0.1);
    expect.soft(gap, name).toBe(0);
    expect.soft(Math.abs(fallen.y), name).toBeLessThan(0.05);
    expect.soft(walked, name).toBeGreaterThan(0.4);
    expect.soft(build, name).toBeGreaterThan(1);
    expect.soft(bytes, name).toBeGreaterThan(0.5);
    expect.soft(median, name).toBeGreaterThanOrEqual(0.1);
    expect.soft(worst, name).toBeGreaterThanOrEqual(median!);
    expect.soft(inside, name).toBeGreaterThan(50);
    await expect.soft(page.locator('#race')).toContainText(`${name} falls through: the`);
  }
  await expect(page.locator('#race')).toContainText(
    'Cannot see what moves by skin, morph or shader',
  );

  // Ours is lifted out of where the rival had got to, and stands on it.
  await page.keyboard.press('KeyR');
  const back = await live(page, 8);
  expect(back.y).toBeGreaterThan(0.1);
  const [build, bytes, , , gap] = await numbersOf(page, 'Cube collider');
  expect(build).toBeGreaterThan(1);
  expect(bytes).toBeLessThan(20);
  expect(gap).toBe(0);
});
