import { execFile } from 'node:child_process';
import { mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { NodeIO } from '@gltf-transform/core';
import { EXTTextureWebP, KHRMeshQuantization } from '@gltf-transform/extensions';
import sharp from 'sharp';
import { describe, expect, it } from 'vitest';

const io = new NodeIO().registerExtensions([EXTTextureWebP, KHRMeshQuantization]);

/** A file without its pictures, and their pixels: what encodes them may differ from machine to machine. */
async function apart(path: string): Promise<{ bare: Uint8Array; pictures: Uint8Array[] }> {
  const document = await io.read(path);
  const textures = document.getRoot().listTextures();
  const pictures = await Promise.all(
    textures.map((texture) => sharp(texture.getImage()!).raw().toBuffer()),
  );
  for (const texture of textures) texture.setImage(new Uint8Array(4));
  return { bare: await io.writeBinary(document), pictures };
}

/** Mean difference, of 255. */
function difference(a: Uint8Array, b: Uint8Array): number {
  return a.reduce((sum, value, i) => sum + Math.abs(value - b[i]!), 0) / a.length;
}

describe('the level', () => {
  it(
    'should be, like the examples beside it, what npm run build:level makes, byte for byte but for pictures',
    { timeout: 300_000 },
    async () => {
      const folder = await mkdtemp(join(tmpdir(), 'level-'));
      try {
        const file = join(folder, 'level.glb');
        await promisify(execFile)(process.execPath, ['scripts/level/build.mjs', file]);
        const [made, kept] = await Promise.all([file, 'public/level.glb'].map(apart));
        expect(Buffer.compare(made!.bare, kept!.bare)).toBe(0);
        expect(made!.pictures.length).toBe(13);
        for (const [i, picture] of made!.pictures.entries())
          expect(difference(picture, kept!.pictures[i]!)).toBeLessThan(1);
        const tiles = await readdir('public/examples/tiles');
        expect(tiles.length).toBe(33);
        for (const name of [
          ...['maze', 'tower', 'valley'].map((each) => `examples/${each}.glb`),
          ...tiles.map((each) => `examples/tiles/${each}`),
        ]) {
          const [made, kept] = await Promise.all(
            [join(folder, name), join('public', name)].map((path) => readFile(path)),
          );
          expect(made!.equals(kept!), name).toBe(true);
        }
      } finally {
        await rm(folder, { recursive: true });
      }
    },
  );

  it('should have every feature that a walk needs, by name', async () => {
    const root = (await io.read('public/level.glb')).getRoot();
    const names = root.listNodes().map((node) => node.getName());
    expect(names).toEqual(
      expect.arrayContaining([
        'spawn',
        'ground',
        ...['0.06', '0.10', '0.20', '0.30', '0.40', '0.50'].map((rise) => `steps-${rise}`),
        ...[15, 30, 45, 60].map((angle) => `ramp-${angle}`),
        ...['0.05', '0.08', '0.12'].map((rise) => `kerb-${rise}`),
        'spiral-stair',
        'bridge',
        'arch',
        'columns',
        'corridor',
        'doorway',
        'low-ceiling',
        'ledge',
        'railing',
        'pole-10mm',
        'terrain',
        'pit',
        'footbridge',
        'tower',
      ]),
    );
  });
});
