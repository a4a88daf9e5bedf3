import { Document, type Material, NodeIO, type Primitive } from '@gltf-transform/core';
import { encode } from 'fast-png';
import { BoxGeometry } from 'three';

/** A file to drop. */
export interface Droppable {
  name: string;
  bytes: Uint8Array;
}

interface Options {
  /** Units of a metre. */
  units?: number;
  /** With Z up, as if it had never been converted. */
  zUp?: boolean;
  textured?: boolean;
  /** A slab under a node named `spawn` goes up a metre and down again, in four seconds. */
  lift?: boolean;
}

type Three = [number, number, number];

/** A yard of 16 m by 12 m with a wall and three pillars; its ground is at 0. */
export function yard({
  units = 1,
  zUp = false,
  textured = false,
  lift = false,
}: Options = {}): Document {
  const document = new Document();
  document.createBuffer('yard');
  const scene = document.createScene('yard');
  const material = document.createMaterial('stone').setBaseColorFactor([0.7, 0.6, 0.5, 1]);
  if (textured) {
    const image = encode({
      width: 2,
      height: 2,
      channels: 1,
      depth: 8,
      data: new Uint8Array([255, 99, 99, 255]),
    });
    material.setBaseColorTexture(
      document
        .createTexture('checks')
        .setMimeType('image/png')
        .setImage(image)
        .setURI('pictures/checks 1.png'),
    );
  }
  const box = (name: string, size: Three, middle: Three) => {
    const turn = ([x, y, z]: Three): Three => (zUp ? [x, -z, y] : [x, y, z]);
    const measure = ([x, y, z]: Three): Three => (zUp ? [x, z, y] : [x, y, z]);
    const mesh = document
      .createMesh(name)
      .addPrimitive(boxPrimitive(document, measure(size), units, material));
    const node = document.createNode(name).setMesh(mesh);
    node.setTranslation(turn(middle).map((value) => value * units) as Three);
    scene.addChild(node);
    return node;
  };
  box('ground', [16, 0.4, 12], [0, -0.2, 0]);
  box('wall', [16, 3, 0.4], [0, 1.5, -6]);
  for (const x of [-6, 5, 6.5]) box('pillar', [0.6, 2.6, 0.6], [x, 1.3, 3]);
  if (lift) {
    const slab = box('lift', [3, 0.2, 3], [0, 0.1, 0]);
    scene.addChild(document.createNode('spawn').setTranslation([0, 0.2, 0]));
    const numbers = (type: 'SCALAR' | 'VEC3', list: number[]) =>
      document
        .createAccessor()
        .setType(type)
        .setArray(new Float32Array(list))
        .setBuffer(document.getRoot().listBuffers()[0]!);
    const sampler = document
      .createAnimationSampler()
      .setInput(numbers('SCALAR', [0, 2, 4]))
      .setOutput(numbers('VEC3', [0, 0.1, 0, 0, 1.1, 0, 0, 0.1, 0]));
    const channel = document
      .createAnimationChannel()
      .setSampler(sampler)
      .setTargetNode(slab)
      .setTargetPath('translation');
    document.createAnimation('up and down').addSampler(sampler).addChannel(channel);
  }
  return document;
}

function boxPrimitive(
  document: Document,
  size: Three,
  units: number,
  material: Material,
): Primitive {
  const geometry = new BoxGeometry(...(size.map((value) => value * units) as Three));
  const buffer = document.getRoot().listBuffers()[0]!;
  const accessor = (name: 'position' | 'normal' | 'uv', type: 'VEC2' | 'VEC3') =>
    document
      .createAccessor()
      .setType(type)
      .setArray(new Float32Array(geometry.attributes[name]!.array))
      .setBuffer(buffer);
  return document
    .createPrimitive()
    .setMaterial(material)
    .setIndices(
      document
        .createAccessor()
        .setType('SCALAR')
        .setArray(new Uint16Array(geometry.index!.array))
        .setBuffer(buffer),
    )
    .setAttribute('POSITION', accessor('position', 'VEC3'))
    .setAttribute('NORMAL', accessor('normal', 'VEC3'))
    .setAttribute('TEXCOORD_0', accessor('uv', 'VEC2'));
}

export async function asGlb(name: string, document: Document): Promise<Droppable> {
  return { name, bytes: await new NodeIO().writeBinary(document) };
}

/** A .gltf with a file of numbers, and pictures if it has any. */
export async function asFiles(name: string, document: Document): Promise<Droppable[]> {
  const { json, resources } = await new NodeIO().writeJSON(document, { basename: 'yard' });
  const others = Object.entries(resources).map(([path, bytes]) => ({
    name: decodeURIComponent(path.replace(/^.*\//, '')),
    bytes,
  }));
  return [...others, { name, bytes: new TextEncoder().encode(JSON.stringify(json)) }];
}
