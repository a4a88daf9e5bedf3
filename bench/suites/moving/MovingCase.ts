import type { Scene, Vector3 } from 'three';

/** Somebody who has to keep up with what moves. */
export interface MovingRival {
  name: string;
  note?: string;
  /** After everything has moved: brings what it built up to date, and pushes a capsule out. */
  frame(): void | Promise<void>;
  dispose(): void;
}

/** Scenery of which everything moves in every frame. */
export interface MovingCase {
  name: string;
  scene: Scene;
  /** Where the character stands. */
  foot: Vector3;
  /** Moves everything to where it is in a frame; world matrices are the page's. */
  move(frame: number): void;
  /** Who takes part, made anew. */
  rivals(): MovingRival[];
  /** Who does not, and why. */
  cannot: Record<string, string>;
}
