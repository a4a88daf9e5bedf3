// @ts-check
// A plugin of Vite: the built demo works without a network once it has been visited.
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';

/**
 * What browsers fetch on their own, or never; and what is large, and a visitor may never ask for, which is kept once it
 * was: Rapier, the other renderer, decoders, other levels.
 */
const LEFT_OUT = /^icon-|\.map$|^examples\/|rapier|webgpu|draco|basis|KTX2/i;

/**
 * Writes `sw.js` beside the page, a service worker that keeps what the page leads to and the public folder.
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
      const kept = reachedFrom('index.html', bundle).map((file) => [
        file.fileName,
        file.type === 'chunk' ? file.code : file.source,
      ]);
      for (const entry of readdirSync(publicDir, { recursive: true, withFileTypes: true })) {
        const path = join(entry.parentPath, entry.name);
        const name = relative(publicDir, path).replaceAll('\\', '/');
        if (entry.isFile() && !LEFT_OUT.test(name)) kept.push([name, readFileSync(path)]);
      }
      kept.sort(([a], [b]) => (a < b ? -1 : 1));
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

/**
 * A page, and what it or its scripts may load: scripts at once or later, styles, fonts.
 *
 * @param {string} page
 * @param {import('vite').Rolldown.OutputBundle} bundle
 */
function reachedFrom(page, bundle) {
  const reached = new Set([bundle[page]]);
  /** @param {string} name */
  const follow = (name) => {
    const file = bundle[name];
    if (!file || reached.has(file) || LEFT_OUT.test(name)) return;
    reached.add(file);
    if (file.type !== 'chunk') return;
    const { importedCss = [], importedAssets = [] } = file.viteMetadata ?? {};
    for (const next of [...file.imports, ...file.dynamicImports, ...importedCss, ...importedAssets])
      follow(next);
  };
  for (const file of Object.values(bundle))
    if (file.type === 'chunk' && file.facadeModuleId?.endsWith(`/${page}`)) follow(file.fileName);
  return [...reached];
}
