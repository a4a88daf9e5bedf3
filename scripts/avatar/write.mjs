// Parts, skeleton and clips to a GLB file, by the glTF writer.

import { Document, Logger, NodeIO } from '@gltf-transform/core';
import { quantize } from '@gltf-transform/functions';
import { linear } from '../level/palette.mjs';
import { JOINTS } from './skeleton.mjs';

/** What is not the vertices' own colour. The eyes and the lamp shine by themselves. */
const MATERIALS = {
  shell: { roughness: 0.5, metalness: 0 },
  glass: { roughness: 0.14, metalness: 0.35 },
  glow: { roughness: 0.5, metalness: 0, emissive: '#7fe8dc' },
};

/** @returns the file's bytes; `clips`: { name, times, tracks: [{ joint, path, values }] } */
export async function writeAvatar(parts, clips) {
  const document = new Document().setLogger(new Logger(Logger.Verbosity.WARN));
  const root = document.getRoot();
  root.getAsset().generator = 'three-cube-collider scripts/avatar';
  const buffer = document.createBuffer();
  const scene = document.createScene('avatar');
  root.setDefaultScene(scene);
  const accessor = (type, array, normalized = false) =>
    document
      .createAccessor()
      .setBuffer(buffer)
      .setType(type)
      .setArray(array)
      .setNormalized(normalized);

  const bones = new Map();
  for (const { name, parent, at } of JOINTS) {
    const from = JOINTS.find((joint) => joint.name === parent)?.at ?? [0, 0, 0];
    const bone = document
      .createNode(name)
      .setTranslation(at.map((value, k) => round(value - from[k])));
    bones.set(name, bone);
    (parent === null ? scene : bones.get(parent)).addChild(bone);
  }
  const skin = document.createSkin('robot').setSkeleton(bones.get('hips'));
  for (const bone of bones.values()) skin.addJoint(bone);
  const inverse = JOINTS.flatMap(({ at: [x, y, z] }) => [
    1,
    0,
    0,
    0,
    0,
    1,
    0,
    0,
    0,
    0,
    1,
    0,
    -x,
    -y,
    -z,
    1,
  ]);
  skin.setInverseBindMatrices(accessor('MAT4', Float32Array.from(inverse)));

  const mesh = document.createMesh('robot');
  for (const [name, { roughness, metalness, emissive }] of Object.entries(MATERIALS)) {
    const vertices = gather(parts.filter(({ material }) => material === name));
    const material = document
      .createMaterial(name)
      .setRoughnessFactor(roughness)
      .setMetallicFactor(metalness)
      .setEmissiveFactor(emissive ? linear(emissive) : [0, 0, 0]);
    const primitive = document
      .createPrimitive()
      .setMaterial(material)
      .setIndices(accessor('SCALAR', Uint16Array.from(vertices.indices)))
      .setAttribute('POSITION', accessor('VEC3', Float32Array.from(vertices.positions)))
      .setAttribute('NORMAL', accessor('VEC3', Float32Array.from(vertices.normals)))
      .setAttribute('COLOR_0', accessor('VEC4', Uint8Array.from(vertices.colors), true))
      .setAttribute('JOINTS_0', accessor('VEC4', Uint8Array.from(vertices.joints)))
      .setAttribute('WEIGHTS_0', accessor('VEC4', Uint8Array.from(vertices.weights), true));
    mesh.addPrimitive(primitive);
  }
  scene.addChild(document.createNode('robot').setMesh(mesh).setSkin(skin));

  for (const { name, tracks } of clips) {
    const animation = document.createAnimation(name);
    const clocks = new Map();
    for (const { joint, path, times, values } of tracks) {
      if (!clocks.has(times)) clocks.set(times, accessor('SCALAR', Float32Array.from(times)));
      const turns = path === 'rotation';
      const output = turns
        ? accessor(
            'VEC4',
            Int16Array.from(values, (value) => Math.round(value * 32767)),
            true,
          )
        : accessor('VEC3', Float32Array.from(values));
      const sampler = document
        .createAnimationSampler()
        .setInput(clocks.get(times))
        .setOutput(output);
      const channel = document
        .createAnimationChannel()
        .setTargetNode(bones.get(joint))
        .setTargetPath(path)
        .setSampler(sampler);
      animation.addSampler(sampler).addChannel(channel);
    }
  }
  // A third of the vertices' bytes would be normals.
  await document.transform(quantize({ pattern: /^NORMAL$/, quantizeNormal: 8 }));
  const extensions = root.listExtensionsUsed().map((extension) => extension.constructor);
  return new NodeIO().registerExtensions(extensions).writeBinary(document);
}

const round = (value) => Math.round(value * 1e6) / 1e6;

/** Joins parts into one list of vertices, equal ones (the poles) into one. */
function gather(parts) {
  const all = { positions: [], normals: [], colors: [], joints: [], weights: [], indices: [] };
  for (const part of parts) {
    const color = [...linear(part.color).map((value) => Math.round(value * 255)), 255];
    const seen = new Map();
    const index = part.indices.map((i) => {
      const position = part.positions.slice(3 * i, 3 * i + 3).map(round);
      const normal = part.normals
        .slice(3 * i, 3 * i + 3)
        .map((value) => Math.round(value * 1e3) / 1e3 + 0);
      const key = [...position, ...normal].join();
      if (!seen.has(key)) {
        seen.set(key, all.positions.length / 3);
        all.positions.push(...position);
        all.normals.push(...normal);
        all.colors.push(...color);
        const carried = shares(part.weights(position));
        all.joints.push(...carried.map(([joint]) => joint));
        all.weights.push(...carried.map(([, share]) => share));
      }
      return seen.get(key);
    });
    all.indices.push(...index);
  }
  return all;
}

/** Four joints' numbers with their shares of 255. */
function shares(weights) {
  const list = [...weights].sort((a, b) => b[1] - a[1]).slice(0, 4);
  const sum = list.reduce((total, [, weight]) => total + weight, 0);
  const parts = list.map(([name, weight]) => [
    JOINTS.findIndex((joint) => joint.name === name),
    Math.round((255 * weight) / sum),
  ]);
  if (parts.some(([joint]) => joint < 0)) throw new Error(`No such joint: ${weights}`);
  parts[0][1] += 255 - parts.reduce((total, [, share]) => total + share, 0);
  while (parts.length < 4) parts.push([0, 0]);
  return parts;
}
