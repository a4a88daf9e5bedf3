// `npm run build:level [-- file.glb]`: writes public/level.glb, and the examples beside it, the same bytes on every run.

import { createHash } from 'node:crypto';
import { mkdir, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildExamples } from './examples/build.mjs';
import { SPAWN, level } from './layout.mjs';
import { bakeFloor, bakeVertices, occluders } from './occlusion.mjs';
import { quarters } from './quarters.mjs';
import { occlusionTexture, textures } from './textures.mjs';
import { FLOOR_MAP, writeLevel } from './write.mjs';

/** Texels of the floor's occlusion map along an edge: 0.24 m each. */
const FLOOR_TEXELS = 256;

const shapes = level();
const blocked = occluders(shapes);
bakeVertices(shapes, blocked, { skip: ['ground', 'pit', 'surroundings'] });
const floor = bakeFloor(blocked, { size: FLOOR_TEXELS, width: FLOOR_MAP });
const bytes = await writeLevel({
  shapes,
  textures: await textures(),
  occlusion: await occlusionTexture(floor, FLOOR_TEXELS),
  spawn: SPAWN,
});

const file = process.argv[2] ?? fileURLToPath(new URL('../../public/level.glb', import.meta.url));
await mkdir(dirname(file), { recursive: true });
await writeFile(file, bytes);
await buildExamples(join(dirname(file), 'examples'));

const primitives = shapes.flatMap((shape) => [...shape.parts.values()]);
const triangles = primitives.reduce((sum, { indices }) => sum + indices.length / 3, 0);
const draws = shapes.flatMap(quarters).reduce((sum, [, parts]) => sum + parts.size, 0);
const hash = createHash('sha256').update(bytes).digest('hex');
console.log(
  `${file}: ${(bytes.length / 1e6).toFixed(2)} MB, ${shapes.length} nodes, ${draws} draws, ${triangles} triangles, sha256 ${hash.slice(0, 16)}`,
);
