import { type Mesh, type Object3D, type SkinnedMesh, Sphere, Vector3 } from 'three';
import { SceneNode } from './SceneNode.js';
import { Stillness } from './Stillness.js';
import { followsGeometry, hasSphere, isCheap, worldSphere } from './worldSphere.js';

/**
 * Objects far away that are looked at in one call at least; of many, the eighth part. Each costs a microsecond where
 * caches are cold, as they are once a frame.
 */
const LEAST = 64;
const CALLS = 8;
/** Groups that are asked in one call whether something was added to them. */
const HOLDERS = 1024;
/** What is no farther than this beyond reach is watched in every call too, metres. */
const WATCH = 2;
/** How much farther the watched are collected, so that it need not be done whenever the centre moves, metres. */
const ROOM = 2;
/** Radius that stands for "everywhere", and for "nowhere". */
const EVERYWHERE = Infinity;
const NOWHERE = -1;

const sphere = new Sphere();

/**
 * Knows where the objects of a scene are without walking it. What is near is looked at in every call: there everything
 * is noticed at once. The rest is looked at in turns, all of it in 8 calls, 64 objects in each at least; what is added to
 * a scene, or to one of its first 1024 groups, is noticed at once too.
 *
 * It keeps no object that has left the scene longer than it takes to notice that.
 */
export class SceneIndex {
  /** What may be within reach, in the order in which it was found. Hidden and see-through ones are among it. */
  readonly near: SceneNode[] = [];
  /** Has a survey gone on looking at the rest, since the last draw? Then the draw need not. */
  surveyed = false;
  #scene: Object3D | null = null;
  #root: SceneNode | null = null;
  readonly #nodes: (SceneNode | null)[] = [];
  readonly #free: number[] = [];
  readonly #holders: SceneNode[] = [];
  readonly #nodeOf = new WeakMap<Object3D, SceneNode>();
  /** Found in this call: to be placed once all that came with them is known, the bones of skins too. */
  readonly #fresh: SceneNode[] = [];
  /** Bounding spheres, world space: x, y, z, radius. */
  #spheres = new Float64Array(4 * LEAST);
  readonly #stillness = new Stillness();
  #call = 0;
  #refreshes = true;
  #cursor = 0;
  #holderCursor = 0;
  #order = 0;
  /** Where and within what distance the watched were collected. */
  readonly #anchor = new Vector3();
  #watched = 0;
  #lost = false;
  #sorted = true;
  readonly #idle: (sensor: Object3D) => void;

  /** @param idle told, each time it is looked at, of a sensor without a geometry, which reports nothing */
  constructor(idle: (sensor: Object3D) => void = () => {}) {
    this.#idle = idle;
  }

  /** Number of the last call. */
  get call(): number {
    return this.#call;
  }

  /** How many objects it knows. */
  get size(): number {
    return this.#nodes.length - this.#free.length;
  }

