import {
  type BatchedMesh,
  DataTexture,
  Matrix4,
  type PixelFormat,
  Sphere,
  type Vector3,
} from 'three';

/** What three keeps of a batch and tells of in parts only: the same names in every three from 0.180 on. */
export interface BatchParts {
  readonly _instanceInfo: { visible: boolean; active: boolean; geometryIndex: number }[];
  readonly _geometryInfo: { start: number; count: number }[];
  readonly _matricesTexture: { version: number } | null;
  readonly _indirectTexture: DataTexture | null;
  readonly _multiDrawStarts: Int32Array;
  readonly _multiDrawCounts: Int32Array;
}

/** The parts of a batch that a list is made of; null where it was disposed, or three keeps them otherwise than today. */
export function partsOf(mesh: unknown): BatchParts | null {
  const parts = mesh as Partial<BatchParts>;
  return Array.isArray(parts._instanceInfo) &&
    Array.isArray(parts._geometryInfo) &&
    typeof parts._matricesTexture?.version === 'number' &&
    parts._indirectTexture?.isDataTexture === true &&
    parts._multiDrawStarts instanceof Int32Array &&
    parts._multiDrawCounts instanceof Int32Array
    ? (parts as BatchParts)
    : null;
}

/** What a proxy is lent of it. */
interface LentParts {
  _multiDrawStarts: Int32Array;
  _multiDrawCounts: Int32Array;
  _multiDrawCount: number;
  _mergedDrawStarts: Int32Array;
  _mergedDrawCounts: Int32Array;
  _mergedDrawInstanceCounts: Int32Array;
  _mergedDrawCount: number;
  _multiDrawBytesPerElement: number;
  _indirectTexture: DataTexture;
  _updateDrawParameters: () => void;
}

const nothing = () => {};

/**
 * Which instances of a `BatchedMesh` one cubemap shows: all that are visible and within reach. The user's own list says
 * which of them the user's camera saw last, so it is neither used nor written. (three could make another one for our
 * cameras, but would cull it in world space against spheres that are not.)
 */
export class BatchList {
  /** Number of the selection that it was made for last. */
  selection = 0;
  #starts = new Int32Array(0);
  #counts = new Int32Array(0);
  /** The same for WebGPU: one draw for successive instances of one geometry. */
  #mergedStarts = new Int32Array(0);
  #mergedCounts = new Int32Array(0);
  #mergedInstances = new Int32Array(0);
  /** Each drawn instance's number, as three's shader looks it up. */
  #texture: DataTexture | null = null;
  #freed = false;

  /**
   * Lists what is near and lends the list to `proxy`, which three then draws by it. Where three keeps other parts than
   * are known here, the user's own list stays.
   *
   * @param center world space
   * @param far metres
   */
  gather(mesh: BatchedMesh, proxy: object, center: Vector3, far: number): void {
    const parts = partsOf(mesh);
    if (parts === null) return;
    const { _instanceInfo: instances, _geometryInfo: geometries } = parts;
    const texture = this.#fit(parts);
    const starts = this.#starts;
    const counts = this.#counts;
    const numbers = texture.image.data as unknown as Uint32Array;
    const { index } = mesh.geometry;
    const bytes = index === null ? 1 : index.array.BYTES_PER_ELEMENT;
    let count = 0;
    let merged = 0;
    let changed = this.#freed;
    this.#freed = false;
    for (let i = 0; i < instances.length; i++) {
      const { visible, active, geometryIndex } = instances[i]!;
      if (!visible || !active) continue;
      // Who switches the culling off may have a shader that moves vertices out of their bounds.
      if (mesh.perObjectFrustumCulled && !isNear(mesh, i, geometryIndex, center, far)) continue;
      const geometry = geometries[geometryIndex]!;
      starts[count] = geometry.start * bytes;
      counts[count] = geometry.count;
      if (numbers[count] !== i) {
        numbers[count] = i;
        changed = true;
      }
      merged = this.#merge(merged, starts[count]!, counts[count]!);
      count++;
    }
    if (changed) texture.needsUpdate = true;
    const lent = proxy as LentParts;
    lent._multiDrawStarts = starts;
    lent._multiDrawCounts = counts;
    lent._multiDrawCount = count;
    lent._mergedDrawStarts = this.#mergedStarts;
    lent._mergedDrawCounts = this.#mergedCounts;
    lent._mergedDrawInstanceCounts = this.#mergedInstances;
    lent._mergedDrawCount = merged;
    lent._multiDrawBytesPerElement = bytes;
    lent._indirectTexture = texture;
    lent._updateDrawParameters = nothing;
  }

  /** Frees the texture on the GPU, where the next `gather` puts it anew: WebGPU's programs hold on to the object. */
  dispose(): void {
    this.#texture?.dispose();
    this.#freed = true;
  }

  /** Adds an instance to the `count` merged draws. @returns how many there are then */
  #merge(count: number, start: number, length: number): number {
    const last = count - 1;
    if (count > 0 && this.#mergedStarts[last] === start && this.#mergedCounts[last] === length) {
      this.#mergedInstances[last]!++;
      return count;
    }
    this.#mergedStarts[count] = start;
    this.#mergedCounts[count] = length;
    this.#mergedInstances[count] = 1;
    return count + 1;
  }

  /** As much room as the user's own list has. */
  #fit({ _multiDrawStarts: { length }, _indirectTexture: theirs }: BatchParts): DataTexture {
    if (this.#starts.length !== length) {
      this.#starts = new Int32Array(length);
      this.#counts = new Int32Array(length);
      this.#mergedStarts = new Int32Array(length);
      this.#mergedCounts = new Int32Array(length);
      this.#mergedInstances = new Int32Array(length);
    }
    const { width, height } = theirs!.image as { width: number; height: number };
    if (this.#texture !== null && this.#texture.image.width === width) return this.#texture;
    this.dispose();
    const numbers = new Uint32Array(width * height);
    const { format, type } = theirs!;
    this.#texture = new DataTexture(numbers, width, height, format as PixelFormat, type);
    this.#texture.needsUpdate = true;
    return this.#texture;
  }
}

const matrix = /* @__PURE__ */ new Matrix4();
const sphere = /* @__PURE__ */ new Sphere();

/** Does an instance's bounding sphere come within reach? One that is not finite does. */
function isNear(
  mesh: BatchedMesh,
  instance: number,
  geometry: number,
  center: Vector3,
  far: number,
): boolean {
  mesh.getMatrixAt(instance, matrix).premultiply(mesh.matrixWorld);
  mesh.getBoundingSphereAt(geometry, sphere)!.applyMatrix4(matrix);
  return !(sphere.center.distanceTo(center) > sphere.radius + far);
}
