// Shapes to a GLB file, by the glTF writer.

import { Document, NodeIO, VertexLayout } from '@gltf-transform/core';
import { EXTTextureWebP, KHRMeshQuantization } from '@gltf-transform/extensions';
import { MATERIALS, linear } from './palette.mjs';
import { HALF } from './parts/ground.mjs';
import { quarters } from './quarters.mjs';
import { regroup } from './regroup.mjs';

/** Width of the square that the floor's occlusion map covers, metres, about the middle. */
export const FLOOR_MAP = 2 * (HALF + 0.5);

/**
 * Joins the vertices of a part that are equal in everything that is written: box faces cut in cells share most of theirs.
 */
function weld({ positions, normals, uvs, colors, indices }, textured) {
  const seen = new Map();
  const joined = { positions: [], normals: [], uvs: [], colors: [], indices: [] };
  // Adding zero turns a negative zero into a plain one.
  const fixed = (value) => value.toFixed(5);
  const three = (list, i) => [0, 1, 2].map((k) => Math.fround(list[i * 3 + k]) + 0);
  joined.indices = indices.map((i) => {
    const position = three(positions, i);
    const normal = three(normals, i);
    const uv = [0, 1].map((k) => Math.fround(uvs[i * 2 + k]) + 0);
    const color = three(colors, i).map((value) => Math.round(value * 255));
    const key = [...position, ...normal, ...color, ...(textured ? uv.map(fixed) : [])].join();
    let index = seen.get(key);
    if (index === undefined) {
      index = seen.size;
      seen.set(key, index);
      joined.positions.push(...position);
      joined.normals.push(...normal);
      joined.uvs.push(...uv);
      joined.colors.push(...color, 255);
    }
    return index;
  });
  return joined;
}

/**
 * `spawn`: the foot of the start, looking toward -Z; without one whoever loads it finds a start. Materials whose texture is
 * not among `textures` have their colour alone. `compress(document)` returns who can write what it made of it; without
 * one, three's loader needs nothing else to read the file. Returns its bytes.
 */
export async function writeLevel({ shapes, textures, occlusion, spawn, compress }) {
  const document = new Document();
  const root = document.getRoot();
  root.getAsset().generator = 'three-cube-collider scripts/level';
  const buffer = document.createBuffer();
  const scene = document.createScene('level');
  root.setDefaultScene(scene);

  const pictures = new Map();
  const picture = (name, image) => {
    if (!pictures.has(name))
      pictures.set(name, document.createTexture(name).setMimeType('image/webp').setImage(image));
    return pictures.get(name);
  };
  const materials = new Map();
  const material = (name) => {
    if (!materials.has(name)) {
      const { texture, color, roughness, occlusion: baked } = MATERIALS[name];
      const made = document
        .createMaterial(name)
        .setBaseColorFactor([...linear(color), 1])
        .setMetallicFactor(0)
        .setRoughnessFactor(roughness);
      if (textures[texture]) made.setBaseColorTexture(picture(texture, textures[texture]));
      if (baked) {
        made.setOcclusionTexture(picture('floor-occlusion', occlusion));
        made.getOcclusionTextureInfo().setTexCoord(1);
      }
      materials.set(name, made);
    }
    return materials.get(name);
  };
  const accessor = (type, array) =>
    document.createAccessor().setBuffer(buffer).setType(type).setArray(array);

  /** A byte a component: within half a degree, and exact along the axes. */
  const normal = (array) =>
    compress
      ? accessor('VEC3', Float32Array.from(array)) // which does that itself
      : accessor(
          'VEC3',
          Int8Array.from(array, (value) => Math.round(value * 127)),
        ).setNormalized(true);

  const node = (title, parts) => {
    const mesh = document.createMesh(title);
    for (const [name, part] of parts) {
      const textured = textures[MATERIALS[name].texture] !== undefined;
      const { positions, normals, uvs, colors, indices } = weld(part, textured);
      const count = positions.length / 3;
      const Indices = count > 65535 ? Uint32Array : Uint16Array;
      const primitive = document
        .createPrimitive()
        .setMaterial(material(name))
        .setIndices(accessor('SCALAR', Indices.from(indices)))
        .setAttribute('POSITION', accessor('VEC3', Float32Array.from(positions)))
        .setAttribute('NORMAL', normal(normals));
      if (textured) primitive.setAttribute('TEXCOORD_0', accessor('VEC2', Float32Array.from(uvs)));
      primitive.setAttribute(
        'COLOR_0',
        accessor('VEC4', Uint8Array.from(colors)).setNormalized(true),
      );
      if (MATERIALS[name].occlusion) {
        const spread = Array.from(
          { length: count * 2 },
          (_, i) => positions[(i >> 1) * 3 + (i & 1) * 2] / FLOOR_MAP + 0.5,
        );
        primitive.setAttribute('TEXCOORD_1', accessor('VEC2', Float32Array.from(spread)));
      }
      mesh.addPrimitive(primitive);
    }
    return document.createNode(title).setMesh(mesh);
  };
  for (const shape of shapes) {
    const pieces = quarters(shape).map(([name, parts]) => node(name, parts));
    if (pieces.length === 1) scene.addChild(pieces[0]);
    else {
      const parent = document.createNode(shape.name);
      for (const piece of pieces) parent.addChild(piece);
      scene.addChild(parent);
    }
  }
  if (spawn) scene.addChild(document.createNode('spawn').setTranslation(spawn));
  if (compress) return (await compress(document)).writeBinary(document);
  document.createExtension(KHRMeshQuantization).setRequired(true);
  if (pictures.size > 0) document.createExtension(EXTTextureWebP).setRequired(true);
  const io = new NodeIO()
    .registerExtensions([EXTTextureWebP, KHRMeshQuantization])
    .setVertexLayout(VertexLayout.SEPARATE);
  return regroup(await io.writeBinary(document));
}
