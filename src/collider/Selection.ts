import type { BatchedMesh, Material, Mesh, Object3D, Scene, Vector3 } from 'three';
import type { BatchList } from './BatchList.js';
import { HugeMeshes } from './HugeMeshes.js';
import { solidityOf, type Solidity } from './isSolid.js';
import { createObjectProxy, type ObjectProxy } from './objectProxy.js';
import { SceneIndex } from './SceneIndex.js';
import { SceneWalk, type SelectionRules, type WalkListener } from './SceneWalk.js';

type Dress = (source: Material | Material[], solidity: Solidity) => Material | Material[];

/**
 * Finds what the cubemap may see and dresses it as proxies, each with a layer for every face it touches, numbered from 1
 * in the order in which they are drawn. The first stage of the data's way.
 */
export class Selection {
  /** What was selected last: put these into a private scene. */
  readonly proxies: ObjectProxy[] = [];
  readonly #proxyOf = new WeakMap<Mesh, ObjectProxy>();
  readonly #huge = new HugeMeshes();
  #count = 0;
  #dress!: Dress;
  #center!: Vector3;
  #far = 0;
  /** Of the batches among them. */
  readonly #batches = new Set<BatchList>();
  #selections = 0;
  #scene!: Object3D;
  #rules!: SelectionRules;

  readonly #index: SceneIndex;
  readonly #walk: SceneWalk;
  readonly #listener: WalkListener = {
    solid: (mesh, faces) => {
      const near = this.#huge.nearOf(mesh, this.#center, this.#far);
      const proxy = near?.proxy ?? this.#whole(mesh);
      // Perhaps none: it is listed all the same, as it stands where it does for what surveys between draws.
      proxy.layers.mask =
        near === null ? faces : faces & near.facesTouched(this.#center, this.#far);
      proxy.scene = this.#scene as Scene;
      proxy.solidity = solidityOf(mesh, this.#rules.transparent);
      proxy.material = this.#dress(mesh.material, proxy.solidity);
      // Written over, not emptied and pushed: an emptied array gives its storage back.
      this.proxies[this.#count++] = proxy;
      proxy.drawNumber = this.#count;
      if (proxy.batch === null) return;
      proxy.batch.gather(mesh as BatchedMesh, proxy, this.#center, this.#far);
      proxy.batch.selection = this.#selections;
      this.#batches.add(proxy.batch);
    },
    sensor: () => {},
  };

  /** @param index of what is where in the scene; shared with whoever surveys it */
  constructor(index = new SceneIndex()) {
    this.#index = index;
    this.#walk = new SceneWalk(index, this.#listener);
  }

  /** Lets go of the user's objects, and of what their batches have on the GPU. */
  clear(): void {
    this.forget();
    this.#huge.clear();
  }

  /** The same, but for huge meshes whose triangles it is still looking for. */
  forget(): void {
    this.proxies.length = 0;
    this.#scene = undefined as never;
    for (const batch of this.#batches) batch.dispose();
    this.#batches.clear();
  }

  /**
   * Goes on finding out where the triangles of huge meshes are; for a frame without a draw.
   *
   * @returns whether there are more to find
   */
  prepare(): boolean {
    return this.#huge.work();
  }

  /**
   * Refreshes the world matrices of what is near as the scene's next render would, then fills `proxies`.
   *
   * @param center world space
   * @param far metres
   * @param dress gives the material to draw an object's own with
   */
  select(scene: Object3D, center: Vector3, far: number, rules: SelectionRules, dress: Dress): void {
    this.#dress = dress;
    this.#center = center;
    this.#far = far;
    this.#scene = scene;
    this.#rules = rules;
    this.#count = 0;
    this.#selections++;
    if (!this.#index.surveyed) this.prepare();
    this.#walk.walk(scene, center, far, rules, !this.#index.surveyed);
    this.#index.surveyed = false;
    this.proxies.length = this.#count;
    this.#huge.sweep();
    if (this.#batches.size > 0) this.#dropBatches();
  }

  #whole(mesh: Mesh): ObjectProxy {
    let proxy = this.#proxyOf.get(mesh);
    if (proxy === undefined) this.#proxyOf.set(mesh, (proxy = createObjectProxy(mesh)));
    return proxy;
  }

  /** Batches that went need no list. */
  #dropBatches(): void {
    for (const batch of this.#batches) {
      if (batch.selection === this.#selections) continue;
      batch.dispose();
      this.#batches.delete(batch);
    }
  }
}
