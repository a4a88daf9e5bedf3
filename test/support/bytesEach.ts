/** Bytes of heap that each call leaves behind, once the compiler has settled. */
export function bytesEach(calls: number, run: () => void): number {
  for (let i = 0; i < calls; i++) run();
  let least = Infinity;
  // The least of several: other work of the process only adds. A collection in between would show as less than nothing.
  for (let trial = 0; trial < 5; trial++) {
    const before = process.memoryUsage().heapUsed;
    for (let i = 0; i < calls; i++) run();
    const grown = process.memoryUsage().heapUsed - before;
    if (grown >= 0) least = Math.min(least, grown / calls);
  }
  return least;
}
