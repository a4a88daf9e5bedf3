import type {
  BufferAttribute,
  BufferGeometry,
  InstancedMesh,
  InterleavedBufferAttribute,
  Mesh,
} from 'three';
import { isRigid } from './isRigid.js';
import type { Vertices } from './Vertices.js';

/** What a whole number of a normalized attribute stands for; 32-bit ones are rare enough. */
const FACTORS: Record<string, number> = {
  Int8Array: 1 / 127,
  Uint8Array: 1 / 255,
  Int16Array: 1 / 32767,
  Uint16Array: 1 / 65535,
};

/** Is each triangle where its vertices say, once, so that those out of reach may be left out? */
export function isPlain(mesh: Mesh): boolean {
  const { isInstancedMesh, isBatchedMesh } = mesh as InstancedMesh & { isBatchedMesh?: boolean };
  if (isInstancedMesh || isBatchedMesh || !isRigid(mesh, 'all')) return false;
  return !(mesh.geometry as { isInstancedBufferGeometry?: boolean }).isInstancedBufferGeometry;
}

/** How many triangles a geometry has. */
export function trianglesOf({ index, attributes }: BufferGeometry): number {
  return Math.floor((index ?? attributes.position!).count / 3);
}

/** A geometry's vertices, or null where the processor has none that it can read. */
export function verticesOf(geometry: BufferGeometry): Vertices | null {
  const position = geometry.attributes.position as BufferAttribute | InterleavedBufferAttribute;
  const interleaved = 'data' in position;
  const { array } = interleaved ? position.data : position;
  const index = geometry.index?.array ?? null;
  if (!ArrayBuffer.isView(array) || (geometry.index !== null && !ArrayBuffer.isView(index))) {
    return null;
  }
  if (position.itemSize !== 3 || 'isFloat16BufferAttribute' in position) return null;
  const factor = position.normalized ? FACTORS[array.constructor.name] : 1;
  if (factor === undefined) return null;
  return {
    array,
    stride: interleaved ? position.data.stride : 3,
    offset: interleaved ? position.offset : 0,
    factor,
    index,
    triangles: trianglesOf(geometry),
  };
}
