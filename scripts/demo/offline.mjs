// @ts-check
// A plugin of Vite: the built demo works without a network once it has been visited.
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';

/**
 * What browsers fetch on their own, or never; and what a visitor may never ask for, which is kept once it was: rivals,
 * the other renderer, decoders, other levels.
 */
const LEFT_OUT = /^icon-|\.map$|^examples\/|rapier|MeshBVH|webgpu|draco|basis|KTX2/i;

/**
 * Writes `sw.js` beside the page, a service worker that keeps every file of the build and of the public folder.
 *
 * @returns {import('vite').Plugin}
 */
export function offline() {
  let publicDir = '';
  return {
    name: 'offline',
    apply: 'build',
    enforce: 'post',
    configResolved(config) {
      ({ publicDir } = config);
    },
    generateBundle(_, bundle) {
      /** @type {[string, string | Uint8Array][]} */
      const files = Object.values(bundle).map((file) => [
        file.fileName,
        file.type === 'chunk' ? file.code : file.source,
      ]);
      for (const entry of readdirSync(publicDir, { recursive: true, withFileTypes: true })) {
        if (!entry.isFile()) continue;
        const path = join(entry.parentPath, entry.name);
        files.push([relative(publicDir, path).replaceAll('\\', '/'), readFileSync(path)]);
      }
      const kept = files
        .filter(([name]) => !LEFT_OUT.test(name))
        .sort(([a], [b]) => (a < b ? -1 : 1));
      const hash = createHash('sha256');
      for (const [name, content] of kept) hash.update(name).update(content);
      const worker = readFileSync(new URL('./serviceWorker.js', import.meta.url), 'utf8')
        .replace(/^\/\/.*\n\/\*.*\n+/, '')
        .replace('PRECACHE_VERSION', JSON.stringify(hash.digest('hex').slice(0, 12)))
        .replace('PRECACHE_FILES', JSON.stringify(kept.map(([name]) => name)));
      this.emitFile({ type: 'asset', fileName: 'sw.js', source: worker });
    },
  };
}
