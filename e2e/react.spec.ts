import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import type { ReactHarness } from './harness/react.js';
import { buildReactPage } from './support/reactPage.js';
import { expect, test } from './support/test.js';

/** The page's `harness`, in which nothing is written on the way. */
const tell = <Result>(page: Page, read: (harness: ReactHarness) => Result) =>
  page.evaluate(`(${read.toString()})(window.harness)`) as Promise<Result>;

const place = (page: Page) => tell(page, ({ character }) => character!.position.toArray());

/** Frames no longer come. */
async function asleep(page: Page): Promise<void> {
  await expect
    .poll(
      async () => {
        const frames = () => tell(page, (harness) => harness.frames);
        const before = await frames();
        await page.waitForTimeout(300);
        return (await frames()) - before;
      },
      { timeout: 30_000 },
    )
    .toBe(0);
}

test('React: a character should walk by drei’s keys, on demand, mounted twice, where levels suspend', async ({
  page,
}) => {
  const code = await readFile('e2e/harness/react.tsx', 'utf8');
  const script = await buildReactPage(code, 'e2e/harness', 'harness');
  await page.route('**/react.html', (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<!doctype html><link rel="icon" href="data:,"><body><div id="root"></div>
        <script type="module" src="${script}"></script>`,
    }),
  );
  await page.goto('/react.html');

  await test.step('it lands, and the canvas goes to sleep', async () => {
    await expect
      .poll(() => tell(page, ({ character }) => character?.grounded ?? false), { timeout: 60_000 })
      .toBe(true);
    await asleep(page);
    expect(await place(page)).toEqual([0, expect.closeTo(0.02, 2), 0]);
    expect(await tell(page, ({ events }) => events)).toEqual(['land']);
    const all = await tell(page, ({ character, seen, collider }) => ({
      one: character === seen && character!.collider === collider,
      resolution: collider!.resolution,
      stepHeight: character!.stepHeight,
      jumpBuffer: character!.jumpBuffer,
    }));
    expect(all).toEqual({ one: true, resolution: 24, stepHeight: 0.3, jumpBuffer: 0.2 });
  });

  await test.step('keys wake it; nothing renders anew because it walks', async () => {
    const renders = await tell(page, (harness) => harness.renders);
    await page.keyboard.down('KeyW');
    await expect.poll(async () => (await place(page))[2], { timeout: 30_000 }).toBeLessThan(-0.5);
    await page.keyboard.down('Space'); // keys are asked for once a frame: a press of no time is missed
    await expect.poll(() => tell(page, ({ events }) => events.at(-1))).toBe('jump');
    await page.keyboard.up('Space');
    await page.keyboard.up('KeyW');
    await expect.poll(() => tell(page, ({ events }) => events)).toEqual(['land', 'jump', 'land']);
    await asleep(page);
    expect(await tell(page, (harness) => harness.renders)).toBe(renders);
    const [x, y, z] = await place(page);
    const avatar = await tell(page, ({ avatar }) => avatar!.parent!.position.toArray());
    expect(avatar).toEqual([x, expect.closeTo(y! - 0.02, 6), z]);
  });

  await test.step('while another level loads it is held, and goes on as the same', async () => {
    const before = await place(page);
    let release = () => {};
    const held = new Promise<void>((resolve) => (release = resolve));
    await page.route('**/level.glb?next', async (route) => {
      await held;
      await route.continue();
    });
    await page.evaluate(() => {
      window.harness.seen = window.harness.character;
      window.harness.show({ level: '/level.glb?next' });
    });
    await page.waitForTimeout(500);
    expect(await place(page)).toEqual(before);
    release();
    await expect
      .poll(() => tell(page, ({ character }) => character!.ready), { timeout: 30_000 })
      .toBe(true);
    await asleep(page);
    expect(await place(page)).toEqual(before.map((each) => expect.closeTo(each, 2)));
    expect(await tell(page, ({ character, seen }) => character === seen)).toBe(true);
  });

  await test.step('another body takes its place; taken away, it leaves nothing behind', async () => {
    const before = await place(page);
    await page.evaluate(() => window.harness.show({ height: 1.2 }));
    await expect
      .poll(() => tell(page, ({ character }) => character!.body.height), { timeout: 30_000 })
      .toBe(1.2);
    expect(await place(page)).toEqual(before.map((each) => expect.closeTo(each, 2)));
    // Until it has seen its own surroundings it has none of its textures.
    const stands = () => tell(page, ({ seen }) => seen?.grounded ?? false);
    await expect.poll(stands, { timeout: 30_000 }).toBe(true);
    await asleep(page);
    const textures = () => tell(page, ({ gl }) => gl!.info.memory.textures);
    // Twice: from where it begins, the camera sees some of the new level's textures for the first time.
    const walking: number[] = [await textures()];
    for (let i = 0; i < 2; i++) {
      await page.evaluate(() => window.harness.show({ character: false }));
      await expect.poll(textures).toBeLessThan(walking.at(-1)!);
      await page.evaluate(() => window.harness.show({ character: true }));
      await expect.poll(stands, { timeout: 30_000 }).toBe(true);
      await asleep(page);
      walking.push(await textures());
    }
    expect(walking[2]).toBe(walking[1]);
  });
});
