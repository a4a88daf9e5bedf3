import type { BufferGeometry, Mesh, Vector3 } from 'three';
import { NearTriangles } from './NearTriangles.js';
import { TriangleIndex } from './TriangleIndex.js';
import { isPlain, trianglesOf, verticesOf } from './verticesOf.js';

/** Meshes with fewer triangles are drawn whole. */
const HUGE = 512;
/** Time for finding runs, a frame, milliseconds. */
const SLICE = 1.5;
/** Frames for which an edited geometry must have kept still before its runs are found anew. */
const REST = 30;
/** Milliseconds for which no other collider finds runs after one did: a crowd's slices are one slice. */
const OTHERS = 8;
/** Draws for which what a mesh needs on the GPU is kept though it is out of reach. */
const KEPT = 8;

/** What is known of each geometry's triangles, for all colliders; null of those that cannot be read. */
const known = new WeakMap<BufferGeometry, TriangleIndex | null>();

/** Who found runs last, and when. */
let worker: WeakRef<HugeMeshes> | null = null;
let worked = 0;

/** Draws of huge meshes what is near alone, as soon as it is known what that is. Until then they are drawn whole. */
export class HugeMeshes {
  readonly #near = new Map<Mesh, { near: NearTriangles; drawn: number }>();
  /** Whose triangles are being looked for, and frames until that is gone on with. */
  readonly #pending: TriangleIndex[] = [];
  readonly #rest = new WeakMap<TriangleIndex, number>();
  #draw = 0;

  /** Frees what is on the GPU, and lets go of the user's objects. */
  clear(): void {
    for (const { near } of this.#near.values()) near.dispose();
    this.#near.clear();
    this.#pending.length = 0;
  }

  /**
   * What draws the triangles near by of a mesh, or null where it is to be drawn whole.
   *
   * @param center world space
   * @param reach metres
   */
  nearOf(mesh: Mesh, center: Vector3, reach: number): NearTriangles | null {
    const { geometry } = mesh;
    if (trianglesOf(geometry) < HUGE || !isPlain(mesh)) return null;
    const index = this.#indexOf(geometry);
    if (index === null || !index.done) return null;
    let entry = this.#near.get(mesh);
    if (entry !== undefined && !entry.near.serves(geometry, index)) {
      entry.near.dispose();
      entry = undefined;
    }
    if (entry === undefined) {
      this.#near.set(mesh, (entry = { near: new NearTriangles(mesh, index), drawn: 0 }));
    }
    entry.drawn = this.#draw;
    return entry.near.update(center, reach) ? entry.near : null;
  }

  /** After a selection: frees what has not been needed for some draws. */
  sweep(): void {
    const draw = this.#draw++;
    if (this.#near.size === 0) return;
    for (const [mesh, { near, drawn }] of this.#near) {
      if (draw - drawn <= KEPT) continue;
      near.dispose();
      this.#near.delete(mesh);
    }
  }

  /** Goes on looking for triangles: once a frame. @returns whether there are more to look for */
  work(): boolean {
    const index = this.#pending[0];
    if (index === undefined) return false;
    const rest = this.#rest.get(index) ?? 0;
    if (rest > 0) {
      this.#rest.set(index, rest - 1);
      // Others need not wait for it.
      this.#pending.push(this.#pending.shift()!);
      return true;
    }
    const now = performance.now();
    if (worker?.deref() !== this) {
      if (now < worked + OTHERS) return true;
      worker = new WeakRef(this);
    }
    if (!index.done) index.work(now + SLICE);
    worked = performance.now();
    if (index.done) this.#pending.shift();
    return this.#pending.length > 0;
  }

  #indexOf(geometry: BufferGeometry): TriangleIndex | null {
    let index = known.get(geometry);
    const edited = index && !index.holds(geometry);
    if (edited) {
      const at = this.#pending.indexOf(index!);
      if (at >= 0) this.#pending.splice(at, 1);
    }
    if (index === undefined || edited) {
      const vertices = verticesOf(geometry);
      index = vertices === null ? null : new TriangleIndex(geometry, vertices);
      known.set(geometry, index);
      if (index !== null && edited) this.#rest.set(index, REST);
    }
    if (index !== null && !index.done && !this.#pending.includes(index)) this.#pending.push(index);
    return index;
  }
}
