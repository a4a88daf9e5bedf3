import { gzipSync } from 'node:zlib';
import { build, type Rolldown } from 'vite';
import { describe, expect, it } from 'vitest';

/** Builds the package as `npm run build` does. @returns each file's code, by name */
async function buildPackage(mode: string): Promise<Map<string, Rolldown.OutputChunk>> {
  const built = await build({ mode, logLevel: 'error', build: { write: false } });
  const { output } = (Array.isArray(built) ? built[0]! : built) as Rolldown.RolldownOutput;
  const chunks = output.filter((each) => each.type === 'chunk');
  return new Map(chunks.map((chunk) => [chunk.fileName, chunk]));
}

/** What a page ships that imports these names, minified and compressed, three apart; kB. */
async function shipped(files: Map<string, Rolldown.OutputChunk>, code: string): Promise<number> {
  const built = await build({
    configFile: false,
    logLevel: 'error',
    plugins: [
      {
        name: 'memory',
        enforce: 'pre',
        resolveId: (id) => {
          const name = id.split('/').pop()!;
          return name === 'page' || files.has(name) ? `\0${name}` : null;
        },
        load: (id) => (id === '\0page' ? code : files.get(id.slice(1))?.code),
      },
    ],
    build: {
      write: false,
      lib: { entry: 'page', formats: ['es'], fileName: 'page' },
      // Vite leaves the blanks of a library.
      rolldownOptions: { external: /^three($|\/)/, output: { minify: true } },
    },
  });
  const [{ output }] = built as [Rolldown.RolldownOutput];
  return gzipSync(output[0].code).length / 1000;
}

/** What the files import from outside. */
function outside(files: Map<string, Rolldown.OutputChunk>): Set<string> {
  const imports = [...files.values()].flatMap((file) => file.imports);
  return new Set(imports.filter((name) => !files.has(name)));
}

describe('the package’s entries', () => {
  it('should leave WebGPU out of the root', async () => {
    const files = await buildPackage('lib');
    expect(outside(files)).toEqual(new Set(['three']));
    const all = await shipped(files, "export * from './index.js'");
    const collider = await shipped(files, "export { CubeCollider } from './index.js'");
    console.log(`    root ${all.toFixed(1)} kB, CubeCollider alone ${collider.toFixed(1)} kB`);
    expect(all).toBeLessThan(58);
    expect(collider).toBeLessThan(30);
  }, 60_000);

  it('should leave WebGLRenderer out of the one for WebGPU', async () => {
    const files = await buildPackage('lib-webgpu');
    expect(outside(files)).toEqual(new Set(['three/webgpu', 'three/tsl']));
    const all = await shipped(files, "export * from './webgpu.js'");
    const collider = await shipped(files, "export { CubeCollider } from './webgpu.js'");
    console.log(`    webgpu ${all.toFixed(1)} kB, CubeCollider alone ${collider.toFixed(1)} kB`);
    expect(all).toBeLessThan(54);
    expect(collider).toBeLessThan(26);
  }, 60_000);
});