  /** Lets go of the user's objects. */
  clear(): void {
    this.near.length = this.#nodes.length = this.#free.length = this.#holders.length = 0;
    this.#fresh.length = 0;
    if (this.#root !== null) this.#forget(this.#root);
    this.#scene = this.#root = null;
    this.#cursor = this.#holderCursor = 0;
  }

  /**
   * Fills `near` and brings its world matrices up to date, as the scene's next render would. Allocates nothing where
   * nothing came or went.
   *
   * @param center world space
   * @param reach metres
   * @param scan whether to go on looking at the rest: once a frame
   */
  update(scene: Object3D, center: Vector3, reach: number, scan: boolean): void {
    this.#call++;
    this.#refreshes = scene.matrixWorldAutoUpdate;
    if (scene !== this.#scene) this.#begin(scene);
    else {
      this.#lookForNew();
      if (scan) this.#scan();
    }
    this.#placeFresh();
    this.#collect(center, reach);
    // What is found beside them meanwhile is added at the end, and seen to here as well.
    for (let i = 0; i < this.near.length; i++) {
      const node = this.near[i]!;
      if (this.#verify(node)) this.#place(node);
      if (this.#fresh.length > 0) this.#placeFresh();
    }
    this.#tidy();
  }

  /** The bounding sphere of one of those `near`. */
  sphereOf(node: SceneNode, target: Sphere): void {
    const at = 4 * node.slot;
    target.center.fromArray(this.#spheres, at);
    target.radius = this.#spheres[at + 3]!;
  }

  #begin(scene: Object3D): void {
    this.clear();
    this.#scene = scene;
    this.#watched = NOWHERE;
    this.#root = this.#add(scene, null);
  }

  #placeFresh(): void {
    const fresh = this.#fresh;
    for (let i = 0; i < fresh.length; i++) {
      const node = fresh[i]!;
      if (node.slot >= 0 && this.#place(node)) this.#watch(node);
    }
    fresh.length = 0;
  }

  #lookForNew(): void {
    const count = this.#holders.length;
    for (let left = Math.min(count, HOLDERS); left > 0 && this.#holders.length > 0; left--) {
      if (this.#holderCursor >= this.#holders.length) this.#holderCursor = 0;
      const node = this.#holders[this.#holderCursor++]!;
      if (hasNews(node)) this.#reconcile(node);
    }
  }

  #scan(): void {
    const { length } = this.#nodes;
    for (
      let left = Math.min(length, Math.max(LEAST, Math.ceil(length / CALLS)));
      left > 0;
      left--
    ) {
      if (this.#cursor >= length) this.#cursor = 0;
      const node = this.#nodes[this.#cursor++]!;
      if (node === null || !this.#verify(node)) continue;
      this.#reconcile(node);
      if (!node.near) this.#placeFar(node);
    }
  }

  /** As `place`, where most have stood still. */
  #placeFar(node: SceneNode): void {
    const mesh = node.object as Mesh;
    const still = mesh.isMesh && this.#stillness.isStill(node, this.#call, this.#refreshes);
    if (still) return;
    if (this.#place(node)) this.#watch(node);
    else if (followsGeometry(mesh)) this.#stillness.note(node, mesh.geometry);
  }

  /** Chooses what is watched in every call, where the centre or the reach have left what was chosen before. */
  #collect(center: Vector3, reach: number): void {
    const needed = center.distanceTo(this.#anchor) + reach + WATCH;
    if (needed <= this.#watched && this.#watched <= reach + 2 * (WATCH + ROOM)) return;
    this.#anchor.copy(center);
    this.#watched = reach + WATCH + ROOM;
    for (let i = 0; i < this.near.length; i++) {
      const node = this.near[i]!;
      node.near = false;
      // Its sphere was found in every call, wherever it was noted.
      node.geometry = null;
    }
    this.near.length = 0;
    for (let slot = 0; slot < this.#nodes.length; slot++) {
      if (this.#isNear(slot)) this.#watch(this.#nodes[slot]!);
    }
  }

  #isNear(slot: number): boolean {
    const spheres = this.#spheres;
    const radius = spheres[4 * slot + 3]!;
    if (radius === EVERYWHERE) return true;
    if (!(radius >= 0)) return false;
    const x = spheres[4 * slot]! - this.#anchor.x;
    const y = spheres[4 * slot + 1]! - this.#anchor.y;
    const z = spheres[4 * slot + 2]! - this.#anchor.z;
    const reach = radius + this.#watched;
    return x * x + y * y + z * z <= reach * reach;
  }

  #watch(node: SceneNode): void {
    if (node.near) return;
    node.near = true;
    const { near } = this;
    if (near.length > 0 && near[near.length - 1]!.order > node.order) this.#sorted = false;
    near.push(node);
  }

  /** Is it still where it was found, and all above it? Tells of what was added to any of them. */
  #verify(node: SceneNode): boolean {
    if (node.verified === this.#call || node.slot < 0) return node.slot >= 0;
    node.verified = this.#call;
    const { parent, object } = node;
    if (parent !== null) {
      if (!this.#verify(parent)) return node.slot >= 0;
      if (object.parent !== node.foundUnder) {
        this.#reconcile(parent);
        node.foundUnder = object.parent;
      }
    }
    if (node.slot >= 0 && hasNews(node)) this.#reconcile(node);
    return node.slot >= 0;
  }

  /** Finds the bounding sphere anew, and refreshes what it takes. @returns whether it is near */
  #place(node: SceneNode): boolean {
    const mesh = node.object as Mesh;
    const sensor = mesh.userData.sensor === true;
    const at = 4 * node.slot;
    const placed = !!mesh.geometry?.attributes?.position;
    if (!(mesh.isMesh || sensor) || (sensor && !placed)) {
      if (sensor) this.#idle(mesh);
      this.#spheres[at + 3] = NOWHERE;
      return false;
    }
    if (this.#refreshes) {
      node.refresh(this.#call);
      const skin = (mesh as Mesh as SkinnedMesh).isSkinnedMesh;
      if (skin && (node.near || !hasSphere(mesh))) this.#refreshBones(mesh);
    }
    // What has no positions is to be told of, wherever it is.
    if (!placed || (!mesh.frustumCulled && !sensor)) {
      this.#spheres[at + 3] = EVERYWHERE;
    } else if (!hasSphere(mesh) && !isCheap(mesh) && !showing(node)) {
      // Not worth its vertices while it is hidden; but once it shows, it shall be noticed at once.
      this.#spheres[at + 3] = EVERYWHERE;
    } else {
      const known = worldSphere(mesh, sphere);
      sphere.center.toArray(this.#spheres, at);
      this.#spheres[at + 3] = !known ? EVERYWHERE : sphere.radius >= 0 ? sphere.radius : NOWHERE;
    }
    return this.#isNear(node.slot);
  }

  #refreshBones(mesh: Mesh): void {
    const { bones } = (mesh as SkinnedMesh).skeleton ?? {};
    if (bones === undefined) return;
    for (let i = 0; i < bones.length; i++) {
      const bone = bones[i];
      if (bone !== undefined) this.#nodeOf.get(bone)?.refresh(this.#call);
    }
  }

  /** Takes over the object's children as they are now. */
  #reconcile(node: SceneNode): void {
    if (node.slot < 0) return;
    const { children } = node.object;
    const known = node.children;
    if (children.length === 0 && known.length === 0) return;
    let same = 0;
    const shorter = Math.min(children.length, known.length);
    while (same < shorter && known[same]!.object === children[same]) same++;
    if (same === children.length && same === known.length) return;
    const old = known.splice(same);
    let next = 0;
    for (let i = same; i < children.length; i++) {
      const object = children[i]!;
      // Most often some have gone, and others were added at the end.
      while (next < old.length && old[next]!.object !== object) {
        const gone = old[next]!.object.parent !== node.object;
        if (!gone && old[next + 1]?.object !== object) break;
        next++;
      }
      const child =
        next < old.length && old[next]!.object === object ? old[next++]! : this.#take(object, node);
      child.kept = this.#call;
      known.push(child);
    }
    for (const child of old) {
      if (child.parent === node && child.kept !== this.#call) this.#drop(child);
    }
    this.#noteHolder(node);
  }

  /** An object that was found below `parent`: a new one, or one that was elsewhere. */
  #take(object: Object3D, parent: SceneNode): SceneNode {
    const known = this.#nodeOf.get(object);
    if (known === undefined) return this.#add(object, parent);
    if (known.parent !== parent && known.parent !== null) {
      const siblings = known.parent.children;
      const index = siblings.indexOf(known);
      if (index >= 0) siblings.splice(index, 1);
    }
    known.parent = parent;
    known.foundUnder = object.parent;
    return known;
  }

  #add(object: Object3D, parent: SceneNode | null): SceneNode {
    const node = new SceneNode(object, parent);
    node.order = this.#order++;
    node.slot = this.#free.pop() ?? this.#nodes.length;
    if (4 * node.slot >= this.#spheres.length) {
      const grown = new Float64Array(2 * this.#spheres.length);
      grown.set(this.#spheres);
      this.#spheres = grown;
    }
    this.#stillness.reserve(node.slot + 1);
    this.#nodes[node.slot] = node;
    this.#nodeOf.set(object, node);
    node.verified = this.#call;
    this.#fresh.push(node);
    const { children } = object;
    for (let i = 0; i < children.length; i++) {
      const child = this.#add(children[i]!, node);
      child.kept = this.#call;
      node.children.push(child);
    }
    this.#noteHolder(node);
    return node;
  }

  /** What has or may get children: not a mesh, a light, a bone without any. */
  #noteHolder(node: SceneNode): void {
    const { object } = node;
    const holds =
      node.parent === null ||
      object.type === 'Group' ||
      object.type === 'Object3D' ||
      (node.children.length > 0 && !(object as { isBone?: boolean }).isBone);
    if (!holds || node.holder >= 0) return;
    node.holder = this.#holders.push(node) - 1;
  }

  #drop(node: SceneNode): void {
    for (const child of node.children) this.#drop(child);
    this.#nodeOf.delete(node.object);
    this.#nodes[node.slot] = null;
    this.#free.push(node.slot);
    this.#spheres[4 * node.slot + 3] = NOWHERE;
    node.slot = -1;
    if (node.near) this.#lost = true;
    if (node.holder >= 0) {
      const last = this.#holders.pop()!;
      if (last !== node) this.#holders[(last.holder = node.holder)] = last;
      node.holder = -1;
    }
  }

  /** As `drop`, where all is forgotten. */
  #forget(node: SceneNode): void {
    for (const child of node.children) this.#forget(child);
    this.#nodeOf.delete(node.object);
    node.slot = -1;
  }

  /** Takes the lost out of `near`, and puts it in order. */
  #tidy(): void {
    const { near } = this;
    if (this.#lost) {
      let count = 0;
      for (let i = 0; i < near.length; i++) if (near[i]!.slot >= 0) near[count++] = near[i]!;
      near.length = count;
      this.#lost = false;
    }
    if (this.#sorted) return;
    near.sort(byOrder);
    this.#sorted = true;
  }
}

/** Have its children other numbers, or another last one? three adds at the end. */
function hasNews({ object, children }: SceneNode): boolean {
  const { length } = children;
  if (length !== object.children.length) return true;
  return length > 0 && children[length - 1]!.object !== object.children[length - 1];
}

function byOrder(a: SceneNode, b: SceneNode): number {
  return a.order - b.order;
}

/** Visible itself and all above it, and not opted out: as far as can be told without a collider's own rules. */
function showing(node: SceneNode): boolean {
  for (let each: SceneNode | null = node; each !== null; each = each.parent) {
    const { object } = each;
    if (!object.visible || object.userData.collider === false) return false;
  }
  return true;
}
