import { LevelError } from './LevelError.js';

/** What is read of a glTF file before three does. */
export interface GltfJson {
  asset?: { version?: string };
  extensionsUsed?: string[];
  buffers?: { uri?: string }[];
  images?: { uri?: string; bufferView?: number }[];
  accessors?: { count?: number }[];
  meshes?: {
    primitives?: { mode?: number; indices?: number; attributes?: { POSITION?: number } }[];
  }[];
}

/** What a page can hold: bytes of a file, and triangles. */
const [MOST_BYTES, MOST_TRIANGLES] = [400e6, 12e6];
const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;

const EXPORT = 'export it as .glb (in Blender: File › Export › glTF 2.0) and drop that.';

/** By the end of a name: what somebody may well try. */
const OTHERS: Record<string, string> = {
  zip: 'is an archive: unpack it and drop the folder in it.',
  rar: 'is an archive: unpack it and drop the folder in it.',
  '7z': 'is an archive: unpack it and drop the folder in it.',
  bin: 'holds only the numbers of a glTF: drop the .gltf together with it.',
};

/**
 * Looks at a file's head, without reading the rest.
 *
 * @throws LevelError where three would not make a level of it
 */
export async function inspect(name: string, blob: Blob): Promise<GltfJson> {
  if (blob.size === 0) fail(name, 'is empty: export or download it again.');
  if (blob.size > MOST_BYTES)
    fail(
      name,
      `is too large, ${megabytes(blob.size)}: make it smaller than ${megabytes(MOST_BYTES)}, with fewer triangles or compressed (gltf-transform optimize).`,
    );
  const head = new DataView(await blob.slice(0, 20).arrayBuffer());
  const json =
    head.byteLength >= 4 && head.getUint32(0, true) === MAGIC
      ? parse(name, await jsonChunk(name, blob, head))
      : parse(name, await plainText(name, blob));
  check(name, json);
  return json;
}

async function jsonChunk(name: string, blob: Blob, head: DataView): Promise<string> {
  if (head.byteLength < 20) fail(name, 'is cut off: export or download it again.');
  const version = head.getUint32(4, true);
  if (version !== 2) fail(name, `is glTF ${version}, and only glTF 2.0 is read: ${EXPORT}`);
  const length = head.getUint32(8, true);
  if (length > blob.size)
    fail(
      name,
      `is cut off, ${megabytes(blob.size)} of ${megabytes(length)}: export or download it again.`,
    );
  const chunk = head.getUint32(12, true);
  if (head.getUint32(16, true) !== JSON_CHUNK || 20 + chunk > blob.size)
    fail(name, 'is broken, its contents do not follow its head: export it again.');
  return blob.slice(20, 20 + chunk).text();
}

/** A glTF is text; what is not looks like none from its first characters on. */
async function plainText(name: string, blob: Blob): Promise<string> {
  const first = await blob.slice(0, 64).text();
  if (!/^\uFEFF?\s*\{/.test(first)) {
    const end = /\.([^.]+)$/.exec(name)?.[1]?.toLowerCase() ?? '';
    if (end === 'glb' || end === 'gltf')
      fail(name, 'is broken, it does not begin as a glTF file does: export it again.');
    fail(name, OTHERS[end] ?? `is no glTF file: ${EXPORT}`);
  }
  return blob.text();
}

function parse(name: string, text: string): GltfJson {
  try {
    return JSON.parse(text) as GltfJson;
  } catch {
    return fail(name, 'is broken, its description cannot be read: export it again.');
  }
}

function check(name: string, json: GltfJson): void {
  const version = json.asset?.version;
  if (typeof version !== 'string') fail(name, `is no glTF file: ${EXPORT}`);
  if (!version.startsWith('2'))
    fail(name, `is glTF ${version}, and only glTF 2.0 is read: ${EXPORT}`);
  const triangles = countTriangles(json);
  if (triangles === 0)
    fail(name, 'has no surface to walk on, no mesh of triangles: export it with its meshes.');
  if (triangles > MOST_TRIANGLES)
    fail(
      name,
      `has ${Math.round(triangles / 1e6)} million triangles: simplify it to fewer than ${MOST_TRIANGLES / 1e6} million (gltf-transform simplify).`,
    );
}

/** In all meshes, each once. */
function countTriangles({ meshes = [], accessors = [] }: GltfJson): number {
  let corners = 0;
  for (const { primitives = [] } of meshes)
    for (const { mode = 4, indices, attributes } of primitives) {
      const accessor = accessors[indices ?? attributes?.POSITION ?? -1];
      if (mode >= 4) corners += accessor?.count ?? 0;
    }
  return Math.ceil(corners / 3);
}

const megabytes = (bytes: number) => `${(bytes / 1e6).toFixed(bytes < 1e7 ? 1 : 0)} MB`;

function fail(name: string, what: string): never {
  throw new LevelError(`“${name}” ${what}`);
}
