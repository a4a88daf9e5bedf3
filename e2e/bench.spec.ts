import { expect, test } from './support/test.js';

/** In place of a suite, whose figures would take minutes. */
const STUB = `export default async ({ repeats, levels }, tell) => {
  tell('half of it');
  const row = { case: levels[0].name, figure: 'a step, ms' };
  return [
    { ...row, contestant: 'Octree', samples: [40, 50, 60] },
    { ...row, contestant: 'three-cube-collider, WebGL2', samples: [5 * repeats] },
    { ...row, contestant: 'Rapier', samples: [], note: 'cannot' },
  ];
};`;

test('the page that measures should name the GPU, run a suite, draw its bars and give its JSON', async ({
  page,
}) => {
  await page.route('**/bench/suites/feel.ts*', (route) =>
    route.fulfill({ contentType: 'text/javascript', body: STUB }),
  );
  const copied: string[] = [];
  await page.exposeFunction('onCopy', (text: string) => copied.push(text));
  await page.addInitScript(() => {
    // A headless browser gives no leave to use the real one.
    const writeText = (text: string) =>
      (window as unknown as { onCopy: (text: string) => Promise<void> }).onCopy(text);
    Object.defineProperty(navigator, 'clipboard', { value: { writeText } });
  });
  await page.goto('/demo/bench.html');
  await expect(page.locator('#webgl')).toContainText(/SwiftShader/i);
  await expect(page.locator('#browser')).toContainText('Chrome');

  const card = page.locator('.suite', { hasText: 'How it walks' });
  await card.getByRole('button', { name: 'Run' }).click();
  await expect(card.locator('.status')).toContainText('Done');
  const lines = card.locator('.contestant');
  await expect(lines).toHaveCount(3);
  await expect(lines.nth(0)).toHaveClass(/ours/);
  await expect(lines.nth(0).locator('.value')).toHaveText('5');
  await expect(lines.nth(1).locator('.value')).toContainText('×10');
  await expect(lines.nth(2).locator('.value')).toHaveText('cannot');
  const width = (i: number) =>
    lines
      .nth(i)
      .locator('.median')
      .evaluate((bar: HTMLElement) => bar.offsetWidth);
  expect(await width(1)).toBeGreaterThan(5 * (await width(0)));

  await page.getByRole('button', { name: 'Copy JSON' }).click();
  await expect.poll(() => copied.length).toBe(1);
  const { suites } = JSON.parse(copied[0]!);
  expect(Object.keys(suites)).toEqual(['feel']);
  expect(suites.feel.rows.length).toBe(3);
  expect(suites.feel.gpu).toMatch(/SwiftShader/i);
});
