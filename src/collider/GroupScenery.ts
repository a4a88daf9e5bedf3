import type { Vector3 } from 'three';
import type { Scenery } from './CubemapDevice.js';
import type { ObjectProxy } from './objectProxy.js';
import { PrivateScene } from './PrivateScene.js';

/** Layers that a cubemap's faces take. */
const FACES = 6;

/** The sceneries of up to five cubemaps as one, for one render: each has six layers of its own. */
export class GroupScenery implements Scenery {
  readonly scene = new PrivateScene();
  readonly centers: Vector3[] = [];
  far = 0;
  readonly #parts: Scenery[] = [];
  readonly #proxies: ObjectProxy[] = [];

  /** How many it shows. */
  get size(): number {
    return this.#parts.length;
  }

  clear(): void {
    this.#parts.length = this.centers.length = 0;
    this.far = 0;
  }

  /** Lets go of the user's objects too. */
  release(): void {
    this.clear();
    this.#proxies.length = 0;
    this.scene.children = [];
  }

  add(part: Scenery): void {
    this.#parts.push(part);
    this.centers.push(part.centers[0]!);
    this.far = Math.max(this.far, part.far);
  }

  select(): readonly ObjectProxy[] {
    const proxies = this.#proxies;
    let count = 0;
    for (let i = 0; i < this.#parts.length; i++) {
      const part = this.#parts[i]!;
      // All of a render see as far: what is stored is a part of that.
      part.far = this.far;
      const selected = part.select();
      for (let j = 0; j < selected.length; j++) {
        const proxy = selected[j]!;
        proxy.layers.mask <<= FACES * i;
        proxies[count++] = proxy;
      }
    }
    proxies.length = count;
    this.scene.children = proxies;
    return proxies;
  }
}
