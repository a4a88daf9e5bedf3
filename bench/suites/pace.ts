/** Taken before anyone clocks the page's own: what paces a suite is no work of a contestant. */
const plainTimeout = globalThis.setTimeout.bind(globalThis);
const plainFrame = globalThis.requestAnimationFrame.bind(globalThis);

/** Seconds of a frame. */
export const FRAME = 1 / 60;

/** Another task, so that what was left for later comes first. */
export const later = (milliseconds = 0) =>
  new Promise<void>((resolve) => plainTimeout(resolve, milliseconds));

/** The page's next frame. */
export const nextFrame = () => new Promise<void>((resolve) => plainFrame(() => resolve()));

/** The order of a repeat: who began the last one comes last. */
export function rotated<T>(list: readonly T[], repeat: number): T[] {
  const from = list.length > 0 ? repeat % list.length : 0;
  return [...list.slice(from), ...list.slice(0, from)];
}

export const mean = (list: readonly number[]) =>
  list.reduce((sum, value) => sum + value, 0) / list.length;

/** The value that the part `q` of a list lies below. */
export function quantile(list: readonly number[], q: number): number {
  return [...list].sort((a, b) => a - b)[Math.floor(q * (list.length - 1))] ?? NaN;
}
