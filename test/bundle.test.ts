import { type Rolldown } from 'vite';
import { describe, expect, it } from 'vitest';
import { buildPackage, ship } from '../bench/bundle/ship.mjs';

type Files = Map<string, Rolldown.OutputChunk>;

/** What a page ships that imports these names, minified and compressed, three apart; kB. */
const shipped = async (files: Files, code: string) => (await ship(code, files)).gzipped / 1000;

/** What an entry, and the files that it leads to, import from outside. */
function outside(files: Files, entry: string, seen = new Set<string>()): Set<string> {
  const imports = files.get(entry)!.imports.filter((name) => !seen.has(name));
  for (const name of imports) {
    seen.add(name);
    if (files.has(name)) outside(files, name, seen);
  }
  return new Set([...seen].filter((name) => !files.has(name)));
}

/** A module with what `code` imports from a package, and nothing in it. */
function standIn(code: string, name: string): Rolldown.OutputChunk {
  const [, names] = new RegExp(`import \\{([^}]+)\\} from "${name}"`).exec(code)!;
  const lines = names!
    .split(',')
    .map((each) => `export const ${each} = globalThis.${each.trim()};`);
  return { code: lines.join('\n') } as Rolldown.OutputChunk;
}

describe('the package’s entries', () => {
  it('should leave WebGPU out of the root', async () => {
    const files = await buildPackage('lib');
    expect(outside(files, 'index.js')).toEqual(new Set(['three']));
    expect(outside(files, 'helpers.js')).toEqual(new Set(['three']));
    const all = await shipped(files, "export * from './index.js'");
    const collider = await shipped(files, "export { CubeCollider } from './index.js'");
    const names = 'CubeCollider, CharacterController';
    const core = await shipped(files, `export { ${names} } from './index.js'`);
    console.log(
      `    root ${all.toFixed(1)} kB, with CharacterController ${core.toFixed(1)} kB, CubeCollider alone ${collider.toFixed(1)} kB`,
    );
    expect(all).toBeLessThan(63);
    expect(core).toBeLessThan(all);
    expect(collider).toBeLessThan(30);
  }, 60_000);

  it('should add little for React, and for debug pictures', async () => {
    const files = await buildPackage('lib');
    const fiber = '@react-three/fiber';
    expect(outside(files, 'react.js')).toEqual(new Set(['three', 'react', fiber]));
    const { code } = files.get('react.js')!;
    files.set('react', standIn(code, 'react')).set('fiber', standIn(code, fiber));
    const root = await shipped(files, "export * from './index.js'");
    const both = (name: string) =>
      shipped(files, `export * from './index.js'; export * from './${name}'`);
    const react = (await both('react.js')) - root;
    const helpers = (await both('helpers.js')) - root;
    // Its colliders are the root's unless told otherwise: who draws with WebGPURenderer ships those, too.
    const nodes = [...(await buildPackage('lib-webgpu'))];
    const other = "export * from './react.js'; export { CubeCollider } from './webgpu.js'";
    const alone = await shipped(files, "export * from './react.js'");
    const webgpu = (await shipped(new Map([...files, ...nodes]), other)) - alone;
    console.log(
      `    besides the root: react ${react.toFixed(1)} kB, helpers ${helpers.toFixed(1)} kB; besides react: WebGPU’s collider ${webgpu.toFixed(1)} kB`,
    );
    expect(react).toBeGreaterThan(1);
    expect(react).toBeLessThan(4);
    expect(helpers).toBeLessThan(10);
    expect(webgpu).toBeLessThan(28);
  }, 60_000);

  it('should leave WebGLRenderer out of the one for WebGPU', async () => {
    const files = await buildPackage('lib-webgpu');
    expect(outside(files, 'webgpu.js')).toEqual(new Set(['three/webgpu', 'three/tsl']));
    const all = await shipped(files, "export * from './webgpu.js'");
    const collider = await shipped(files, "export { CubeCollider } from './webgpu.js'");
    console.log(`    webgpu ${all.toFixed(1)} kB, CubeCollider alone ${collider.toFixed(1)} kB`);
    expect(all).toBeLessThan(59);
    expect(collider).toBeLessThan(27);
  }, 60_000);
});
