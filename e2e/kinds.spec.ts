import { Document, type Extension, Logger, NodeIO } from '@gltf-transform/core';
import { quantize } from '@gltf-transform/functions';
import { TorusKnotGeometry } from 'three';
import type faults from './harness/faults.js';
import type { KindCase, KindReport } from './harness/kinds.js';
import { writeRow } from './support/solidRows.js';
import { expect, runInPage, test } from './support/test.js';

/** Part of all texels that may disagree since they lie on an outline (`isOutline` in the harness says what that is). */
const OUTLINES = 0.003;

const KINDS = [
  'Mesh, 16-bit indices',
  'Mesh, 32-bit indices',
  'Mesh, not indexed',
  'Mesh, drawRange',
  'Mesh, several materials and groups',
  'Mesh, interleaved',
  'Mesh, normalized Int16',
  'Mesh, normalized Int8',
  'Mesh, KHR_mesh_quantization from a GLB',
  'Mesh, sheared by its parents',
  'SkinnedMesh, attached',
  'SkinnedMesh, detached',
  'SkinnedMesh with morph targets',
  'Morph targets, relative',
  'Morph targets, absolute',
  'InstancedMesh',
  'InstancedMesh with morph targets',
  'BatchedMesh, never rendered',
  'BatchedMesh, the user’s camera elsewhere',
  'LOD, never rendered',
  'LOD, rendered',
];

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

/** A GLB whose positions are normalized 16-bit integers. */
async function quantisedModel(): Promise<string> {
  const { attributes, index } = new TorusKnotGeometry(0.24, 0.09, 30, 8, 2, 3);
  const document = new Document();
  const buffer = document.createBuffer();
  const position = document
    .createAccessor()
    .setType('VEC3')
    .setArray(new Float32Array(attributes.position!.array))
    .setBuffer(buffer);
  const indices = document
    .createAccessor()
    .setArray(new Uint16Array(index!.array))
    .setBuffer(buffer);
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', position)
    .setIndices(indices)
    .setMaterial(document.createMaterial().setDoubleSided(true));
  const mesh = document.createMesh().addPrimitive(primitive);
  document.createScene().addChild(document.createNode().setMesh(mesh));
  document.setLogger(new Logger(Logger.Verbosity.ERROR));
  await document.transform(quantize({ quantizePosition: 14 }));
  const used = document.getRoot().listExtensionsUsed();
  const io = new NodeIO().registerExtensions(
    used.map((extension) => extension.constructor as typeof Extension),
  );
  return Buffer.from(await io.writeBinary(document)).toString('base64');
}
