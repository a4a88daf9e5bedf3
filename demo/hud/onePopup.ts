const closers = new Set<() => void>();

/**
 * Makes a panel one of those over the picture of which no two are open.
 *
 * @param close closes it; called when another one opens
 * @returns to be called when this one opens
 */
export function onePopup(close: () => void): () => void {
  closers.add(close);
  return () => {
    for (const other of closers) if (other !== close) other();
  };
}
