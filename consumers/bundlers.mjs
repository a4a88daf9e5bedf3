// @ts-check
import { cpSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { build as esbuild } from 'esbuild';
import { build as vite } from 'vite';
import webpack from 'webpack';
import { root } from '../scripts/run.mjs';

/**
 * How each bundler, left at its defaults for production, makes one file of an app.
 *
 * @type {Record<string, (entry: string, folder: string, small: boolean) => Promise<unknown>>} the app's main file, where
 *   `bundle.js` goes, and whether it has to be minified, three apart
 */
const BUNDLERS = {
  Vite: (entry, folder) =>
    vite({
      configFile: false,
      root: folder,
      logLevel: 'error',
      build: {
        outDir: folder,
        emptyOutDir: false,
        chunkSizeWarningLimit: 2000, // three
        rolldownOptions: {
          input: entry,
          output: { entryFileNames: 'bundle.js' },
          preserveEntrySignatures: 'strict',
        },
      },
    }),
  'webpack 5': (entry, folder, small) =>
    new Promise((resolve, reject) => {
      webpack(
        {
          mode: 'production',
          entry,
          output: { path: folder, filename: 'bundle.js', library: { type: 'module' } },
          experiments: { outputModule: true },
          performance: false,
          // Terser takes seconds for three; what is only opened need not be small.
          externals: small ? [/^three($|\/)/] : [],
          optimization: { minimize: small },
        },
        (error, stats) => {
          if (error ?? stats?.hasErrors() ?? stats?.hasWarnings()) {
            reject(error ?? new Error(stats?.toString()));
          } else resolve(stats);
        },
      );
    }),
  esbuild: (entry, folder) =>
    esbuild({
      entryPoints: [entry],
      outfile: join(folder, 'bundle.js'),
      bundle: true,
      minify: true,
      format: 'esm',
      logLevel: 'error',
    }),
};

export const BUNDLER_NAMES = Object.keys(BUNDLERS);

/**
 * Bundles one of `projects/` against the packed package.
 *
 * @param {string} bundler
 * @param {string} project
 * @param {string} folder where the package is installed
 * @param {boolean} [small] whether to minify it whatever that costs; webpack then leaves three outside
 * @returns {Promise<{ file: string, code: string }>}
 */
export async function bundle(bundler, project, folder, small = false) {
  const name = `${project}-${bundler.replace(/\W/g, '-')}`;
  const target = join(folder, name);
  cpSync(join(root, 'consumers/projects', project), target, { recursive: true });
  mkdirSync(target, { recursive: true });
  writeFileSync(join(target, 'package.json'), '{ "type": "module" }');
  await BUNDLERS[bundler]?.(join(target, 'main.js'), target, small);
  const file = join(target, 'bundle.js');
  return { file, code: readFileSync(file, 'utf8') };
}
