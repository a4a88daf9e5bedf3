import type { SlideLimits, SlideResponse } from '../response/SlideResponse.js';

/** A contact whose normal leans this much more than its surface's is an edge, as a difference of their Y. */
const ON_FACE = 0.02;
/** Lower than this is no step to tell of, metres. */
const LEAST_STEP = 0.02;

/** Finds out how high a step was: it is climbed over several steps of time, rolling over its edge. */
export class ClimbWatch {
  /** Height of the foot before the step it climbs; NaN if it climbs none. */
  #from = NaN;

  reset(): void {
    this.#from = NaN;
  }

  /**
   * To be called after every walk.
   *
   * @param before height of the foot before it @param after and after it, metres
   * @returns height of the step that was completed by it, metres; 0 if none was
   */
  note(before: number, after: number, response: SlideResponse, limits: SlideLimits): number {
    if (response.climbed > 0) {
      if (Number.isNaN(this.#from)) this.#from = before;
      return 0;
    }
    if (Number.isNaN(this.#from)) return 0;
    const { contacts } = response;
    for (let i = 0; i < contacts.count; i++) {
      if (!response.carries(contacts, i, limits)) continue;
      // Still on the edge.
      if (contacts.normal[3 * i + 1]! < contacts.surfaceUp[i]! - ON_FACE) return 0;
    }
    const height = after - this.#from;
    this.#from = NaN;
    return height > LEAST_STEP ? height : 0;
  }
}
