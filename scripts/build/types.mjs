// @ts-check
// node scripts/build/types.mjs: leaves of the types in dist/ those that an entry leads to.
import { readdirSync, readFileSync, rmdirSync, rmSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { root } from '../run.mjs';

const dist = join(root, 'dist');

/** The files that `file`, a path in dist/, leads to, itself among them. @param {string} file @param {Set<string>} seen */
function follow(file, seen) {
  if (seen.has(file)) return seen;
  seen.add(file);
  const text = readFileSync(join(dist, file), 'utf8');
  for (const [, , path] of text.matchAll(/(from|import)\s*\(?['"](\.[^'"]+)\.js['"]/g)) {
    follow(join(dirname(file), `${path}.d.ts`), seen);
  }
  return seen;
}

const { exports } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
/** @type {Set<string>} */
const needed = new Set();
for (const { types } of Object.values(exports)) {
  if (types) follow(types.replace('./dist/', ''), needed);
}
for (const file of readdirSync(dist, { recursive: true, encoding: 'utf8' })) {
  if (file.endsWith('.d.ts') && !needed.has(file)) rmSync(join(dist, file));
}
for (const folder of readdirSync(dist, { withFileTypes: true })) {
  if (!folder.isDirectory()) continue;
  const path = join(dist, folder.name);
  if (readdirSync(path).length === 0) rmdirSync(path);
}
