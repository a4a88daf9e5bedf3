import type { GltfJson } from './inspect.js';
import { LevelError } from './LevelError.js';

/** A file with its path in what was dropped: `castle/textures/wall.png`. */
export interface PathedFile {
  path: string;
  file: File;
}

/** In place of a picture that is not there: one white pixel. */
const WHITE =
  'data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAGr2IfAAAAABJRU5ErkJggg==';
/** Where they lie for three, which joins a file's own addresses to it. */
export const ROOT = 'dropped://files/';

/** Files that were dropped together: a GLB, or a glTF with what it names. */
export class LevelFiles {
  readonly main: PathedFile;
  readonly #files = new Map<string, File>();
  readonly #urls = new Map<File, string>();

  /** @throws LevelError where no file is there */
  constructor(files: readonly PathedFile[]) {
    const depth = ({ path }: PathedFile) => path.split('/').length;
    const rank = ({ path }: PathedFile) =>
      /\.glb$/i.test(path) ? 0 : /\.gltf$/i.test(path) ? 1 : 2;
    const [main] = [...files].sort(
      (a, b) => rank(a) - rank(b) || depth(a) - depth(b) || b.file.size - a.file.size,
    );
    if (main === undefined)
      throw new LevelError('No file is in there: drop a .glb, or a .gltf with its files.');
    this.main = main;
    for (const { path, file } of files) this.#files.set(path.toLowerCase(), file);
  }

  /** The folder of the main file, as an address. */
  get base(): string {
    return ROOT + this.main.path.slice(0, this.main.path.lastIndexOf('/') + 1);
  }

  /**
   * @returns pictures that are named and not there: the level is walked without them
   * @throws LevelError where numbers are missing
   */
  check({ buffers = [], images = [] }: GltfJson): string[] {
    const missing = (list: { uri?: string }[]) =>
      list.flatMap(({ uri }) =>
        uri !== undefined && !isAbsolute(uri) && this.#find(this.base + uri) === undefined
          ? decode(uri)
          : [],
      );
    const [needed] = missing(buffers);
    if (needed !== undefined)
      throw new LevelError(
        `“${this.main.path}” needs “${needed}”: drop the two together, or the whole folder.`,
      );
    return missing(images);
  }

  /** The address that three is to load in place of another. */
  readonly resolve = (url: string): string => {
    if (!url.startsWith(ROOT)) return url;
    const file = this.#find(url);
    if (file === undefined) return WHITE;
    const known = this.#urls.get(file) ?? URL.createObjectURL(file);
    this.#urls.set(file, known);
    return known;
  };

  /** Lets go of the files' addresses. */
  dispose(): void {
    for (const url of this.#urls.values()) URL.revokeObjectURL(url);
    this.#urls.clear();
  }

  /** By its path; or by its name alone, where folders were not dropped with it. */
  #find(url: string): File | undefined {
    const path = tidy(decode(url.slice(ROOT.length))).toLowerCase();
    const exact = this.#files.get(path);
    if (exact !== undefined) return exact;
    const name = path.slice(path.lastIndexOf('/') + 1);
    return [...this.#files].find(([each]) => each === name || each.endsWith(`/${name}`))?.[1];
  }
}

const isAbsolute = (uri: string) => /^[a-z][a-z\d+.-]*:|^\/\//i.test(uri);

function decode(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

/** Without `.`, `..`, doubled and turned slashes. */
function tidy(path: string): string {
  const parts: string[] = [];
  for (const part of path.replaceAll('\\', '/').split('/')) {
    if (part === '..') parts.pop();
    else if (part !== '.' && part !== '') parts.push(part);
  }
  return parts.join('/');
}
