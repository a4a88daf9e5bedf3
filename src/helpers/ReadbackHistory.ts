import type { CubeCollider } from '../collider/CubeCollider.js';
import type { CharacterStats } from '../character/SlideMotion.js';

/** What a history reads of a collider. */
export type TimedCollider = Pick<CubeCollider, 'field' | 'maxima' | 'stats'>;

/** Looks at a character that are kept: ten seconds at 60 Hz. */
const KEPT = 600;

/** Of a kept look: that many bits. */
export const HELD = 1;
export const SLOWED = 2;
export const DRAWN = 4;
export const FORCED = 8;

/**
 * What became of a collider's cubemaps, found by looking at its public counters once a frame. Written round and round in
 * arrays of fixed size; allocates nothing.
 */
export class ReadbackHistory {
  /** Looks so far; number `i` is kept at `i % size` until `size` more have come. */
  looks = 0;
  /** Reads so far, kept alike. */
  reads = 0;
  readonly size = KEPT;
  /** Of each look: when, `performance.now()` milliseconds. */
  readonly time = new Float64Array(KEPT);
  /** Of each look: age of the newest field, milliseconds; NaN without one. */
  readonly age = new Float64Array(KEPT);
  /** Of each look, what had happened since the one before: `HELD`, `SLOWED`, `DRAWN`, `FORCED`. */
  readonly flags = new Uint8Array(KEPT);
  /** Of each read: when its cubemap was drawn and when it had come, and 1 if it was waited for. */
  readonly from = new Float64Array(KEPT);
  readonly to = new Float64Array(KEPT);
  readonly forced = new Uint8Array(KEPT);

  readonly #last = { draws: 0, reads: 0, forced: 0, held: 0, slowed: 0 };
  #collider: TimedCollider | null = null;
  #drawn = NaN;

  /**
   * Looks once; call it every frame.
   *
   * @param now `performance.now()`
   * @param character the counters of who walks, if anybody
   */
  look(now: number, collider: TimedCollider, character: CharacterStats | null): void {
    const { stats, field } = collider;
    const last = this.#last;
    if (collider !== this.#collider) {
      this.#collider = collider;
      // Of one that is new here, what it did before is not now.
      last.draws = stats.draws;
      last.reads = stats.reads;
      last.forced = stats.forced;
      this.#drawn = NaN;
      last.held = character?.held ?? 0;
      last.slowed = character?.slowed ?? 0;
    }
    const wasForced = stats.forced > last.forced;
    if (stats.reads > last.reads) {
      // A field knows when it was drawn; of the maxima only their delay is known.
      this.#drawn = field === null ? now - stats.latency : field.time;
      const place = this.reads++ % KEPT;
      this.from[place] = this.#drawn;
      this.to[place] = this.#drawn + stats.latency;
      this.forced[place] = wasForced ? 1 : 0;
    }
    let flags = wasForced ? FORCED : 0;
    if (stats.draws > last.draws) flags |= DRAWN;
    if (character !== null) {
      if (character.held > last.held) flags |= HELD;
      if (character.slowed > last.slowed) flags |= SLOWED;
      last.held = character.held;
      last.slowed = character.slowed;
    }
    const place = this.looks++ % KEPT;
    this.time[place] = now;
    this.age[place] = field === null && collider.maxima === null ? NaN : now - this.#drawn;
    this.flags[place] = flags;
    last.draws = stats.draws;
    last.reads = stats.reads;
    last.forced = stats.forced;
  }
}
