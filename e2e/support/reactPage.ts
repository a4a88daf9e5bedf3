import { mkdir } from 'node:fs/promises';
import { build } from 'esbuild';
import { alias } from '../../vite.config.js';

/**
 * Bundles a page of React, against the sources: React is CommonJS, which the server of the browser tests does not serve.
 *
 * @param code a module of JSX, in the folder `from`
 * @param name of the file made of it
 * @returns its address on the server of the browser tests
 */
export async function buildReactPage(code: string, from: string, name: string): Promise<string> {
  await mkdir('.cache/react', { recursive: true });
  const outfile = `.cache/react/${name}.js`;
  await build({
    stdin: { contents: code, resolveDir: from, loader: 'tsx', sourcefile: `${name}.tsx` },
    outfile,
    bundle: true,
    format: 'esm',
    jsx: 'automatic',
    define: { 'process.env.NODE_ENV': '"development"' }, // StrictMode mounts twice only then
    alias: {
      ...alias,
      ...(process.env.THREE_VERSION === 'oldest' ? { three: 'three-oldest' } : {}),
    },
    logLevel: 'error',
  });
  return `/${outfile}`;
}
