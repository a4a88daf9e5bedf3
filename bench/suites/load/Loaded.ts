/** What loading has taken. */
export interface Loaded {
  /** Milliseconds that the main thread was kept, all together. */
  blocking: number;
  /** The same where the page has not drawn the scene yet, so that its vertices go to the GPU with ours. */
  withUpload?: number;
  /** Milliseconds of it that the page waited for the GPU. */
  waited?: number;
  /** Milliseconds until the first step, by the clock on the wall. */
  first: number;
  /** Bytes that are kept; null where the browser does not say. */
  heap: number | null;
}
