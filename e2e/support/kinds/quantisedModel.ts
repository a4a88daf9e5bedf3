import { Document, type Extension, Logger, NodeIO } from '@gltf-transform/core';
import { quantize } from '@gltf-transform/functions';
import { TorusKnotGeometry } from 'three';

/** A GLB whose positions are normalized 16-bit integers. */
export async function quantisedModel(): Promise<string> {
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
