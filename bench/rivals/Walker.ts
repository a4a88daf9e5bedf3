import type { Vector3 } from 'three';

/** One who walks: the same body and inputs, another way to collide. */
export interface Walker {
  /** Lowest point of its capsule, world, metres: where its collision says that it is. */
  readonly foot: Vector3;
  /** Whether it would take a jump. */
  readonly grounded: boolean;
  /** Whether it could move now: all that it must know of its place is there. */
  readonly ready: boolean;
  /** Milliseconds its making kept the page, what must be done for each level: trees to build, programs to compile. */
  readonly preparation: number;
  /** Milliseconds spent so far waiting for the GPU. */
  readonly waiting: number;
  /** Puts it somewhere, at rest. */
  place(foot: Vector3): void;
  /** Lives through a frame of `dt` seconds, wanting to walk at `velocity` (m/s, horizontal). */
  frame(velocity: Vector3, jump: boolean, dt: number): void;
  /** What it counted itself so far; missing where it does not count. */
  counts(): WalkerCounts;
  dispose(): void;
}

export interface WalkerCounts {
  /** Cubemaps drawn. */
  draws?: number;
  /** Read-backs that were waited for although they were asynchronous. */
  forced?: number;
  /** Fixed steps, and those of them that stood or were shortened for want of a cubemap. */
  steps?: number;
  held?: number;
  slowed?: number;
}
