import type { Page } from '@playwright/test';
import type { KindCase, KindReport } from './harness/materials.js';
import type { RuleCases } from './harness/materialRules.js';
import type { KindName } from './harness/materialKinds.js';
import { writeRow } from './support/solidRows.js';
import { expect, runInPage, testOnOnePage as test } from './support/test.js';

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

function check(seen: KindReport): void {
  const { kind, worst, texels, silhouettes, draws, programs, sources } = seen;
  console.log(
    `    ${kind}: ${texels} texels, worst ${(1000 * worst).toFixed(3)} mm, ${silhouettes} silhouettes, ` +
      `${draws} draws, programs ${programs} for ${sources}, ${seen.seconds.toFixed(1)} s`,
  );
  expect.soft(seen.wrong, `${kind}: texels off by more than 1 cm`).toBe(0);
  expect.soft(worst, kind).toBeLessThanOrEqual(0.01);
  expect.soft(seen.strangers, `${kind}: texels misnamed`).toBe(0);
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
    writeRow({ kind, group: 'material', worst, texels, draws, programs });
  }
});

test('should do so before the app draws, in every format, side and kind of depth', async ({
  page,
}) => {
  const cases: KindCase[] = [
    { kind: 'onBeforeCompile', probeFirst: true },
    { kind: 'ShaderMaterial', probeFirst: true, collider: { format: 'RGBA8' } },
    { kind: 'gl_FragDepth', renderer: { reversedDepthBuffer: true } },
    { kind: 'RawShaderMaterial, GLSL 1', collider: { format: 'RGBA16F' } },
    { kind: 'onBeforeCompile', renderer: { logarithmicDepthBuffer: true } },
  ];
  for (const seen of await run(page, cases)) check(seen);
});

function rule<Name extends keyof RuleCases>(
  page: Page,
  name: Name,
  args?: Parameters<RuleCases[Name]>[0],
): Promise<Awaited<ReturnType<RuleCases[Name]>>> {
  return runInPage(page, '/e2e/harness/materialRules.ts', { name, args });
}

test('should take for solid what the policy says', async ({ page }) => {
  const { table, worst } = await rule(page, 'policy');
  // By default, with `transparent: 'solid'`, marked solid, marked a ghost.
  const solid = Object.fromEntries(
    Object.entries(table).map(([name, seen]) => [name, seen.map((count) => count > 40)]),
  );
  expect(solid).toEqual({
    opaque: [true, true, true, false],
    transparent: [false, true, true, false],
    'transparent shader': [false, true, true, false],
    'transparent, alpha tested': [true, true, true, false],
    'no depth written': [false, true, true, false],
    'not visible': [false, false, true, false],
    'a material that is not visible': [false, false, true, false],
    sprite: [false, false, false, false],
    points: [false, false, false, false],
    line: [false, false, false, false],
    'wide line': [false, false, false, false],
  });
  // What is not solid is not there at all.
  for (const seen of Object.values(table)) {
    for (const count of seen) expect(count === 0 || count > 40).toBe(true);
  }
  expect(worst).toBeLessThan(1e-5);
  for (const [name, seen] of Object.entries(table)) {
    writeRow({
      kind: `policy: ${name}`,
      group: 'policy',
      worst,
      texels: Math.max(...seen),
      draws: 6,
      programs: 1,
      note: ['by default', "with `transparent: 'solid'`", 'with `userData.collider = true`']
        .map((how, i) => `${how} ${seen[i]! > 0 ? 'solid' : 'not'}`)
        .join(', '),
    });
  }
});

test('should tell fronts from backs of wrapped materials as of plain ones', async ({ page }) => {
  // Seen from its front and its back, then both mirrored.
  expect(await rule(page, 'sides')).toEqual([
    'both FrontSide: front back front back',
    'both BackSide: back front back front',
    'both DoubleSide: front front front front',
    'drawn FrontSide: front nothing front nothing',
    'drawn BackSide: nothing front nothing front',
    'drawn DoubleSide: front front front front',
  ]);
});

for (const compile of [false, true]) {
  test(`should collide with the plain vertices of what cannot be wrapped, and say so once: ${compile ? 'compiled' : 'drawn'}`, async ({
    page,
  }) => {
    const seen = await rule(page, 'unwrappable', { compile });
    expect(seen.warnings).toEqual([
      expect.stringMatching(
        /^CubeCollider: ShaderMaterial "lava" cannot be drawn .*directionalLights/,
      ),
    ]);
    for (const view of seen.views) {
      expect(view.seen).toBeGreaterThan(40);
      expect(view.worst).toBeLessThan(1e-5);
    }
    if (compile) expect(seen.made).toBe(0);
    expect(seen).toMatchObject({ left: 0, error: 0, debug: [false, null] });
  });
}

test('should give the paper’s maxima of wrapped materials, too', async ({ page }) => {
  const [plain, ...others] = await rule(page, 'axis');
  expect(plain!.some((red) => red > 0 && red < 1)).toBe(true);
  for (const other of others) expect(other).toEqual(plain);
});

test('should share one program among all plain materials', async ({ page }) => {
  expect(await rule(page, 'plain')).toEqual({ programs: 1, objects: 8 });
});

test('should have every program once compiled, and none once disposed of', async ({ page }) => {
  const seen = await rule(page, 'compiled');
  // Five kinds, the plain one, and the pass that keeps the nearest.
  expect(seen).toEqual({
    compiled: 7,
    made: 0,
    afterDispose: 2,
    used: 7,
    afterOther: 7,
    left: 2,
    end: 0,
    listeners: 0,
  });
});

test('should follow a material from kind to kind', async ({ page }) => {
  const seen = await rule(page, 'changedKinds');
  for (const { worst } of seen) expect(worst).toBeLessThan(1e-5);
  expect(seen.map((each) => each.seen > 40)).toEqual([true, true, true, false]);
});
