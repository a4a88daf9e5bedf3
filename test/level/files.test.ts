import { describe, expect, it } from 'vitest';
import { droppedFiles } from '../../demo/level/droppedFiles.js';
import { inspect } from '../../demo/level/inspect.js';
import { LevelFiles, ROOT } from '../../demo/level/LevelFiles.js';

const file = (path: string, text = 'x') => ({
  path,
  file: new File([text], path.replace(/^.*\//, '')),
});

describe('files that belong together', () => {
  it('should find what a glTF names, in folders, turned slashes and other cases', async () => {
    const files = new LevelFiles([
      file('castle/textures/Wall 1.png', 'wall'),
      file('castle/scene.gltf', '{}'),
      file('castle/scene.bin', 'numbers'),
    ]);
    expect(files.main.path).toBe('castle/scene.gltf');
    expect(files.base).toBe(`${ROOT}castle/`);
    for (const [uri, text] of [
      ['scene.bin', 'numbers'],
      ['./textures/wall%201.png', 'wall'],
      ['textures\\Wall 1.png', 'wall'],
      ['../elsewhere/Wall%201.png', 'wall'],
    ]) {
      const url = files.resolve(files.base + uri!);
      expect(await (await fetch(url)).text(), uri).toBe(text);
    }
    expect(files.resolve('blob:other')).toBe('blob:other');
    files.dispose();
  });

  it('should need the numbers, do without pictures, and leave addresses alone', () => {
    const files = new LevelFiles([file('a.gltf')]);
    expect(() => files.check({ buffers: [{ uri: 'a%20b.bin' }] })).toThrow(
      '“a.gltf” needs “a b.bin”: drop the two together',
    );
    const images = [{ uri: 'wall.png' }, { uri: 'data:image/png;base64,' }, { bufferView: 0 }];
    expect(files.check({ buffers: [{ uri: 'https://x.org/a.bin' }, {}], images })).toEqual([
      'wall.png',
    ]);
    expect(files.resolve(`${ROOT}wall.png`)).toMatch(/^data:image\/png/);
    expect(() => new LevelFiles([])).toThrow('No file is in there');
  });

  it('should take a GLB before a glTF, and the shallower of two', () => {
    const main = (...paths: string[]) => new LevelFiles(paths.map((path) => file(path))).main.path;
    expect(main('readme.md', 'a.gltf', 'x/b.glb')).toBe('x/b.glb');
    expect(main('x/y/a.gltf', 'x/b.gltf')).toBe('x/b.gltf');
  });

  it('should be read out of a dropped folder', async () => {
    const leaf = (name: string) => ({
      name,
      isFile: true,
      file: (done: (file: File) => void) => done(new File(['x'], name)),
    });
    const folder = (name: string, ...list: object[]) => ({
      name,
      isDirectory: true,
      createReader: () => ({
        readEntries: (done: (some: object[]) => void) => done(list.splice(0, 1)),
      }),
    });
    const castle = folder(
      'castle',
      leaf('a.gltf'),
      folder('textures', leaf('b.png')),
      leaf('a.bin'),
    );
    const data = { items: [{ webkitGetAsEntry: () => castle }], files: [] };
    const found = await droppedFiles(data as unknown as DataTransfer);
    expect(found.map(({ path }) => path)).toEqual([
      'castle/a.gltf',
      'castle/textures/b.png',
      'castle/a.bin',
    ]);
  });
});

describe('what is said of a file', () => {
  const mesh = { primitives: [{ attributes: { POSITION: 0 } }] };
  const gltf = (extra: object) => JSON.stringify({ asset: { version: '2.0' }, ...extra });

  it.each([
    ['old.gltf', '{"asset":{"version":"1.0"}}', /glTF 1.0, and only glTF 2.0/],
    ['odd.json', '{"a":1}', /is no glTF file/],
    ['cut.gltf', '{"asset":', /cannot be read/],
    ['points.gltf', gltf({ meshes: [{ primitives: [{ mode: 0 }] }] }), /no surface to walk on/],
    ['vast.gltf', gltf({ meshes: [mesh], accessors: [{ count: 9e7 }] }), /30 million triangles/],
    ['castle.zip', 'PK', /an archive: unpack it/],
    ['none', '', /is empty/],
  ])('should say of %s what is wrong and what to do', async (name, text, says) => {
    await expect(inspect(name, new Blob([text]))).rejects.toThrow(says);
  });

  it('should let through what is right', async () => {
    const text = gltf({ meshes: [mesh], accessors: [{ count: 36 }] });
    expect((await inspect('good.gltf', new Blob([text]))).meshes).toHaveLength(1);
  });
});
