import { FileLoader, LoaderUtils, LoadingManager, type WebGLRenderer } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { DEFAULT_LEVEL } from '../parameters.js';
import { addDecoders } from './decoders.js';
import { inspect } from './inspect.js';
import { Level } from './Level.js';
import { LevelError } from './LevelError.js';
import { LevelFiles, type PathedFile } from './LevelFiles.js';

/** Told what is going on: a part from 0 to 1, or NaN where nobody knows. */
export type Progress = (part: number) => void;

/** A level, and what of it is not as it should be. */
export interface Loaded {
  level: Level;
  /** Pictures that it names and that were not there. */
  missing: string[];
}

/**
 * Fetches a GLB or glTF file, and what it names.
 *
 * @param onProgress called with 0 to 1 while the file comes in, where the server tells its size, and with 1 at the end.
 * @throws Error that names the url, if the file cannot be fetched or read.
 */
export async function loadLevel(
  url: string,
  renderer: WebGLRenderer,
  onProgress: Progress,
): Promise<Level> {
  try {
    const blob = (await new FileLoader().setResponseType('blob').loadAsync(url, (event) => {
      if (event.total > 0) onProgress(Math.min(1, event.loaded / event.total));
    })) as unknown as Blob;
    const name = nameOf(url);
    const json = await inspect(name, blob);
    const loader = new GLTFLoader();
    await addDecoders(loader, json, renderer);
    const gltf = await loader.parseAsync(await blob.arrayBuffer(), LoaderUtils.extractUrlBase(url));
    onProgress(1);
    return new Level(name, gltf.scene, gltf.animations, url === DEFAULT_LEVEL);
  } catch (cause) {
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new LevelError(`The level "${url}" could not be loaded: ${reason}`, { cause });
  }
}

/**
 * Reads files that were dropped or picked together.
 *
 * @throws LevelError that says what is wrong and what to do
 */
export async function readLevel(
  dropped: readonly PathedFile[],
  renderer: WebGLRenderer,
  onProgress: Progress,
): Promise<Loaded> {
  const files = new LevelFiles(dropped);
  const { path, file } = files.main;
  onProgress(NaN);
  try {
    const json = await inspect(path, file);
    const missing = files.check(json);
    const manager = new LoadingManager();
    manager.setURLModifier(files.resolve);
    manager.onProgress = (_, loaded, total) => onProgress(loaded / total);
    const loader = new GLTFLoader(manager);
    await addDecoders(loader, json, renderer);
    const gltf = await loader.parseAsync(await file.arrayBuffer(), files.base);
    return { level: new Level(nameOf(path), gltf.scene, gltf.animations, false), missing };
  } catch (cause) {
    if (cause instanceof LevelError) throw cause;
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new LevelError(
      `“${path}” is broken: export it again, or try it in another viewer. (${reason})`,
      { cause },
    );
  } finally {
    files.dispose();
  }
}

/** The last part of an address or path. */
function nameOf(url: string): string {
  return url.replace(/[?#].*$/, '').replace(/^.*\/(?=.)/, '');
}
