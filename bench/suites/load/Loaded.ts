/** What loading has taken. */
export interface Loaded {
  /** Milliseconds that the main thread was kept, all together. */
  blocking: number;
  /** The most of it without a break, in which the page could have drawn. */
  longest: number;
  /** Milliseconds of it that the page waited for the GPU. */
  waited?: number;
  /** Milliseconds until the first step, by the clock on the wall. */
  first: number;
}
