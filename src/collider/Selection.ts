import type { Material, Mesh, Object3D, Vector3 } from 'three';
import { createObjectProxy, type ObjectProxy } from './objectProxy.js';
import { SceneWalk, type SelectionRules, type WalkListener } from './SceneWalk.js';

type Dress = (source: Material | Material[]) => Material | Material[];

/**
 * Finds what the cubemap may see and dresses it as proxies, each with a layer for every face it touches, numbered from 1
 * in the order in which they are drawn. The first stage of the data's way.
 */
export class Selection {
  /** What was selected last: put these into a private scene. */
  readonly proxies: ObjectProxy[] = [];
  readonly #proxyOf = new WeakMap<Mesh, ObjectProxy>();
  #count = 0;
  #dress!: Dress;

  readonly #walk = new SceneWalk({
    solid: (mesh, faces) => {
      let proxy = this.#proxyOf.get(mesh);
      if (proxy === undefined) this.#proxyOf.set(mesh, (proxy = createObjectProxy(mesh)));
      proxy.layers.mask = faces;
      proxy.material = this.#dress(mesh.material);
      // Written over, not emptied and pushed: an emptied array gives its storage back.
      this.proxies[this.#count++] = proxy;
      proxy.drawNumber = this.#count;
    },
    sensor: () => {},
  } satisfies WalkListener);

  /** Lets go of the user's objects. */
  clear(): void {
    this.proxies.length = 0;
  }

  /**
   * Refreshes the scene's world matrices as its next render would, then fills `proxies`.
   *
   * @param center world space
   * @param far metres
   * @param dress gives the material to draw an object's own with
   */
  select(scene: Object3D, center: Vector3, far: number, rules: SelectionRules, dress: Dress): void {
    this.#dress = dress;
    this.#count = 0;
    this.#walk.walk(scene, center, far, rules);
    this.proxies.length = this.#count;
  }
}
