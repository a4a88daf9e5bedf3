// @ts-check
// `npm run build:demo` ends with this: what dist-demo weighs as it is sent, compressed by gzip.

import { readdirSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

/**
 * Bytes of each file in a folder, gzipped, but source maps; the heaviest first.
 *
 * @param {string} folder
 * @returns {{ name: string, bytes: number }[]}
 */
export function weigh(folder) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && !entry.name.endsWith('.map'))
    .map((entry) => {
      const path = join(entry.parentPath, entry.name);
      const name = relative(folder, path).replaceAll('\\', '/');
      return { name, bytes: gzipSync(readFileSync(path), { level: 9 }).length };
    })
    .sort((a, b) => b.bytes - a.bytes);
}

/**
 * What a first visit brings: the files that its service worker keeps, and that one itself.
 *
 * @param {string} folder
 * @returns {string[]}
 */
export function firstVisit(folder) {
  const worker = readFileSync(join(folder, 'sw.js'), 'utf8');
  const [, kept] = /addAll\(\s*(\[[^\]]*\])/.exec(worker) ?? [];
  if (!kept) throw new Error('sw.js does not say what it keeps.');
  return ['sw.js', ...JSON.parse(kept)];
}

/** @param {{ bytes: number }[]} files */
export const total = (files) => files.reduce((sum, { bytes }) => sum + bytes, 0);

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const folder = fileURLToPath(new URL('../../dist-demo', import.meta.url));
  const files = weigh(folder);
  const first = new Set(firstVisit(folder));
  /** @param {number} bytes @param {string} rest */
  const line = (bytes, rest) => console.log(`${(bytes / 1000).toFixed(1).padStart(8)}  ${rest}`);
  const large = files.filter(({ bytes }) => bytes >= 1000);
  console.log('\nkB gzipped; * is loaded by a first visit');
  for (const { name, bytes } of large) line(bytes, `${first.has(name) ? '*' : ' '} ${name}`);
  line(total(files.slice(large.length)), `  ${files.length - large.length} smaller ones`);
  line(total(files), '  in all');
  line(total(files.filter(({ name }) => first.has(name))), '* a first visit');
}
