import { Document, NodeIO } from '@gltf-transform/core';

/** A GLB of 80 × 80 m of floor about the origin, and nothing on it. */
export async function floorLevel(): Promise<Buffer> {
  const document = new Document();
  const buffer = document.createBuffer();
  const accessor = (type: 'SCALAR' | 'VEC3', array: Float32Array | Uint16Array) =>
    document.createAccessor().setBuffer(buffer).setType(type).setArray(array);
  const corners = new Float32Array([-40, 0, -40, -40, 0, 40, 40, 0, 40, 40, 0, -40]);
  const primitive = document
    .createPrimitive()
    .setMaterial(document.createMaterial('floor'))
    .setAttribute('POSITION', accessor('VEC3', corners))
    .setAttribute(
      'NORMAL',
      accessor('VEC3', new Float32Array([0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0])),
    )
    .setIndices(accessor('SCALAR', new Uint16Array([0, 1, 2, 0, 2, 3])));
  const node = document.createNode('floor').setMesh(document.createMesh().addPrimitive(primitive));
  document.createScene().addChild(node).addChild(document.createNode('spawn'));
  return Buffer.from(await new NodeIO().writeBinary(document));
}
