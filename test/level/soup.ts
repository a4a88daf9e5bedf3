import { NodeIO, type Node } from '@gltf-transform/core';
import { EXTTextureWebP, KHRMeshQuantization } from '@gltf-transform/extensions';
import { BufferAttribute, BufferGeometry, Group, Matrix4, Mesh } from 'three';
import { collectTriangles } from '../../demo/level/triangles.js';

/** The triangles of a GLB file, without pictures, materials and skins. */
export async function soupOf(path: string): Promise<Float32Array> {
  const io = new NodeIO().registerExtensions([EXTTextureWebP, KHRMeshQuantization]);
  const document = await io.read(path);
  const root = new Group();
  document
    .getRoot()
    .listNodes()
    .forEach((node: Node) => {
      for (const primitive of node.getMesh()?.listPrimitives() ?? []) {
        const geometry = new BufferGeometry();
        const position = primitive.getAttribute('POSITION')!;
        const points = new Float32Array(position.getCount() * 3);
        for (let i = 0; i < position.getCount(); i++) points.set(position.getElement(i, []), 3 * i);
        geometry.setAttribute('position', new BufferAttribute(points, 3));
        const index = primitive.getIndices()?.getArray();
        if (index) geometry.setIndex(Array.from(index));
        const mesh = new Mesh(geometry);
        mesh.applyMatrix4(new Matrix4().fromArray(node.getWorldMatrix()));
        root.add(mesh);
      }
    });
  return collectTriangles(root);
}

/** The same triangles, each corner moved by a matrix. */
export function moved(soup: Float32Array, matrix: Matrix4): Float32Array {
  const copy = soup.slice();
  new BufferAttribute(copy, 3).applyMatrix4(matrix);
  return copy;
}
