import { later } from './pace.js';

/**
 * Bytes of the page's heap, its typed arrays included, once all that can go is gone; null where the browser does not say
 * (Chromium does, to the byte, with `--enable-precise-memory-info --js-flags=--expose-gc`).
 */
export async function heapBytes(): Promise<number | null> {
  const { gc } = globalThis as {
    gc?: (options: { type: 'major'; execution: 'async' }) => Promise<void>;
  };
  if (gc === undefined || !('memory' in performance)) return null;
  // From a task of its own: what the stack still points at would be kept.
  for (let i = 0; i < 3; i++) {
    await later(10);
    await gc({ type: 'major', execution: 'async' });
  }
  // Asked for only now: it holds the figures of the moment.
  return (performance.memory as { usedJSHeapSize: number }).usedJSHeapSize;
}
