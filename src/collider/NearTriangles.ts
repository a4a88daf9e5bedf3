import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Matrix4,
  type Mesh,
  Vector3,
} from 'three';
import { facesOfBox } from './boxFaces.js';
import { createObjectProxy, type ObjectProxy } from './objectProxy.js';
import { empty, type TriangleIndex } from './TriangleIndex.js';

/** Gathered that much farther than the reach, as a part of it, so as to serve several draws. */
const MARGIN = 0.25;
/** Gathered this many times wider than needed, it is worth doing again. */
const TOO_WIDE = 2;
/** Where more than this part of a mesh is near, it is drawn whole. */
const MOST = 0.5;

const inverse = new Matrix4();
const place = new Vector3();
/** Numbers of triangles; grows to what the largest mesh needs. */
let numbers = new Uint32Array(4096);

/**
 * Draws of one mesh the triangles around the collider alone: a proxy whose geometry has the user's attributes and an
 * index of its own.
 */
export class NearTriangles {
  readonly mesh: Mesh;
  readonly proxy: ObjectProxy;
  readonly #geometry = new BufferGeometry();
  readonly #index: TriangleIndex;
  /** What the index was gathered within, and what is needed now, in the mesh's own space. */
  readonly #gathered = new Float64Array(6);
  readonly #needed = new Float64Array(6);
  /** The parts of the geometry that are drawn: first triangle, last but one, number of the material. */
  readonly #parts: number[] = [];
  /** The box around the gathered triangles. */
  readonly #around = new Float64Array(6);
  #partial = false;

  constructor(mesh: Mesh, index: TriangleIndex) {
    this.mesh = mesh;
    this.#index = index;
    // The object itself: what the user replaces in it is replaced here.
    this.#geometry.attributes = mesh.geometry.attributes;
    this.#gathered.fill(NaN);
    this.proxy = createObjectProxy(mesh);
    Object.defineProperty(this.proxy, 'geometry', { value: this.#geometry });
  }

  /** Is it of this geometry? */
  serves(geometry: BufferGeometry, index: TriangleIndex): boolean {
    return this.#geometry.attributes === geometry.attributes && this.#index === index;
  }

  /**
   * Sees to it that the proxy draws all that is within reach.
   *
   * @param center world space
   * @param reach metres
   * @returns whether it does; else the mesh is to be drawn whole
   */
  update(center: Vector3, reach: number): boolean {
    const same = this.#sameParts();
    if (!this.#box(center, reach, this.#needed)) return false;
    if (same && this.#fits()) return this.#partial;
    this.#box(center, reach * (1 + MARGIN), this.#gathered);
    this.#partial = this.#gather();
    return this.#partial;
  }

  /** A bit for each face of the cubemap that the gathered triangles may be seen in. */
  facesTouched(center: Vector3, reach: number): number {
    return facesOfBox(this.#around, this.mesh.matrixWorld, center, reach);
  }

  /** Frees what it has on the GPU; the user's attributes stay. */
  dispose(): void {
    this.#geometry.attributes = {};
    this.#geometry.dispose();
  }

  /** The box around the reach in the mesh's own space. */
  #box(center: Vector3, reach: number, target: Float64Array): boolean {
    inverse.copy(this.mesh.matrixWorld).invert();
    const { elements } = inverse;
    // Flat: it has no inverse.
    if (!(Math.abs(elements[15]!) > 0) || !Number.isFinite(reach)) return false;
    place.copy(center).applyMatrix4(inverse);
    for (let axis = 0; axis < 3; axis++) {
      const half = reach * Math.hypot(elements[axis]!, elements[axis + 4]!, elements[axis + 8]!);
      const middle = place.getComponent(axis);
      target[axis] = middle - half;
      target[axis + 3] = middle + half;
    }
    return true;
  }

  #fits(): boolean {
    const needed = this.#needed;
    const gathered = this.#gathered;
    for (let axis = 0; axis < 3; axis++) {
      const least = gathered[axis]!;
      const most = gathered[axis + 3]!;
      if (!(needed[axis]! >= least && needed[axis + 3]! <= most)) return false;
      if (most - least > TOO_WIDE * (needed[axis + 3]! - needed[axis]!)) return false;
    }
    return true;
  }

  /** Takes over which parts are drawn. @returns whether they are those from before */
  #sameParts(): boolean {
    const { material, geometry } = this.mesh;
    const { drawRange, groups } = geometry;
    const parts = this.#parts;
    const several = Array.isArray(material);
    const count = several ? groups.length : 1;
    let same = parts.length === 3 * count;
    parts.length = 3 * count;
    for (let i = 0; i < count; i++) {
      const group = several ? groups[i]! : null;
      const start = Math.max(0, drawRange.start, group?.start ?? 0);
      const end = Math.min(
        drawRange.start + drawRange.count,
        group === null ? Infinity : group.start + group.count,
      );
      const which = group?.materialIndex ?? 0;
      same &&= parts[3 * i] === start && parts[3 * i + 1] === end && parts[3 * i + 2] === which;
      parts[3 * i] = start;
      parts[3 * i + 1] = end;
      parts[3 * i + 2] = which;
    }
    return same;
  }

  #gather(): boolean {
    const { triangles } = this.#index.vertices;
    const geometry = this.#geometry;
    const parts = this.#parts;
    const several = Array.isArray(this.mesh.material);
    geometry.clearGroups();
    empty(this.#around, 0);
    let count = 0;
    for (let i = 0; i < parts.length; i += 3) {
      const start = parts[i]!;
      // Triangles between two of those that are known.
      if (start % 3 !== 0) return false;
      const to = Math.min(triangles, Math.floor(parts[i + 1]! / 3));
      let end = this.#index.gather(this.#gathered, start / 3, to, numbers, count, this.#around);
      while (end < 0) {
        if (numbers.length > MOST * triangles) return false;
        const grown = new Uint32Array(2 * numbers.length);
        grown.set(numbers);
        numbers = grown;
        end = this.#index.gather(this.#gathered, start / 3, to, numbers, count, this.#around);
      }
      if (several) geometry.addGroup(3 * count, 3 * (end - count), parts[i + 2]!);
      count = end;
    }
    if (count > MOST * triangles) return false;
    this.#write(count);
    geometry.setDrawRange(0, 3 * count);
    geometry.boundingSphere = this.mesh.geometry.boundingSphere;
    return true;
  }

  #write(count: number): void {
    const geometry = this.#geometry;
    let attribute = geometry.index;
    if (attribute === null || attribute.count < 3 * count) {
      // three cannot let a buffer grow: this frees the smaller one.
      const { attributes } = geometry;
      this.dispose();
      geometry.attributes = attributes;
      const size = 2 ** Math.ceil(Math.log2(3 * count + 3 * 64));
      attribute = new BufferAttribute(new Uint32Array(size), 1).setUsage(DynamicDrawUsage);
      geometry.setIndex(attribute);
    }
    const { array } = attribute;
    const { index } = this.#index.vertices;
    for (let i = 0, to = 0; i < count; i++) {
      const from = 3 * numbers[i]!;
      array[to++] = index === null ? from : index[from]!;
      array[to++] = index === null ? from + 1 : index[from + 1]!;
      array[to++] = index === null ? from + 2 : index[from + 2]!;
    }
    attribute.clearUpdateRanges();
    attribute.addUpdateRange(0, 3 * count);
    attribute.needsUpdate = true;
  }
}
