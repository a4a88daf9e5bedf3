import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { asFiles, asGlb, type Droppable, yard } from './support/levelFiles.js';
import { expect, test } from './support/test.js';

/** How far above its ground the foot may be, metres. */
const STANDS = 0.06;
const soon = { intervals: [100], timeout: 30_000 };

// A desktop's page with a coarse picture: the software GPU draws it several times as fast.
test.use({ viewport: { width: 800, height: 500 } });
const COARSE = 'dpr=0.3&quality=low';

/** Opens the demo in a small level, and waits until one can walk. */
async function open(page: Page, query = ''): Promise<void> {
  await page.goto(`/demo/index.html?${COARSE}&level=/examples/maze.glb&${query}`);
  await page.waitForFunction(() => window.demo !== undefined);
  await page.evaluate(() => window.demo.ready);
}

/** Drops files on the page, as a hand would; waits until it has taken them or said why not. */
async function drop(page: Page, files: Droppable[], padding = 0): Promise<void> {
  const coded = files.map(({ name, bytes }) => ({
    name,
    code: Buffer.from(bytes).toString('base64'),
  }));
  await page.evaluate(
    ({ coded, padding }) => {
      const data = new DataTransfer();
      for (const { name, code } of coded) {
        const bytes = Uint8Array.from(atob(code), (letter) => letter.charCodeAt(0));
        data.items.add(new File([bytes, new Uint8Array(padding)], name));
      }
      for (const type of ['dragenter', 'dragover', 'drop']) {
        const event = new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true });
        document.querySelector('#picture')!.dispatchEvent(event);
        const target = document.querySelector<HTMLElement>('.level-target')!;
        if (target.hidden !== (type !== 'dragover')) throw new Error(`target at ${type}`);
      }
    },
    { coded, padding },
  );
  await settled(page);
}

async function settled(page: Page): Promise<void> {
  await page.waitForFunction(() => {
    const news = document.querySelector<HTMLElement>('.level-news')!;
    return news.hidden || news.dataset.kind !== 'busy';
  });
}

const foot = (page: Page) => page.evaluate(() => window.demo.character.position.toArray());

/** It stands, on ground of that height if one is named, and goes on by a real key. */
async function standsAndWalks(page: Page, ground?: number): Promise<void> {
  await expect(page.locator('#start')).toBeHidden();
  await expect.poll(() => page.evaluate(() => window.demo.character.grounded), soon).toBe(true);
  const from = await foot(page);
  const [, y] = from;
  if (ground !== undefined) expect(Math.abs(y! - ground)).toBeLessThan(STANDS);
  else expect(y).toBeGreaterThan(await page.evaluate(() => window.demo.level!.bounds.min.y - 0.1));
  await page.keyboard.down('KeyW');
  const way = async () => {
    const [x, , z] = await foot(page);
    return Math.hypot(x! - from[0]!, z! - from[2]!);
  };
  await expect.poll(way, soon).toBeGreaterThan(0.3);
  await page.keyboard.up('KeyW');
}

const placing = (page: Page) => page.evaluate(() => window.demo.level!.placing);

