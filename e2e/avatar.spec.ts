import type { Page } from '@playwright/test';
import { expect, test } from './support/test.js';

// A small picture: the software GPU draws it several times as fast.
test.use({ viewport: { width: 240, height: 136 } });

/** Goes on by that many frames, 1/15 s each, and tells which clips came to show, in that order. */
const watch = (page: Page, frames: number) =>
  page.evaluate(async (frames) => {
    const { demo } = window;
    const seen: string[] = [];
    const names = ['idle', 'walk', 'run', 'jump', 'fall', 'land', 'crouch', 'sneak'] as const;
    for (let i = 0; i < frames; i++) {
      await demo.step(1, 1 / 15);
      for (const name of names)
        if (demo.avatar.moves!.weight(name) > 0.3 && !seen.includes(name)) seen.push(name);
    }
    return seen;
  }, frames);

test('the avatar stands, walks, runs, leaps, falls, lands and crouches by the keys, a ghost to its own cubemap', async ({
  page,
}) => {
  await page.goto('/demo/index.html?dpr=1&quality=low&ui=0&view=third');
  await page.evaluate(() => window.demo.ready);
  expect(await watch(page, 2)).toEqual(['idle']);

  await page.keyboard.down('KeyW');
  expect((await watch(page, 5)).at(-1)).toBe('walk');
  await page.keyboard.down('ShiftLeft');
  expect((await watch(page, 6)).at(-1)).toBe('run');
  await page.keyboard.up('KeyW');
  await page.keyboard.up('ShiftLeft');
  expect((await watch(page, 8)).at(-1)).toBe('idle');
  await page.keyboard.press('Space');
  const leap = await watch(page, 15);
  expect(leap.filter((name) => name !== 'idle')).toEqual(['jump', 'fall', 'land']);
  await page.keyboard.down('KeyC');
  expect((await watch(page, 4)).at(-1)).toBe('crouch');

  const { drawn, seen } = await page.evaluate(() => {
    const { avatar, collider } = window.demo;
    const seen = new Set(collider.field!.objects);
    const parts: string[] = [];
    avatar.object.traverse((part) => {
      if (seen.has(part as never)) parts.push(part.name);
    });
    return { drawn: avatar.object.visible, seen: parts };
  });
  expect(drawn).toBe(true);
  expect(seen).toEqual([]);
});
