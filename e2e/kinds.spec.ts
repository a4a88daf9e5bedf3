import type faults from './harness/faults.js';
import type { KindCase, KindReport } from './harness/kinds.js';
import { KINDS, OUTLINES } from './support/kinds/names.js';
import { quantisedModel } from './support/kinds/quantisedModel.js';
import { writeRow } from './support/solidRows.js';
import { expect, runInPage, testOnOnePage as test } from './support/test.js';

/** Those that lean on what is not the same in every three. */
const ON_OLDEST = /Batched|morph targets|detached|LOD, never/;

for (const name of KINDS) {
  const tag = ON_OLDEST.test(name) ? '@three ' : '';
  test(`${tag}should be as solid as drawn: ${name}`, async ({ page }) => {
    const glb = name.includes('GLB') ? await quantisedModel() : undefined;
    const report = await runInPage<KindReport>(page, '/e2e/harness/kinds.ts', {
      name,
      glb,
    } satisfies KindCase);
    const millimetres = (1000 * report.worst).toFixed(2);
    console.log(
      `    ${report.texels} texels on it, ${report.outlines} outlines, ${millimetres} mm`,
    );
    expect(report.wrong).toEqual([]);
    expect(report.strangers).toEqual([]);
    expect(report.texels).toBeGreaterThan(150);
    expect(report.outlines / report.all).toBeLessThanOrEqual(OUTLINES);
    expect(report.worst).toBeLessThanOrEqual(0.01);
    const { worst, texels, draws, programs } = report;
    writeRow({ kind: name, group: 'geometry', worst, texels, draws, programs });
  });
}

test('should leave out what three cannot draw, say so once, and see all else', async ({ page }) => {
  const report = await runInPage<ReturnType<typeof faults>>(page, '/e2e/harness/faults.ts');
  expect(report.same).toBe(true);
  expect(report.objects).toBe(1);
  expect(report.warnings).toHaveLength(report.names.length);
  for (const name of report.names) {
    expect(report.warnings.filter((warning) => warning.includes(` "${name}" `))).toHaveLength(1);
  }
  expect(Object.keys(report.seen)).toHaveLength(5);
  for (const distance of Object.values(report.seen)) expect(distance).toBe(1);
});