/** What the menu makes of the level, by real clicks; it stands where that puts it, and the menu tells how large that is. */
async function adjusts(page: Page): Promise<void> {
  const panel = page.getByRole('region', { name: 'Level', exact: true });
  const is = async (expected: object, size: string, ground: number | null) => {
    expect(await placing(page)).toEqual(expected);
    await expect(panel.locator('legend')).toHaveText(`yard.glb: ${size} m`);
    await expect.poll(() => page.evaluate(() => window.demo.character.grounded), soon).toBe(true);
    const [, y] = await foot(page);
    if (ground !== null) expect(Math.abs(y! - ground), size).toBeLessThan(STANDS);
  };
  await page.getByRole('button', { name: 'Level', exact: true }).click();
  await panel.getByRole('button', { name: 'Larger' }).click();
  await is({ up: '+Y', scale: 1.25, floor: false }, '20 × 4.3 × 15', 0);
  await panel.getByLabel('Scale').fill('0.5');
  await page.keyboard.press('Enter');
  await is({ up: '+Y', scale: 0.5, floor: false }, '8 × 1.7 × 6.1', 0);
  await panel.getByLabel('Scale').fill('-3');
  await page.keyboard.press('Enter');
  await expect(panel.getByLabel('Scale')).toHaveValue('0.5');
  await panel.getByLabel('Up axis').selectOption('+Z');
  await is({ up: '+Z', scale: 0.5, floor: false }, '8 × 6.1 × 1.7', null);
  await panel.getByLabel('Floor below').check();
  const bottom = await page.evaluate(() => window.demo.level!.bounds.min.y);
  await is({ up: '+Z', scale: 0.5, floor: true }, '8 × 6.1 × 1.7', bottom);
  await panel.getByRole('button', { name: 'Reset' }).click();
  await is({ up: '+Y', scale: 1, floor: false }, '16 × 3.4 × 12', 0);

  // The keys walk again at once, to a start of one's own, and from there.
  const start = await foot(page);
  await standsAndWalks(page, 0);
  await panel.getByRole('button', { name: 'Start here' }).click();
  const here = await foot(page);
  await standsAndWalks(page, 0);
  await panel.getByRole('button', { name: 'Back to start' }).click();
  await expect.poll(() => page.evaluate(() => window.demo.character.grounded), soon).toBe(true);
  const way = (from: number[], to: number[]) => Math.hypot(from[0]! - to[0]!, from[2]! - to[2]!);
  expect(way(await foot(page), here)).toBeLessThan(0.1);
  expect(way(start, here)).toBeGreaterThan(0.3);
}

test('walks in what is dropped, however it is measured, turned and packed', async ({ page }) => {
  await open(page);

  await drop(page, [await asGlb('yard.glb', yard())]);
  await standsAndWalks(page, 0);
  expect(await placing(page)).toEqual({ up: '+Y', scale: 1, floor: false });
  await expect(page.locator('.level-news')).toContainText('yard.glb is 16 × 3.4 × 12 m');
  await test.step('is adjusted under “Level”', () => adjusts(page));

  await drop(page, [await asGlb('centimetres.glb', yard({ units: 100 }))]);
  await standsAndWalks(page, 0);
  expect(await placing(page)).toEqual({ up: '+Y', scale: 0.01, floor: false });

  await drop(page, [await asGlb('z-up.glb', yard({ zUp: true }))]);
  await standsAndWalks(page, 0);
  expect(await placing(page)).toEqual({ up: '+Z', scale: 1, floor: false });

  await drop(page, await asFiles('yard.gltf', yard({ textured: true })));
  await standsAndWalks(page, 0);
  const picture = await page.evaluate(() => {
    const mesh = window.demo.scene.getObjectByName('ground') as {
      material?: { map?: { image?: { width: number } } };
    };
    return mesh.material?.map?.image?.width;
  });
  expect(picture).toBe(2);

  for (const name of ['draco.glb', 'ktx2.glb']) {
    await drop(page, [{ name, bytes: await readFile(`e2e/support/${name}`) }]);
    expect(await page.evaluate(() => window.demo.level!.name)).toBe(name);
    await standsAndWalks(page, 0);
  }

  // What a clip moves carries.
  await drop(page, [await asGlb('lift.glb', yard({ lift: true }))]);
  const heights: number[] = [];
  const carried = () =>
    page.evaluate(() => {
      const { ground, position } = window.demo.character;
      return ground?.object?.name === 'lift' ? position.y : NaN;
    });
  await expect
    .poll(async () => {
      const y = await carried();
      if (!Number.isNaN(y)) heights.push(y);
      return Math.max(...heights) - Math.min(...heights);
    }, soon)
    .toBeGreaterThan(0.4);

  // Compressed by meshopt, out of the list.
  await page.getByRole('button', { name: 'Level', exact: true }).click();
  await page.getByRole('button', { name: /^Valley/ }).click();
  await settled(page);
  expect(await page.evaluate(() => window.demo.level!.name)).toBe('valley.glb');
  await standsAndWalks(page);
});

