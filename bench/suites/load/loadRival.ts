import { type BufferGeometry, Vector3 } from 'three';
import { heapBytes } from '../heap.js';
import { FRAME } from '../pace.js';
import { type Rival, rapierMemory } from '../rivals.js';
import type { Loaded } from './Loaded.js';

const START = new Vector3(0.571, 1, 0);
const STILL = new Vector3();

/** Bytes of WebAssembly before any level was in it. */
let emptyMemory = -1;

/** Builds what the rival needs, and steps once. Its code is loaded already, as ours is. */
export async function loadRival(rival: Rival, geometry: BufferGeometry): Promise<Loaded | null> {
  const memory = rival.name === 'Rapier' ? await rapierMemory() : null;
  if (memory && emptyMemory < 0) emptyMemory = memory.buffer.byteLength;
  const before = await heapBytes();
  const walker = await rival.create(geometry);
  const start = performance.now();
  walker.place(START);
  walker.frame(STILL, false, FRAME);
  const blocking = walker.preparation + performance.now() - start;
  const after = await heapBytes();
  let heap = before === null || after === null ? null : after - before;
  // The walker gives it a copy, for its triangles will be sorted; a page could do without.
  if (heap !== null && rival.name === 'three-mesh-bvh') heap -= bytesOf(geometry);
  if (rival.name === 'Rapier') {
    // WebAssembly's memory grows and never shrinks: sizes come in ascending order, so this one's need is all of it.
    heap = heap !== null && memory ? heap + memory.buffer.byteLength - emptyMemory : null;
  }
  walker.dispose();
  return { blocking, first: blocking, heap };
}

function bytesOf({ attributes, index }: BufferGeometry): number {
  return (index?.array.byteLength ?? 0) + attributes.position!.array.byteLength;
}
