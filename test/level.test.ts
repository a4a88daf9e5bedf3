import { execFile } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { NodeIO } from '@gltf-transform/core';
import { describe, expect, it } from 'vitest';

describe('the level', () => {
  it(
    'should be, like the examples beside it, what npm run build:level makes, byte for byte',
    { timeout: 300_000 },
    async () => {
      const folder = await mkdtemp(join(tmpdir(), 'level-'));
      try {
        const file = join(folder, 'level.glb');
        await promisify(execFile)(process.execPath, ['scripts/level/build.mjs', file]);
        const names = ['level', 'examples/maze', 'examples/tower', 'examples/valley'];
        for (const name of names.map((each) => `${each}.glb`)) {
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
    const root = (await new NodeIO().read('public/level.glb')).getRoot();
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
