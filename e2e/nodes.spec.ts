import type { NodeCase, NodeReport } from './harness/nodes.js';
import type { NodeKindName } from './harness/nodeKinds.js';
import type { NodesUntouchedReport } from './harness/nodesUntouched.js';
import { expect, runInPage, test, testOnOnePage } from './support/test.js';
import type { Backend } from './support/rendering.js';
import { writeRow } from './support/solidRows.js';

const KINDS: NodeKindName[] = [
  'positionNode',
  'positionNode, by the world’s place and a time told each draw',
  'positionNode that scales',
  'vertexNode',
  'vertexNode of positionView',
  'vertexNode, placed in the world',
  'maskNode',
  'alphaTestNode and opacityNode',
  'colorNode that discards',
  'outputNode that discards',
  'fragmentNode that discards',
  'mrtNode',
  'displacement map of a node material',
  'classic displacement map',
  'classic alpha test',
  'classic alpha map',
  'classic alpha to coverage',
  'classic vertex alpha',
  'Mesh.count and a storage buffer',
  'Mesh.count and an instancedArray',
  'instance matrices that are computed',
  'vertices that are computed',
  'ClippingGroup',
  'several materials',
  'plain materials',
];

/** What may have moved since it was drawn, with nobody told. */
const MOVING = /^(position|vertex)Node|displacement|Mesh.count|computed|several/;

const BACKENDS: Backend[] = ['WebGPU', 'fallback'];

for (const backend of BACKENDS) {
  for (const kind of KINDS) {
    // three's fallback has no compute shaders, and what stands for them writes no matrices.
    if (backend === 'fallback' && kind.startsWith('instance matrices')) continue;
    testOnOnePage(
      `should see what nodes make of things on ${backend}: ${kind}`,
      async ({ page }) => {
        const seen = await runInPage<NodeReport>(page, '/e2e/harness/nodes.ts', {
          backend,
          kind,
        } satisfies NodeCase);
        const { texels, worst, programs, sources } = seen;
        const silhouettes = seen.phases.reduce((all, each) => all + each.silhouettes, 0);
        console.log(
          `    ${texels} texels, worst ${(1000 * worst).toFixed(3)} mm, ${silhouettes} silhouettes, ` +
            `programs ${programs} for ${sources}`,
        );
        expect(worst).toBeLessThanOrEqual(0.01);
        seen.phases.forEach((phase, i) => {
          expect(phase.wrong, `phase ${i}: texels off by more than 1 cm`).toBe(0);
          expect(phase.strangers, `phase ${i}: texels misnamed`).toBe(0);
          expect(phase.texels, `phase ${i}`).toBeGreaterThan(100);
          expect(phase.silhouettes, `phase ${i}`).toBeLessThanOrEqual(0.02 * phase.texels);
        });
        expect(seen.differing, 'bytes of the user’s pictures').toBe(0);
        expect(programs).toBeLessThanOrEqual(2 * sources);
        expect(seen.rigid).toEqual([!MOVING.test(kind)]);
        if (kind === 'plain materials') expect(programs).toBe(0);
        expect(seen.left, 'programs left').toBe(0);
        expect(seen.warnings).toEqual([]);
        writeRow({ kind, group: 'node', backend, worst, texels, programs });
      },
    );
  }
}

for (const backend of BACKENDS) {
  test(`should leave the user’s frame untouched, ${backend}`, async ({ page }) => {
    const url = '/e2e/harness/nodesUntouched.ts';
    const seen = await runInPage<NodesUntouchedReport>(page, url, { backend });
    console.log(`    ${JSON.stringify(seen)}`);
    expect(seen.shown).toBeGreaterThan(20_000);
    expect(seen.moving).toBeGreaterThan(1000);
    expect(seen.differing).toBe(0);
    expect(seen.changed).toEqual([]);
    expect(seen.compared).toBeGreaterThan(100);
    expect(seen.intercepted).toBe(0);
    expect(seen.mirrored).toBe(0);
    expect(seen.reads).toBeGreaterThan(0);
    expect(seen.floor).toBeLessThan(1e-4);
    expect(seen.warnings).toEqual([]);
  });
}
