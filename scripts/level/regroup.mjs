// Which bytes of a GLB file lie beside which.

const HEADER = 12;
const CHUNK = 8;

/**
 * The same file with its buffer views in another order: all positions, all normals, and so on, so that what is alike lies
 * together and a host's gzip finds it. The writer goes mesh by mesh.
 *
 * @param {Uint8Array} glb of one buffer, its own
 */
export function regroup(glb) {
  const file = Buffer.from(glb.buffer, glb.byteOffset, glb.length);
  const length = file.readUInt32LE(HEADER);
  const json = JSON.parse(file.toString('utf8', HEADER + CHUNK, HEADER + CHUNK + length));
  const binary = file.subarray(HEADER + CHUNK + length + CHUNK);
  const { bufferViews, accessors, meshes } = json;

  const kinds = bufferViews.map(() => '');
  for (const { attributes, indices } of meshes.flatMap(({ primitives }) => primitives))
    for (const [kind, i] of Object.entries({ ...attributes, INDEX: indices }))
      kinds[accessors[i].bufferView] = kind;
  const order = bufferViews.map((_, i) => i);
  order.sort((a, b) => (kinds[a] === kinds[b] ? a - b : kinds[a] < kinds[b] ? -1 : 1));

  const moved = Buffer.alloc(binary.length + 3 * order.length);
  let at = 0;
  for (const i of order) {
    const { byteOffset = 0, byteLength } = bufferViews[i];
    binary.copy(moved, at, byteOffset, byteOffset + byteLength);
    bufferViews[i].byteOffset = at;
    at = Math.ceil((at + byteLength) / 4) * 4;
  }
  json.buffers[0].byteLength = at;
  return join(Buffer.from(JSON.stringify(json)), moved.subarray(0, at));
}

/** A GLB file of its two chunks. */
function join(json, binary) {
  const text = Buffer.concat([json, Buffer.alloc(-json.length & 3, ' ')]);
  const head = (...words) => Buffer.from(Uint32Array.from(words).buffer);
  const length = HEADER + CHUNK + text.length + CHUNK + binary.length;
  return Buffer.concat([
    head(0x46546c67, 2, length),
    head(text.length, 0x4e4f534a),
    text,
    head(binary.length, 0x004e4942),
    binary,
  ]);
}
