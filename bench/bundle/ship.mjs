// @ts-check
import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { build } from 'vite';

/** @typedef {import('vite').Rolldown.OutputChunk} Chunk */

/** three itself; its addons are what a page ships for them. */
const THREE = /^three($|\/(webgpu|tsl)$)/;

/**
 * Builds the package as `npm run build` does.
 *
 * @param {'lib' | 'lib-webgpu'} mode
 * @returns {Promise<Map<string, Chunk>>} each file's code, by name
 */
export async function buildPackage(mode) {
  const built = await build({ mode, logLevel: 'error', build: { write: false } });
  const { output } = /** @type {import('vite').Rolldown.RolldownOutput} */ (
    Array.isArray(built) ? built[0] : built
  );
  const chunks = output.filter((each) => each.type === 'chunk');
  return new Map(chunks.map((chunk) => [chunk.fileName, chunk]));
}

/**
 * What a page with this code ships, three apart: bytes, minified, and those compressed.
 *
 * @param {string} code a module
 * @param {Map<string, { code: string }>} [files] what it may import as './name', besides packages
 */
export async function ship(code, files = new Map()) {
  const page = '\0page.js';
  const built = await build({
    configFile: false,
    publicDir: false,
    logLevel: 'error',
    plugins: [
      {
        name: 'memory',
        enforce: 'pre',
        resolveId: (id) => {
          const name = id.split('/').pop() ?? '';
          if (name === 'page') return page;
          return files.has(name) ? `\0${name}` : null;
        },
        load: (id) => (id === page ? code : files.get(id.slice(1))?.code),
      },
    ],
    build: {
      write: false,
      chunkSizeWarningLimit: 1e5,
      lib: { entry: 'page', formats: ['es'], fileName: 'page' },
      // Vite leaves the blanks of a library.
      rolldownOptions: { external: THREE, output: { minify: true } },
    },
  });
  const [{ output }] = /** @type {[import('vite').Rolldown.RolldownOutput]} */ (built);
  const minified = output.map((each) => (each.type === 'chunk' ? each.code : '')).join('');
  return { minified: Buffer.byteLength(minified), gzipped: gzipSync(minified).length };
}

/** A file that is shipped as it is. @param {string} file */
export function shipFile(file) {
  const bytes = readFileSync(file);
  return { minified: bytes.length, gzipped: gzipSync(bytes).length };
}
