import { later } from './pace.js';

/**
 * Bytes of the page's heap, its typed arrays included, once all that can go is gone; null where the browser does not say
 * (Chromium does, to the byte, with `--enable-precise-memory-info --js-flags=--expose-gc`).
 */
export async function heapBytes(): Promise<number | null> {
  const { gc } = globalThis as { gc?: () => void };
  const { memory } = performance as { memory?: { usedJSHeapSize: number } };
  if (gc === undefined || memory === undefined) return null;
  for (let i = 0; i < 3; i++) {
    gc();
    await later();
  }
  return memory.usedJSHeapSize;
}
