import type overlays from './harness/overlays.js';
import { expect, runInPage, test, testOnOnePage } from './support/test.js';

for (const backend of ['WebGL2', 'WebGPU'] as const) {
  testOnOnePage(
    `should draw what the collider sees, and be no obstacle itself: ${backend}`,
    async ({ page }) => {
      const report = await runInPage<Awaited<ReturnType<typeof overlays>>>(
        page,
        '/e2e/harness/overlays.ts',
        { backend },
      );
      const best = (name: string) => Math.max(...Object.values(report.shown[name]!.toward));
      // Through how much of a disc, an arrow, the film or a line one sees.
      for (const [name, least] of [
        ['floor', 0.6],
        ['wall', 0.6],
        ['touch', 0.9],
        ['push', 0.9],
        ['net', 0.12],
        ['capsule', 0.25],
      ] as const) {
        expect(best(name), name).toBeGreaterThan(least);
        expect(report.shown[name]!.changed, name).toBeGreaterThan(50);
      }
      expect(report.contacts).toBeGreaterThan(1);
      expect(report.survey).toEqual({ changed: false, moved: false });
      expect([report.solid, report.others, report.drawCalls]).toEqual([0, 0, 0]);
      expect(report.trianglesMore).toBeGreaterThan(1000);
      expect([report.asleep, report.trianglesAsleep]).toEqual([0, 0]);
      expect(report.memory).toEqual([0, 0, 0, 0]);
      expect(report.ticks).toBeGreaterThan(10);
      expect(report.bars).toBeGreaterThan(10);
      expect(report.near).toBeGreaterThan(100);
    },
  );
}

test.describe('in the demo', () => {
  test.use({ viewport: { width: 390, height: 480 }, hasTouch: true, isMobile: true });

  test('should switch each by its key and by its button, which a finger hits', async ({ page }) => {
    await page.goto('/demo/index.html?dpr=1&quality=low');
    await page.evaluate(() => window.demo.ready);
    await page.getByRole('button', { name: 'Walk', exact: true }).tap();
    await page.evaluate(() => window.demo.step(2));
    await page.getByRole('button', { name: 'What the collider sees' }).tap();
    const list = page.getByRole('region', { name: 'What the collider sees' });
    const names = [
      'Cubemap',
      'Surfaces',
      'Contacts',
      'Free space',
      'Body',
      'Read-backs',
      'Numbers',
    ];
    for (const [i, name] of names.entries()) {
      const button = list.getByRole('button', { name });
      await expect(button).toHaveAttribute('aria-pressed', 'false');
      expect((await button.boundingBox())!.height).toBeGreaterThanOrEqual(44);
      await page.keyboard.press(i === 0 ? 'KeyH' : `Digit${i}`);
      await expect(button).toHaveAttribute('aria-pressed', 'true');
    }
    await page.evaluate(() => window.demo.step(2));
    const shown = await page.evaluate(() =>
      window.demo.scene.children
        .filter(({ type, visible }) => /Helper$/.test(type) && visible)
        .map(({ type }) => type),
    );
    expect(shown.sort()).toEqual([
      'CharacterHelper',
      'ContactsHelper',
      'FreeSpaceHelper',
      'SurfelsHelper',
    ]);
    // Around the feet are some of them: the eyes would not see them.
    expect(await page.evaluate(() => window.demo.controls.view)).toBe('third');
    await expect(page.locator('#notice')).toHaveText(/^Third person, as long/);
    await list.getByRole('button', { name: 'Surfaces' }).tap();
    await expect(list.getByRole('button', { name: 'Surfaces' })).toHaveAttribute(
      'aria-pressed',
      'false',
    );
    expect(
      await page.evaluate(
        () => window.demo.scene.children.find(({ type }) => type === 'SurfelsHelper')!.visible,
      ),
    ).toBe(false);
    // A setting that changes meanwhile changes nothing of that.
    await page.keyboard.press('Escape');
    await page.getByRole('dialog').getByRole('button', { name: 'Settings' }).tap();
    const settings = page.getByRole('dialog', { name: 'Settings' });
    await settings.getByLabel('Field of view').fill('80');
    await settings.getByRole('button', { name: 'Done' }).tap();
    await page.getByRole('button', { name: 'Go on' }).tap();
    expect(await page.evaluate(() => window.demo.controls.view)).toBe('third');
    for (const name of ['Contacts', 'Body']) await list.getByRole('button', { name }).tap();
    expect(await page.evaluate(() => window.demo.controls.view)).toBe('first');

    // No two panels at a time; folded, the list leaves room for the numbers.
    await page.getByRole('button', { name: 'Level', exact: true }).tap();
    await expect(list.getByRole('button', { name: 'Surfaces' })).toBeHidden();
    await page.getByRole('button', { name: 'Level', exact: true }).tap();
    await expect(page.getByText('of it, for colliding')).toBeVisible();
    // A view that one chooses stays when the last of them goes.
    await page.keyboard.press('Digit4');
    for (const view of ['first', 'third']) {
      await page.getByRole('button', { name: 'Switch the view' }).tap();
      expect(await page.evaluate(() => window.demo.settings.view)).toBe(view);
    }
    await page.keyboard.press('Digit4');
    expect(await page.evaluate(() => window.demo.controls.view)).toBe('third');
  });
});
