import {
  Box3,
  type BufferAttribute,
  type BufferGeometry,
  type InterleavedBufferAttribute,
  Matrix4,
  type Skeleton,
  type SkinnedMesh,
  type Sphere,
  Vector3,
} from 'three';

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/**
 * A sphere around a skin in its present pose: around a ball at each bone that holds every vertex the bone has a part in.
 * A vertex lies between where its bones would carry it, so within the balls' hull. One pass over the vertices when the
 * mesh is first met, one over the bones each time.
 */
export class SkinSphere {
  #geometry: BufferGeometry | null = null;
  #skeleton: Skeleton | null = null;
  #position: unknown = null;
  /** Of each bone's ball, in the bone's own frame; below 0 where it moves nothing. */
  #radius = new Float64Array(0);

  /** @param target in world space */
  find(mesh: SkinnedMesh, target: Sphere): void {
    const { geometry, skeleton } = mesh;
    if (
      geometry !== this.#geometry ||
      skeleton !== this.#skeleton ||
      geometry.attributes.position !== this.#position
    ) {
      this.#measure(mesh);
    }
    const { bones } = skeleton;
    const radius = this.#radius;
    box.makeEmpty();
    for (let i = 0; i < radius.length; i++) {
      if (radius[i]! < 0) continue;
      const r = radius[i]! * bones[i]!.matrixWorld.getMaxScaleOnAxis();
      at.setFromMatrixPosition(bones[i]!.matrixWorld);
      box.expandByPoint(corner.copy(at).addScalar(r)).expandByPoint(at.addScalar(-r));
    }
    box.getBoundingSphere(target);
    // Nothing, where the mesh follows its bones; else from where it was bound to where it is.
    target.applyMatrix4(frame.multiplyMatrices(mesh.matrixWorld, mesh.bindMatrixInverse));
  }

  #measure({ geometry, skeleton, bindMatrix }: SkinnedMesh): void {
    const { boneInverses } = skeleton;
    const position = geometry.attributes.position as Attribute;
    const index = geometry.attributes.skinIndex as Attribute;
    const weight = geometry.attributes.skinWeight as Attribute;
    const radius = (this.#radius = new Float64Array(boneInverses.length).fill(-1));
    if (geometry.morphAttributes.position !== undefined)
      this.#measureWhole(geometry, bindMatrix, boneInverses);
    else
      for (let i = 0; i < position.count; i++) {
        at.fromBufferAttribute(position, i).applyMatrix4(bindMatrix);
        for (let j = 0; j < 4; j++) {
          if (weight.getComponent(i, j) === 0) continue;
          const bone = index.getComponent(i, j);
          const inverse = boneInverses[bone];
          if (inverse === undefined) continue;
          const distance = corner.copy(at).applyMatrix4(inverse).length();
          if (distance > radius[bone]!) radius[bone] = distance;
        }
      }
    this.#geometry = geometry;
    this.#skeleton = skeleton;
    this.#position = position;
  }

  /** Morphs may carry a vertex anywhere within the geometry's own sphere: around each bone a ball that holds it all. */
  #measureWhole(geometry: BufferGeometry, bindMatrix: Matrix4, inverses: readonly Matrix4[]): void {
    if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
    const { center, radius } = geometry.boundingSphere!;
    for (let i = 0; i < inverses.length; i++) {
      frame.multiplyMatrices(inverses[i]!, bindMatrix);
      const distance = at.copy(center).applyMatrix4(frame).length();
      this.#radius[i] = distance + radius * frame.getMaxScaleOnAxis();
    }
  }
}

const box = /* @__PURE__ */ new Box3();
const at = /* @__PURE__ */ new Vector3();
const corner = /* @__PURE__ */ new Vector3();
const frame = /* @__PURE__ */ new Matrix4();
