import type { NodeCase, NodeReport } from './harness/nodes.js';
import type { NodeKindName } from './harness/nodeKinds.js';
import type { NodesUntouchedReport } from './harness/nodesUntouched.js';
import { callInPage, expect, openPage, runInPage, test } from './support/test.js';
import type { Backend } from './support/rendering.js';

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
  test(`should see what nodes and compute shaders make of things, ${backend}`, async ({ page }) => {
    await openPage(page);
    for (const kind of KINDS) {
      // three's fallback has no compute shaders, and what stands for them writes no matrices.
      if (backend === 'fallback' && kind.startsWith('instance matrices')) continue;
      await test.step(kind, async () => {
        const seen = await callInPage<NodeReport>(page, '/e2e/harness/nodes.ts', {
          backend,
          kind,
        } satisfies NodeCase);
        const silhouettes = seen.phases.reduce((all, each) => all + each.silhouettes, 0);
        console.log(
          `    ${kind}: ${seen.texels} texels, worst ${(1000 * seen.worst).toFixed(3)} mm, ${silhouettes} silhouettes, ` +
            `programs ${seen.programs} for ${seen.sources}, ${seen.seconds.toFixed(1)} s`,
        );
        expect.soft(seen.worst, kind).toBeLessThanOrEqual(0.01);
        seen.phases.forEach((phase, i) => {
          const when = `${kind}, phase ${i}`;
          expect.soft(phase.wrong, `${when}: texels off by more than 1 cm`).toBe(0);
          expect.soft(phase.strangers, `${when}: texels misnamed`).toBe(0);
          expect.soft(phase.texels, when).toBeGreaterThan(100);
          expect.soft(phase.silhouettes, when).toBeLessThanOrEqual(0.02 * phase.texels);
        });
        expect.soft(seen.differing, `${kind}: bytes of the user’s pictures`).toBe(0);
        expect.soft(seen.programs, kind).toBeLessThanOrEqual(2 * seen.sources);
        expect.soft(seen.rigid, kind).toEqual([!MOVING.test(kind)]);
        if (kind === 'plain materials') expect.soft(seen.programs, kind).toBe(0);
        expect.soft(seen.left, `${kind}: programs left`).toBe(0);
        expect.soft(seen.warnings, kind).toEqual([]);
      });
    }
  });
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
