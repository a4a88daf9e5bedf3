/**
 * How long the machine takes for work that is always the same: what else it does in between shows in it as in ours.
 *
 * @param milliseconds that it takes where nothing comes between
 */
export function busyLoop(milliseconds: number): () => number {
  let sum = 0;
  const spin = (count: number) => {
    const start = performance.now();
    for (let i = 0; i < count; i++) sum += Math.sqrt(sum + i);
    return performance.now() - start;
  };
  let count = 1000;
  while (Math.min(spin(count), spin(count), spin(count), spin(count)) < milliseconds) count *= 1.1;
  return () => spin(count);
}
