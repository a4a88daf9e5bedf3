/** Links of a chain of promises that are followed to its end. */
const LINKS = 32;

type Callback = (...args: unknown[]) => unknown;
type Schedule = (callback: Callback, ...rest: unknown[]) => unknown;

/**
 * Clocks what code leaves for later: callbacks of timers and, of WebGPU, of buffers that were mapped. They keep the main
 * thread as what the code does at once does. Waiting between them is nobody's work and is not counted.
 *
 * @param done hears after each how long it took, milliseconds
 * @param options.frames callbacks of frames too; not with `WebGPURenderer`, whose own loop would be among them
 * @param options.chains also what hangs on the promises that a callback resolves: costs microseconds each
 * @returns ends it
 */
export function watchTasks(
  done: (milliseconds: number) => void,
  { frames = false, chains = false } = {},
): () => void {
  const timed = (callback: Callback): Callback =>
    function (this: unknown, ...args) {
      const start = performance.now();
      const end = () => done(performance.now() - start);
      try {
        return callback.apply(this, args);
      } finally {
        if (chains) void endOfChains().then(end);
        else end();
      }
    };
  const ends = [watchSchedule('setTimeout', timed), watchMapping(timed)];
  if (frames) ends.push(watchSchedule('requestAnimationFrame', timed));
  return () => {
    for (const end of ends) end();
  };
}

/** Once the promises that are being resolved in this task have been heard of by all who wait for them. */
export async function endOfChains(): Promise<void> {
  for (let i = 0; i < LINKS; i++) await undefined;
}

function watchSchedule(
  name: 'setTimeout' | 'requestAnimationFrame',
  timed: (callback: Callback) => Callback,
): () => void {
  const page = globalThis as unknown as Record<typeof name, Schedule>;
  const schedule = page[name];
  page[name] = (callback, ...rest) => schedule.call(globalThis, timed(callback), ...rest);
  return () => {
    page[name] = schedule;
  };
}

function watchMapping(timed: (callback: Callback) => Callback): () => void {
  if (typeof GPUBuffer === 'undefined') return () => {};
  const { prototype } = GPUBuffer;
  const { mapAsync } = prototype;
  prototype.mapAsync = function (this: GPUBuffer, ...args: Parameters<typeof mapAsync>) {
    const mapped = mapAsync.apply(this, args);
    const then = mapped.then.bind(mapped);
    mapped.then = ((arrived: Callback | undefined, failed?: Callback) =>
      then(arrived && timed(arrived), failed)) as typeof mapped.then;
    return mapped;
  };
  return () => {
    prototype.mapAsync = mapAsync;
  };
}
