import { mkdirSync, writeFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import type { KindCase, KindReport } from './harness/materials.js';
import type { KindName } from './harness/materialKinds.js';
import { expect, runInPage, test } from './support/test.js';

const KINDS: KindName[] = [
  'displacement',
  'alpha test',
  'alpha map',
  'alpha to coverage',
  'alpha hash',
  'vertex alpha',
  'clipping planes',
  'onBeforeCompile',
  'ShaderMaterial',
  'ShaderMaterial, GLSL 3',
  'RawShaderMaterial, GLSL 1',
  'RawShaderMaterial, GLSL 3',
  'gl_FragDepth',
  'uniforms of an object',
];

const run = (page: Page, tests: KindCase[]) =>
  runInPage<KindReport[]>(page, '/e2e/harness/materials.ts', tests);

/** What docs/solid.md is made of. */
function report(row: {
  kind: string;
  group: 'material' | 'policy';
  worst: number;
  texels: number;
  draws: number;
  programs: number;
  note?: string;
}): void {
  const folder = 'test-results/solid';
  mkdirSync(folder, { recursive: true });
  const file = row.kind.replace(/[^A-Za-z0-9]+/g, '-').toLowerCase();
  writeFileSync(`${folder}/${file}.json`, `${JSON.stringify(row)}\n`);
}

function check(seen: KindReport): void {
  const { kind, worst, texels, silhouettes, draws, programs, sources } = seen;
  console.log(
    `    ${kind}: ${texels} texels, worst ${(1000 * worst).toFixed(3)} mm, ${silhouettes} silhouettes, ` +
      `${draws} draws, programs ${programs} for ${sources}, ${seen.seconds.toFixed(1)} s`,
  );
  expect.soft(seen.wrong, `${kind}: texels off by more than 1 cm`).toBe(0);
  expect.soft(worst, kind).toBeLessThanOrEqual(0.01);
  for (const phase of seen.phases) {
    // Enough of it is seen in every phase for that to mean something.
    expect.soft(phase.texels, kind).toBeGreaterThan(100);
    expect.soft(phase.silhouettes, kind).toBeLessThanOrEqual(0.02 * phase.texels);
  }
  expect.soft(seen.differing, `${kind}: bytes of the app’s pictures`).toBe(0);
  expect.soft(seen.shown, kind).toBeGreaterThan(1000);
  expect.soft(programs, kind).toBeGreaterThan(0);
  expect.soft(programs, kind).toBeLessThanOrEqual(2 * sources);
  expect.soft(seen.left, `${kind}: programs left`).toBe(0);
  expect.soft(seen.warnings, kind).toEqual([]);
}

test('@three should see every kind of material as it is drawn, and leave the drawing alone', async ({
  page,
}) => {
  const reports = await run(
    page,
    KINDS.map((kind) => ({ kind })),
  );
  for (const seen of reports) {
    check(seen);
    const { kind, worst, texels, draws, programs } = seen;
    report({ kind, group: 'material', worst, texels, draws, programs });
  }
});

test('should do so before the app draws, in every format, side and kind of depth', async ({
  page,
}) => {
  const cases: KindCase[] = [
    { kind: 'onBeforeCompile', probeFirst: true },
    { kind: 'ShaderMaterial', probeFirst: true, collider: { format: 'RGBA8' } },
    { kind: 'alpha test', collider: { format: 'RGBA16F' } },
    { kind: 'gl_FragDepth', renderer: { reversedDepthBuffer: true } },
    { kind: 'RawShaderMaterial, GLSL 1', collider: { format: 'RGBA16F' } },
    { kind: 'onBeforeCompile', renderer: { logarithmicDepthBuffer: true } },
    { kind: 'displacement', renderer: { logarithmicDepthBuffer: true } },
  ];
  for (const seen of await run(page, cases)) check(seen);
});
