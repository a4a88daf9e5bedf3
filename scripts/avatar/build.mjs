// `npm run build:avatar [-- file.glb]`: writes public/avatar.glb, the same bytes on every run.

import { mkdir, writeFile } from 'node:fs/promises';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { body } from './body.mjs';
import { clips } from './clips.mjs';
import { writeAvatar } from './write.mjs';

const parts = body();
const bytes = await writeAvatar(parts, clips());

const file = process.argv[2] ?? fileURLToPath(new URL('../../public/avatar.glb', import.meta.url));
await mkdir(dirname(file), { recursive: true });
await writeFile(file, bytes);

const triangles = parts.reduce((sum, { indices }) => sum + indices.length / 3, 0);
console.log(`${file}: ${(bytes.length / 1e3).toFixed(0)} kB, ${triangles} triangles`);
