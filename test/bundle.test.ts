import { type Rolldown } from 'vite';
import { describe, expect, it } from 'vitest';
import { buildPackage, ship } from '../bench/bundle/ship.mjs';

type Files = Map<string, Rolldown.OutputChunk>;

/** What a page ships that imports these names, minified and compressed, three apart; kB. */
const shipped = async (files: Files, code: string) => (await ship(code, files)).gzipped / 1000;

/** What the files import from outside. */
function outside(files: Files): Set<string> {
  const imports = [...files.values()].flatMap((file) => file.imports);
  return new Set(imports.filter((name) => !files.has(name)));
}

describe('the package’s entries', () => {
  it('should leave WebGPU out of the root', async () => {
    const files = await buildPackage('lib');
    expect(outside(files)).toEqual(new Set(['three']));
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

  it('should leave WebGLRenderer out of the one for WebGPU', async () => {
    const files = await buildPackage('lib-webgpu');
    expect(outside(files)).toEqual(new Set(['three/webgpu', 'three/tsl']));
    const all = await shipped(files, "export * from './webgpu.js'");
    const collider = await shipped(files, "export { CubeCollider } from './webgpu.js'");
    console.log(`    webgpu ${all.toFixed(1)} kB, CubeCollider alone ${collider.toFixed(1)} kB`);
    expect(all).toBeLessThan(59);
    expect(collider).toBeLessThan(26);
  }, 60_000);
});
