import { execFile } from 'node:child_process';
import { cpSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, sep } from 'node:path';
import { promisify } from 'node:util';
import { checkPackage, createPackageFromTarballData } from '@arethetypeswrong/core';
import { publint } from 'publint';
import { formatMessage } from 'publint/utils';
import { beforeAll, describe, expect, it } from 'vitest';
import { packed } from './packed.mjs';

const run = promisify(execFile);
const manifest = JSON.parse(readFileSync('package.json', 'utf8'));
const entries = Object.keys(manifest.exports).filter((entry) => entry !== './package.json');

let folder: string;
let tarball: string;
let installed: string;
beforeAll(() => {
  ({ folder, tarball, installed } = packed('package'));
});

describe('the packed package', () => {
  it('should hold what a user needs, and no more', () => {
    const files = readdirSync(installed, { recursive: true, withFileTypes: true })
      .filter((entry) => entry.isFile())
      .map((entry) => join(entry.parentPath, entry.name).slice(installed.length + 1))
      .map((path) => path.split(sep).join('/'));
    expect(files.filter((path) => !path.startsWith('dist/')).sort()).toEqual(
      ['CHANGELOG.md', 'LICENSE', 'README.md', 'package.json'].sort(),
    );
    const others = files.filter((path) => !/^dist\/(.+\.d\.ts|[\w-]+\.js(\.map)?)$/.test(path));
    expect(others.filter((path) => !/^[\w.]+$/.test(path))).toEqual([]);
    for (const { types, default: code } of Object.values<Record<string, string>>(
      manifest.exports,
    )) {
      if (!types || !code) continue;
      for (const path of [types, code]) expect(files).toContain(path.slice(2));
    }
    for (const code of files.filter((path) => path.endsWith('.js'))) {
      const text = readFileSync(join(installed, code), 'utf8');
      // An entry that only hands on what another file has has nothing to map.
      if (/^(import .*\n|export .*\n|\n)*$/.test(text)) continue;
      expect(files, `the source map of ${code}`).toContain(`${code}.map`);
      const map = JSON.parse(readFileSync(join(installed, `${code}.map`), 'utf8'));
      expect(map.sourcesContent, `${code} brings its sources`).toHaveLength(map.sources.length);
    }
  });

  it('should please publint', async () => {
    const { messages } = await publint({ pkgDir: installed, level: 'suggestion', strict: true });
    expect(messages.map((message) => formatMessage(message, manifest))).toEqual([]);
  });

  it('should have types for whoever can import ES modules', async () => {
    const data = new Uint8Array(readFileSync(tarball));
    const result = await checkPackage(createPackageFromTarballData(data));
    if (!result.types) throw new Error('no types');
    // `require` of a package of ES modules alone, and the old way of finding files, which knows no `exports`.
    const meant = result.problems.filter(
      (problem) =>
        problem.kind !== 'CJSResolvesToESM' &&
        !('resolutionKind' in problem && problem.resolutionKind === 'node10'),
    );
    expect(meant).toEqual([]);
  });

  it.each(entries)('should load where there is no DOM: %s', async (entry) => {
    const name = entry.replace(/^\./, 'three-cube-collider');
    writeFileSync(
      join(folder, 'ssr.mjs'),
      `for (const name of ['window', 'document', 'HTMLElement', 'requestAnimationFrame']) {
         if (name in globalThis) throw new Error(name + ' is there');
       }
       const all = await import(${JSON.stringify(name)});
       if ('CubeCollider' in all) new all.CharacterController(new all.CubeCollider()).step(0.1);
       console.log(Object.keys(all).length);`,
    );
    // In Node, React Three Fiber asks for three by `require`, of which three warns.
    const flags = entry === './react' ? ['--no-deprecation'] : [];
    const { stdout, stderr } = await run(process.execPath, [...flags, 'ssr.mjs'], { cwd: folder });
    expect(stderr).toBe('');
    expect(Number(stdout)).toBeGreaterThan(0);
  });

  it('should compile in a strict app that checks its libraries', async () => {
    cpSync('consumers/projects/strict', folder, { recursive: true });
    const tsc = join('node_modules', 'typescript', 'bin', 'tsc');
    const { stdout } = await run(process.execPath, [tsc, '-p', folder]).catch((error) => error);
    expect(stdout).toBe('');
  });
});
