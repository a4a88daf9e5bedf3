import { readFile } from 'node:fs/promises';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const root = fileURLToPath(new URL('../..', import.meta.url));
const TYPES: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.webmanifest': 'application/manifest+json',
};

/** Builds the demo's page, as `npm run build:demo` does, into a folder of its own. */
export async function buildDemo(outDir: string): Promise<void> {
  const configFile = join(root, 'vite.config.ts');
  await build({ configFile, mode: 'production', logLevel: 'error', build: { outDir } });
}

/** Serves a folder of files under `/a/path/`, as any host would, and nothing beside it. */
export async function serve(folder: string): Promise<{ url: string; server: Server }> {
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url!, 'http://localhost');
    const name = /^\/a\/path\/([\w./-]*)$/.exec(pathname)?.[1]?.replace(/^$/, 'index.html');
    readFile(join(folder, name ?? '..'))
      .then((content) => {
        const type = TYPES[extname(name!)] ?? 'application/octet-stream';
        response.writeHead(200, { 'Content-Type': type }).end(content);
      })
      .catch(() => response.writeHead(404).end());
  });
  await new Promise<void>((resolve) => server.listen(0, 'localhost', resolve));
  return { url: `http://localhost:${(server.address() as AddressInfo).port}/a/path/`, server };
}
