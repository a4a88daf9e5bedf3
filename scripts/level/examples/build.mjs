// `npm run build:level` writes public/examples too, the same bytes on every run.

import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { NodeIO } from '@gltf-transform/core';
import { EXTMeshoptCompression, KHRMeshQuantization } from '@gltf-transform/extensions';
import { meshopt } from '@gltf-transform/functions';
import { MeshoptEncoder } from 'meshoptimizer';
import { bakeVertices, occluders } from '../occlusion.mjs';
import { writeLevel } from '../write.mjs';
import { maze } from './maze.mjs';
import { buildTiles } from './tiles.mjs';
import { tower } from './tower.mjs';
import { valley } from './valley.mjs';

/** Levels to try in the demo: small, without pictures, shaded by what is baked into their vertices, compressed by meshopt. */
const EXAMPLES = { maze, tower, valley };

async function compress(document) {
  await MeshoptEncoder.ready;
  await document.transform(meshopt({ encoder: MeshoptEncoder, level: 'high' }));
  return new NodeIO()
    .registerExtensions([EXTMeshoptCompression, KHRMeshQuantization])
    .registerDependencies({ 'meshopt.encoder': MeshoptEncoder });
}

/** Writes them all into a folder. */
export async function buildExamples(folder) {
  await mkdir(folder, { recursive: true });
  for (const [name, make] of Object.entries(EXAMPLES)) {
    const { shapes, spawn } = make();
    bakeVertices(shapes, occluders(shapes), { rays: 24, skip: ['terrain'] });
    const bytes = await writeLevel({ shapes, textures: {}, spawn, compress });
    await writeFile(join(folder, `${name}.glb`), bytes);
    console.log(`${name}.glb: ${(bytes.length / 1e3).toFixed(0)} kB`);
  }
  console.log(`tiles: ${((await buildTiles(join(folder, 'tiles'))) / 1e3).toFixed(0)} kB`);
}
