import { readdirSync, readFileSync } from 'node:fs';
import type { CharacterController } from 'three-cube-collider';
import { points } from './support/examplePoints.js';
import { expect, test } from './support/test.js';

declare global {
  interface Window {
    character: CharacterController;
  }
}

const names = readdirSync('examples')
  .filter((name) => name.endsWith('.html'))
  .map((name) => name.replace('.html', ''));

for (const name of names) {
  test(`the example ${name} should walk, log nothing, and be one page of code`, async ({
    page,
  }) => {
    const lines = readFileSync(`examples/${name}.html`, 'utf8').trimEnd().split('\n');
    expect(lines.length).toBeLessThanOrEqual(80);
    expect(readFileSync('docs/guides/README.md', 'utf8')).toContain(`examples/${name}.html`);
    const said: string[] = [];
    page.on('console', (message) => {
      const text = message.text();
      // The server's own, and what Chromium says of a software GPU's speed.
      if (!/^\[vite\]|GL Driver Message \(OpenGL, Performance/.test(text)) said.push(text);
    });
    await page.setViewportSize({ width: 192, height: 108 });
    await page.goto(`/examples/${name}.html`);
    await page.waitForFunction(() => window.character?.grounded, undefined, { timeout: 60_000 });
    const from = await page.evaluate(() => window.character.position.toArray());
    await page.keyboard.down('KeyW');
    await page.waitForFunction(
      ([x, , z]) =>
        Math.hypot(window.character.position.x - x!, window.character.position.z - z!) > 0.5,
      from,
      { timeout: 60_000 },
    );
    await page.keyboard.up('KeyW');
    if (process.env.EXAMPLE_PICTURES) {
      await page.setViewportSize({ width: 960, height: 540 });
      await page.screenshot({ path: `${process.env.EXAMPLE_PICTURES}/${name}.png` });
    }
    await points[name]?.(page);
    expect(said).toEqual([]);
  });
}
