import { access, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { firstVisit, total, weigh } from '../scripts/demo/weight.mjs';
import { buildDemo, serve } from './support/builtDemo.js';
import { expect, test } from './support/test.js';

test.use({ viewport: { width: 480, height: 270 } });

/** Opens the page, and waits until one walks. */
async function begin(page: Page, url: string): Promise<void> {
  await page.goto(url);
  await page.evaluate(() => window.demo.ready);
  await page.getByRole('button', { name: 'Walk', exact: true }).click();
  const frames = () => page.evaluate(() => window.demo.renderer.info.render.frame);
  await expect.poll(frames, { intervals: [50] }).toBeGreaterThan((await frames()) + 2);
}

/** What is fetched when it is asked for: decoders, and the largest rival. */
async function useLazyParts(page: Page): Promise<void> {
  for (const name of ['draco.glb', 'ktx2.glb']) {
    const bytes = [...(await readFile(`e2e/support/${name}`))];
    const { level, compressed } = await page.evaluate(
      async ({ name, bytes }) => {
        const { demo } = window;
        const file = new File([new Uint8Array(bytes)], name);
        await demo.levels.open([{ path: name, file }]);
        let compressed = 0;
        demo.level!.root.traverse((each) => {
          const { material } = each as { material?: { map?: { isCompressedTexture?: boolean } } };
          if (material?.map?.isCompressedTexture) compressed++;
        });
        return { level: demo.level!.name, compressed };
      },
      { name, bytes },
    );
    expect(level).toBe(name);
    expect(compressed > 0, name).toBe(name === 'ktx2.glb');
  }
  const rival = await page.evaluate(async () => {
    const { race } = window.demo;
    await race.choose('rapier');
    return race.current;
  });
  expect(rival).toBe('rapier');
}

test('weighs little, walks from any folder, keeps to it, and needs no network the next time', async ({
  page,
  context,
}, { outputDir }) => {
  const folder = join(outputDir, 'demo');
  await buildDemo(folder);
  const files = weigh(folder);
  const first = new Set(firstVisit(folder));
  const [all, visit] = [files, files.filter(({ name }) => first.has(name))].map(total) as [
    number,
    number,
  ];
  console.log(
    `    ${files.length} files, ${(all / 1e6).toFixed(2)} MB gzipped; a visit ${(visit / 1e6).toFixed(2)} MB`,
  );
  expect(all).toBeLessThan(3e6);
  expect(visit).toBeLessThan(2e6);

  const manifest = JSON.parse(await readFile(join(folder, 'manifest.webmanifest'), 'utf8')) as {
    icons: { src: string; sizes: string }[];
  };
  expect(manifest.icons.map(({ sizes }) => sizes)).toEqual([
    'any',
    '192x192',
    '512x512',
    '512x512',
  ]);
  for (const { src } of manifest.icons) await access(join(folder, src));

  const { url, server } = await serve(folder);
  const asked: string[] = [];
  context.on('request', (request) => asked.push(request.url()));
  const maze = 'examples/maze.glb';
  await begin(page, `${url}?dpr=0.2&quality=low&level=${maze}`);
  const kept = () => page.evaluate(async (maze) => (await caches.match(maze)) !== undefined, maze);
  await expect.poll(kept, { intervals: [100] }).toBe(true);
  const names = asked.map((each) => each.replace(url, '').replace(/\?.*/, '') || 'index.html');
  const others = names.filter((name) => !first.has(name) && !/^(icon-|blob:)/.test(name));
  expect(new Set(others)).toEqual(new Set([maze]));
  const policy = page.locator('meta[http-equiv="Content-Security-Policy"]');
  await expect(policy).toHaveAttribute(
    'content',
    /^default-src 'self'; script-src 'self' 'wasm-un/,
  );
  await useLazyParts(page);

  server.closeAllConnections();
  await new Promise((resolve) => server.close(resolve));
  await begin(page, `${url}?dpr=0.2&quality=low`);
  await useLazyParts(page);
  // Which the page had asked for before the worker answered.
  await page.evaluate((maze) => window.demo.levels.visit(maze), maze);
  expect(await page.evaluate(() => window.demo.level!.name)).toBe('maze.glb');
  // Console and policy are watched by every test.
  const elsewhere = asked.filter((each) => !each.startsWith(url) && !each.startsWith('blob:'));
  expect(elsewhere).toEqual([]);
});
