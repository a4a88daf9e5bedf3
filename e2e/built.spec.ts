import { access, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { buildDemo, serve } from './support/builtDemo.js';
import { expect, test } from './support/test.js';

test.use({ viewport: { width: 480, height: 270 } });

test('walks from any folder, keeps to it, and needs no network the next time', async ({
  page,
  context,
}, { outputDir }) => {
  const folder = join(outputDir, 'demo');
  await buildDemo(folder);
  const worker = await readFile(join(folder, 'sw.js'), 'utf8');
  const kept = JSON.parse(/addAll\(\s*(\[[^\]]*\])/.exec(worker)![1]!) as string[];
  const sizes = kept.map(async (name) => gzipSync(await readFile(join(folder, name))).length);
  const bytes = (await Promise.all(sizes)).reduce((sum, size) => sum + size);
  console.log(`    ${kept.length} files, ${(bytes / 1e6).toFixed(2)} MB gzipped`);
  expect(bytes).toBeLessThan(3e6);

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
  const begin = async () => {
    await page.goto(`${url}?dpr=0.2&quality=low`);
    await page.evaluate(() => window.demo.ready);
    await page.getByRole('button', { name: 'Walk', exact: true }).click();
    const frames = () => page.evaluate(() => window.demo.renderer.info.render.frame);
    await expect.poll(frames, { intervals: [50] }).toBeGreaterThan((await frames()) + 2);
  };
  await begin();
  await page.evaluate(() => navigator.serviceWorker.ready);
  const policy = page.locator('meta[http-equiv="Content-Security-Policy"]');
  await expect(policy).toHaveAttribute(
    'content',
    /^default-src 'self'; script-src 'self' 'wasm-un/,
  );

  server.closeAllConnections();
  await new Promise((resolve) => server.close(resolve));
  await begin();
  // Console and policy are watched by every test.
  const elsewhere = asked.filter((each) => !each.startsWith(url) && !each.startsWith('blob:'));
  expect(elsewhere).toEqual([]);
});
