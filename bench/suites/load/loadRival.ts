import { type BufferGeometry, Vector3 } from 'three';
import { rapierMemory } from '../../rivals/rapierMemory.js';
import type { Walker } from '../../rivals/Walker.js';
import { heapBytes } from '../heap.js';
import { FRAME } from '../pace.js';
import type { Rival } from '../rivals.js';
import type { Loaded } from './Loaded.js';

const START = new Vector3(0.571, 1, 0);
const STILL = new Vector3();

/** Bytes of WebAssembly before any level was in it. */
let emptyMemory = -1;

/** Builds what the rival needs, and steps once. Its code is loaded already, as ours is. */
export async function loadRival(rival: Rival, geometry: BufferGeometry): Promise<Loaded> {
  const walker = await build(rival, geometry);
  const start = performance.now();
  walker.place(START);
  walker.frame(STILL, false, FRAME);
  const blocking = walker.preparation + performance.now() - start;
  walker.dispose();
  return { blocking, longest: blocking, first: blocking };
}

/** Bytes that it keeps; null where the browser does not say. Sizes must come in ascending order. */
export async function weighRival(rival: Rival, geometry: BufferGeometry): Promise<number | null> {
  const memory = await rapierMemory();
  const before = await heapBytes();
  const walker = await build(rival, geometry);
  walker.place(START);
  walker.frame(STILL, false, FRAME);
  const after = await heapBytes();
  walker.dispose();
  if (before === null || after === null) return null;
  const heap = after - before;
  // The walker gives it a copy, for its triangles will be sorted; a page could do without.
  if (rival.name === 'three-mesh-bvh') return heap - bytesOf(geometry);
  if (rival.name !== 'Rapier') return heap;
  // WebAssembly's memory grows and never shrinks: what it has come to is the need of the largest so far, this one.
  return memory && heap + memory.buffer.byteLength - emptyMemory;
}

async function build(rival: Rival, geometry: BufferGeometry): Promise<Walker> {
  const memory = await rapierMemory();
  if (memory && emptyMemory < 0) emptyMemory = memory.buffer.byteLength;
  return rival.create(geometry);
}

function bytesOf({ attributes, index }: BufferGeometry): number {
  return (index?.array.byteLength ?? 0) + attributes.position!.array.byteLength;
}
