import {
  type BufferAttribute,
  type BufferGeometry,
  type InterleavedBufferAttribute,
  Matrix4,
  type Mesh,
  type SkinnedMesh,
  Vector3,
} from 'three';

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** One drawing of a mesh's geometry: an instance, say. */
export interface Part {
  readonly instance: number;
  /** From the geometry's frame to the mesh's. */
  readonly matrix?: Matrix4;
  /** Of a batch, which geometry. */
  readonly geometry?: BufferGeometry;
  /** Weights of the morph targets, one each. */
  readonly weights?: readonly number[];
}

/** What a mesh shows, as its maker knows it. */
export interface Shown {
  readonly mesh: Mesh;
  readonly parts?: readonly Part[];
  /** Which of its several materials are solid. */
  readonly solid?: readonly number[];
}

/**
 * Triangles in world space, worked out from what the user set, in doubles: the judge of what the GPU drew. It shares
 * nothing with the collider and reads neither three's shaders nor its raycaster; of three it uses the maths of matrices.
 */
export class DrawnTriangles {
  /** Nine numbers a triangle. */
  readonly corners: number[] = [];
  readonly meshes: Mesh[] = [];
  readonly instances: number[] = [];

  constructor(all: readonly Shown[]) {
    for (const shown of all) {
      for (const part of shown.parts ?? [{ instance: 0 }]) this.#add(shown, part);
    }
  }

  /** The nearest triangle along a ray beyond `near` metres: its number (-1 for none) in `hit`. Returns its distance. */
  cast(from: Vector3, direction: Vector3, near: number): number {
    const { corners } = this;
    const { x: dx, y: dy, z: dz } = direction;
    let nearest = Infinity;
    this.hit = -1;
    for (let i = 0, triangle = 0; i < corners.length; i += 9, triangle++) {
      // Möller and Trumbore, either side.
      const ax = corners[i]!;
      const ay = corners[i + 1]!;
      const az = corners[i + 2]!;
      const ex = corners[i + 3]! - ax;
      const ey = corners[i + 4]! - ay;
      const ez = corners[i + 5]! - az;
      const fx = corners[i + 6]! - ax;
      const fy = corners[i + 7]! - ay;
      const fz = corners[i + 8]! - az;
      const px = dy * fz - dz * fy;
      const py = dz * fx - dx * fz;
      const pz = dx * fy - dy * fx;
      const determinant = ex * px + ey * py + ez * pz;
      if (determinant === 0) continue;
      const sx = from.x - ax;
      const sy = from.y - ay;
      const sz = from.z - az;
      const u = (sx * px + sy * py + sz * pz) / determinant;
      if (u < 0 || u > 1) continue;
      const qx = sy * ez - sz * ey;
      const qy = sz * ex - sx * ez;
      const qz = sx * ey - sy * ex;
      const v = (dx * qx + dy * qy + dz * qz) / determinant;
      if (v < 0 || u + v > 1) continue;
      const distance = (fx * qx + fy * qy + fz * qz) / determinant;
      if (distance > near && distance < nearest) {
        nearest = distance;
        this.hit = triangle;
      }
    }
    return nearest;
  }

  /** Number of the triangle that `cast` met. */
  hit = -1;

  #add({ mesh, solid }: Shown, part: Part): void {
    const geometry = part.geometry ?? mesh.geometry;
    const { index, drawRange, groups } = geometry;
    const whole = index?.count ?? geometry.attributes.position!.count;
    const several = Array.isArray(mesh.material);
    for (const { start, count, materialIndex } of several ? groups : [{ start: 0, count: whole }]) {
      if (several && !(solid ?? []).includes(materialIndex!)) continue;
      const first = Math.max(start, drawRange.start);
      const end = Math.min(start + count, drawRange.start + drawRange.count, whole);
      for (let i = first; i + 2 < end; i += 3) {
        for (let corner = 0; corner < 3; corner++) {
          const vertex = index === null ? i + corner : index.array[i + corner]!;
          this.corners.push(...this.#vertex(mesh, geometry, part, vertex).toArray());
        }
        this.meshes.push(mesh);
        this.instances.push(part.instance);
      }
    }
  }

  /** A vertex in world space. */
  #vertex(mesh: Mesh, geometry: BufferGeometry, part: Part, vertex: number): Vector3 {
    const { attributes, morphAttributes, morphTargetsRelative } = geometry;
    const place = numbers(attributes.position as Attribute, vertex);
    const weights = part.weights ?? mesh.morphTargetInfluences ?? [];
    const from = [...place];
    weights.forEach((weight, target) => {
      const to = numbers(morphAttributes.position![target] as Attribute, vertex);
      for (let i = 0; i < 3; i++) {
        place[i]! += weight * (to[i]! - (morphTargetsRelative ? 0 : from[i]!));
      }
    });
    const point = new Vector3(place[0], place[1], place[2]);
    if (part.matrix) point.applyMatrix4(part.matrix);
    const skin = mesh as SkinnedMesh;
    if (skin.isSkinnedMesh) this.#pose(skin, geometry, vertex, point);
    return point.applyMatrix4(mesh.matrixWorld);
  }

  /** Where the bones take a point of the mesh's frame. */
  #pose(mesh: SkinnedMesh, { attributes }: BufferGeometry, vertex: number, point: Vector3): void {
    const bones = numbers(attributes.skinIndex as Attribute, vertex);
    const weights = numbers(attributes.skinWeight as Attribute, vertex);
    const bound = point.clone().applyMatrix4(mesh.bindMatrix);
    point.set(0, 0, 0);
    weights.forEach((weight, i) => {
      if (weight === 0) return;
      const { bones: all, boneInverses } = mesh.skeleton;
      const place = bound.clone().applyMatrix4(boneInverses[bones[i]!]!);
      point.addScaledVector(place.applyMatrix4(all[bones[i]!]!.matrixWorld), weight);
    });
    // An attached skin's bones say where it is in the world; a detached one's, where it would be if it were not moved.
    const back = mesh.bindMode === 'attached' ? mesh.matrixWorld : mesh.bindMatrix;
    point.applyMatrix4(new Matrix4().copy(back).invert());
  }
}

/** An attribute's numbers for a vertex: read, interleaved or not, and turned into what they stand for. */
function numbers(attribute: Attribute, vertex: number): number[] {
  const { data } = attribute as InterleavedBufferAttribute;
  const array = data ? data.array : attribute.array;
  const from = data
    ? vertex * data.stride + (attribute as InterleavedBufferAttribute).offset
    : vertex * attribute.itemSize;
  return Array.from(array.slice(from, from + attribute.itemSize), (stored) => {
    if (!attribute.normalized) return stored;
    if (array instanceof Int8Array) return Math.max(stored / 127, -1);
    if (array instanceof Int16Array) return Math.max(stored / 32767, -1);
    if (array instanceof Uint8Array) return stored / 255;
    if (array instanceof Uint16Array) return stored / 65535;
    throw new TypeError(`normalized ${array.constructor.name}`);
  });
}
