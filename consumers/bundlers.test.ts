import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import { bundle, BUNDLER_NAMES } from './bundlers.mjs';
import { packed } from './packed.mjs';

let folder: string;
let installed: string;
beforeAll(() => {
  ({ folder, installed } = packed('shaken'));
});

/** By their messages, which no minifier touches, one knows what is in a bundle. */
const SIGNS = ['CharacterController', 'CharacterControls', 'CubeColliderGroup', 'AxisResponse'];
const isIn = (code: string, name: string) => new RegExp(`${name}(: |["'\`])`).test(code);

describe('an app that wants the collider alone', () => {
  it.each(BUNDLER_NAMES)('should ship neither characters nor controls: %s', async (bundler) => {
    const files = readdirSync(join(installed, 'dist')).filter((name) => name.endsWith('.js'));
    const all = files.map((name) => readFileSync(join(installed, 'dist', name), 'utf8')).join('');
    const { code } = await bundle(bundler, 'shaken', folder, true);
    expect(isIn(code, 'CubeCollider')).toBe(true);
    for (const name of SIGNS) {
      expect(isIn(all, name), `${name} in the package`).toBe(true);
      expect(isIn(code, name), `${name} in the app`).toBe(false);
    }
  });
});