test('says what is wrong with a file, at once though it be 100 MB, and goes on in the level that is there', async ({
  page,
}) => {
  await open(page);
  const { bytes } = await asGlb('', yard());
  const [bin, gltf] = await asFiles('yard.gltf', yard());
  const text = new TextEncoder().encode('Kaydara FBX Binary');
  const broken = bytes.slice();
  broken.fill(7, 40, 60);
  const news = page.locator('.level-news');
  for (const [files, says] of [
    [[{ name: 'broken.glb', bytes: broken }], /“broken.glb” is broken.*export it again/],
    [[{ name: 'half.glb', bytes: bytes.slice(0, 900) }], /“half.glb” is cut off/],
    [[{ name: 'empty.glb', bytes: new Uint8Array(0) }], /“empty.glb” is empty/],
    [[{ name: 'castle.fbx', bytes: text }], /“castle.fbx” is no glTF file: export it as .glb/],
    [[gltf!], /“yard.gltf” needs “yard.bin”: drop the two together/],
    [[bin!], /“yard.bin” holds only the numbers/],
  ] as const) {
    await drop(page, [...files]);
    await expect(news).toHaveText(new RegExp(says.source));
    await expect(news).toHaveAttribute('role', 'alert');
  }
  // 100 MB: of rubbish, then of a level.
  await page.evaluate(() => {
    let last = performance.now();
    const longest = { gap: 0 };
    Object.assign(window, { longest });
    setInterval(() => {
      longest.gap = Math.max(longest.gap, performance.now() - last);
      last = performance.now();
    }, 20);
  });
  await drop(page, [{ name: 'rubbish.glb', bytes: new Uint8Array(100) }], 100e6);
  await expect(news).toContainText('“rubbish.glb” is broken');
  expect(await page.evaluate(() => window.demo.level!.name)).toBe('maze.glb');
  await page.getByRole('button', { name: 'Walk', exact: true }).click();
  await standsAndWalks(page, 0);
  // The file says how long it is, and that its numbers go on with zeros.
  const padded = bytes.slice();
  const view = new DataView(padded.buffer);
  const chunk = 20 + view.getUint32(12, true);
  view.setUint32(8, view.getUint32(8, true) + 100e6, true);
  view.setUint32(chunk, view.getUint32(chunk, true) + 100e6, true);
  await drop(page, [{ name: 'padded.glb', bytes: padded }], 100e6);
  await standsAndWalks(page, 0);
  expect(
    await page.evaluate(() => (window as unknown as { longest: { gap: number } }).longest.gap),
  ).toBeLessThan(5000);
});

test('frees a level when another takes its place, its own with the hall too', async ({ page }) => {
  await page.goto(`/demo/index.html?${COARSE}&ui=0`);
  await page.evaluate(() => window.demo.ready);
  const bytes = [...(await asGlb('', yard({ textured: true }))).bytes];
  const held = await page.evaluate(async (bytes) => {
    const { demo } = window;
    const counts: number[][] = [];
    for (let i = 0; i < 3; i++) {
      const file = new File([new Uint8Array(bytes)], 'yard.glb');
      await demo.levels.open([{ path: file.name, file }]);
      // What was drawn near the last level's large meshes is kept for some draws.
      await demo.step(12);
      const { geometries, textures } = demo.renderer.info.memory;
      counts.push([geometries, textures]);
    }
    return { counts, gone: demo.movers === null && demo.hall === null };
  }, bytes);
  expect(held.gone).toBe(true);
  expect(held.counts[1]).toEqual(held.counts[0]);
  expect(held.counts[2]).toEqual(held.counts[0]);
  // The avatar, the sky, five boxes, and what the collider and the shadows hold.
  expect(held.counts[0]![0]).toBeLessThan(60);
  expect(held.counts[0]![1]).toBeLessThan(20);
});

test('walks in what is dropped with ?renderer=webgpu', async ({ page }) => {
  await open(page, 'renderer=webgpu');
  await drop(page, [{ name: 'draco.glb', bytes: await readFile('e2e/support/draco.glb') }]);
  await expect.poll(() => page.evaluate(() => window.demo.character.grounded), soon).toBe(true);
  const [, y] = await foot(page);
  expect(Math.abs(y!)).toBeLessThan(STANDS);
  expect(await page.evaluate(() => window.demo.level!.name)).toBe('draco.glb');
});
