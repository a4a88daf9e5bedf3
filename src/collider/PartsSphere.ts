import { type BatchedMesh, type BufferGeometry, type InstancedMesh, Sphere } from 'three';
import { batchVersion } from './isRigid.js';

/** A sphere around all parts of an `InstancedMesh` or `BatchedMesh`, in its own frame, found anew when they change. */
export class PartsSphere {
  readonly #sphere = new Sphere();
  /** Reads all from the mesh, but keeps the sphere to itself. */
  #standIn: InstancedMesh | BatchedMesh | null = null;
  #geometry: BufferGeometry | null = null;
  #matrices: unknown = null;
  #version = -1;
  #count = -1;
  /** The user's own, when it was found: one found anew tells of parts that moved before they were first uploaded. */
  readonly #theirs = new Sphere();

  of(mesh: InstancedMesh | BatchedMesh): Sphere {
    const instanced = (mesh as InstancedMesh).isInstancedMesh ? (mesh as InstancedMesh) : null;
    const matrices = instanced?.instanceMatrix ?? null;
    const version = instanced === null ? batchVersion(mesh) : instanced.instanceMatrix.version;
    const count = instanced === null ? 0 : instanced.count;
    const { geometry } = mesh;
    if (
      version < 0 ||
      version !== this.#version ||
      count !== this.#count ||
      matrices !== this.#matrices ||
      geometry !== this.#geometry ||
      (mesh.boundingSphere !== null && !mesh.boundingSphere.equals(this.#theirs))
    ) {
      this.#standIn ??= Object.create(mesh, {
        boundingSphere: { value: this.#sphere },
      }) as InstancedMesh | BatchedMesh;
      this.#standIn.computeBoundingSphere();
      this.#geometry = geometry;
      this.#matrices = matrices;
      this.#version = version;
      this.#count = count;
      if (mesh.boundingSphere !== null) this.#theirs.copy(mesh.boundingSphere);
    }
    return this.#sphere;
  }
}
