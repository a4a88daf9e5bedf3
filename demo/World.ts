import { type PerspectiveCamera, type Scene, Vector3 } from 'three';
import { createHall, type Hall } from './hall/createHall.js';
import { disposeOf } from './level/dispose.js';
import type { Level } from './level/Level.js';
import { addLighting, type Lighting } from './lighting.js';
import { createMovers, type Movers } from './movers.js';
import type { Rendering } from './rendering.js';

/** What one walks in: a level and its light, and what moves in the demo's own. */
export class World {
  /** Null until the first one is loaded. */
  level: Level | null = null;
  /** Of the demo's own level alone. */
  movers: Movers | null = null;
  hall: Hall | null = null;
  /** Where one begins, and comes back to, metres. */
  readonly spawn = new Vector3();
  readonly #scene: Scene;
  readonly #rendering: Rendering;
  #lighting: Lighting | null = null;

  constructor(scene: Scene, rendering: Rendering) {
    this.#scene = scene;
    this.#rendering = rendering;
  }

  /** Height below which one has fallen out of it, metres. */
  get abyss(): number {
    return this.level?.abyss ?? -Infinity;
  }

  /** Puts a level in the place of the last one, which it frees. */
  take(level: Level, place: 'start' | 'hall'): void {
    this.level?.dispose();
    for (const gone of [this.movers, this.hall]) if (gone !== null) disposeOf(gone.root);
    this.movers = this.hall = null;
    this.level = level;
    this.#lighting ??= addLighting(this.#scene, this.#rendering.renderer);
    if (level.own) {
      this.movers = createMovers(level.root);
      this.hall = createHall(level.root);
      this.#scene.add(this.movers.root, this.hall.root);
      if (place === 'hall') level.start = { position: this.hall.entry, yaw: Math.PI };
    }
    this.#rendering.translate(this.#scene);
    this.#scene.add(level.root);
  }

  /** Goes by the level's start and size, which a user may have changed. @returns where one begins to look */
  begin(level: Level, camera: PerspectiveCamera): number {
    this.spawn.copy(level.start.position);
    this.#lighting?.fit(camera, level.own ? 0 : level.width);
    return level.start.yaw;
  }

  /** Moves what moves in it. @param squeezed whether somebody is between two things @param walker where one is */
  update(delta: number, squeezed: boolean, walker: Vector3): void {
    this.level?.update(delta);
    this.movers?.update(delta, squeezed);
    this.hall?.update(delta, walker);
  }

  /** Lets the shadows be where one is. */
  light(walker: Vector3): void {
    this.#lighting?.update(walker);
  }
}
