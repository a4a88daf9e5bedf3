import { readdirSync, readFileSync } from 'node:fs';
import type { metaQuest3, XRDevice } from 'iwer';
import type { Camera } from 'three';
import type { CharacterController } from 'three-cube-collider';
import { points } from './support/examplePoints.js';
import { expect, test } from './support/test.js';

declare global {
  interface Window {
    character: CharacterController;
    /** Of webxr. */
    camera: Camera;
    headset: XRDevice;
    IWER: { XRDevice: typeof XRDevice; metaQuest3: typeof metaQuest3 };
  }
}

/** What the server, Chromium (of a software GPU's speed), React, and React Three Fiber say of themselves. */
const THEIRS =
  /^\[vite\]|GL Driver Message \(OpenGL, Performance|React DevTools|^THREE\.Clock: .* deprecated/;

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
      if (!THEIRS.test(text)) said.push(text);
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
    await points[name]?.(page);
    expect(said).toEqual([]);
  });
}

test('the example webxr should walk by stick and by head in an emulated headset', async ({
  page,
}) => {
  await page.addInitScript({ path: 'node_modules/iwer/build/iwer.min.js' });
  await page.addInitScript(() => {
    window.headset = new window.IWER.XRDevice(window.IWER.metaQuest3);
    window.headset.installRuntime({ forceInstall: true });
  });
  await page.setViewportSize({ width: 192, height: 108 });
  await page.goto('/examples/webxr.html');
  await page.waitForFunction(() => window.character?.grounded, undefined, { timeout: 60_000 });
  await page.evaluate(() => document.getElementById('VRButton')!.click());
  await page.waitForFunction(() => window.camera.position.y > 1.5);

  /** Where foot and head are, how high, and the direction of the view about +Y. */
  const look = () =>
    page.evaluate(() => {
      const { x, y, z } = window.character.position;
      const [, , , , , , , , ax, , az, , hx, hy, hz] = window.camera.matrixWorld.elements;
      return { foot: [x, z], head: [hx!, hz!], height: hy! - y, yaw: Math.atan2(ax!, az!) };
    });
  const apart = ([x, z]: number[], [u, v]: number[]) => Math.hypot(x! - u!, z! - v!);
  const push = (hand: 'left' | 'right', x: number, z: number) =>
    page.evaluate(
      ([hand, x, z]) => window.headset.controllers[hand]!.updateAxes('thumbstick', x, z),
      [hand, x, z] as const,
    );

  const start = await look();
  await push('left', 0, -1);
  await expect.poll(async () => (await look()).foot[1]).toBeLessThan(start.foot[1]! - 0.5);
  await push('left', 0, 0);
  const walked = await look();
  expect(walked.head[0]).toBeCloseTo(start.head[0]!, 1);
  expect(walked.height).toBeCloseTo(1.6, 1);

  // A step aside in the room is one in the level, and the room lies where it was.
  await page.evaluate(() => (window.headset.position.x += 0.4));
  await expect.poll(async () => apart((await look()).foot, walked.foot)).toBeGreaterThan(0.35);
  const aside = await look();
  expect(apart(aside.head, walked.head)).toBeCloseTo(0.4, 1);
  expect(aside.height).toBeCloseTo(walked.height, 2);

  // The other stick turns about the head, once.
  await push('right', 1, 0);
  await expect.poll(async () => (await look()).yaw).toBeCloseTo(walked.yaw - Math.PI / 6, 2);
  await push('right', 0, 0);
  const turned = await look();
  expect(apart(turned.head, aside.head)).toBeLessThan(0.05);

  // Farther than the level lets it go: the room gives way, and the head stays over the foot.
  await page.evaluate(() => (window.headset.position.z -= 60));
  await expect
    .poll(async () => apart((await look()).head, (await look()).foot), { timeout: 10_000 })
    .toBeLessThan(0.05);
  expect(apart((await look()).foot, turned.foot)).toBeLessThan(50);
});
