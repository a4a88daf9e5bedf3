import {
  type BatchedMesh,
  type BufferAttribute,
  type BufferGeometry,
  type GLBufferAttribute,
  type InstancedMesh,
  type InterleavedBufferAttribute,
  Matrix4,
  type Mesh,
} from 'three';
import { batchVersion } from './isRigid.js';
import { isSolid } from './isSolid.js';

type Attribute = BufferAttribute | InterleavedBufferAttribute | GLBufferAttribute;

/** What a mesh was when it was drawn: all that the processor can tell of its place and its shape. */
export class SeenMesh {
  /** Number of the draw; 0 for none. */
  draw = 0;
  readonly #matrix = new Matrix4();
  #geometry: BufferGeometry | null = null;
  #position: Attribute | undefined;
  #positionVersion = 0;
  #index: BufferAttribute | null = null;
  #indexVersion = 0;
  #start = 0;
  #count = 0;
  #groups = 0;
  #instanceMatrix: Attribute | undefined;
  #instanceVersion = 0;
  #instances = 0;
  #batch = 0;
  #materials = 0;

  /** Notes a mesh as `draw` shows it. Allocates nothing. */
  take(mesh: Mesh, draw: number): void {
    const { geometry } = mesh;
    const instanced = mesh as Partial<InstancedMesh>;
    this.draw = draw;
    this.#matrix.copy(mesh.matrixWorld);
    this.#geometry = geometry;
    this.#position = geometry.attributes.position;
    this.#positionVersion = versionOf(this.#position);
    this.#index = geometry.index;
    this.#indexVersion = geometry.index === null ? 0 : geometry.index.version;
    this.#start = geometry.drawRange.start;
    this.#count = geometry.drawRange.count;
    this.#groups = geometry.groups.length;
    this.#instanceMatrix = instanced.instanceMatrix;
    this.#instanceVersion = versionOf(instanced.instanceMatrix);
    this.#instances = instanced.count ?? 0;
    this.#batch = batchOf(mesh);
    this.#materials = solidityOf(mesh);
  }

  /** Has it another world matrix now? */
  moved(mesh: Mesh): boolean {
    const then = this.#matrix.elements;
    const now = mesh.matrixWorld.elements;
    for (let i = 0; i < 16; i++) if (then[i] !== now[i]) return true;
    return false;
  }

  /** Has it another shape now, or is another part of it solid? */
  changed(mesh: Mesh): boolean {
    const { geometry } = mesh;
    const instanced = mesh as Partial<InstancedMesh>;
    const { position } = geometry.attributes;
    return (
      geometry !== this.#geometry ||
      position !== this.#position ||
      versionOf(position) !== this.#positionVersion ||
      geometry.index !== this.#index ||
      (geometry.index !== null && geometry.index.version !== this.#indexVersion) ||
      geometry.drawRange.start !== this.#start ||
      geometry.drawRange.count !== this.#count ||
      geometry.groups.length !== this.#groups ||
      instanced.instanceMatrix !== this.#instanceMatrix ||
      versionOf(instanced.instanceMatrix) !== this.#instanceVersion ||
      (instanced.count ?? 0) !== this.#instances ||
      batchOf(mesh) !== this.#batch ||
      solidityOf(mesh) !== this.#materials
    );
  }
}

function versionOf(attribute: Attribute | undefined): number {
  if (attribute === undefined) return 0;
  const { data } = attribute as InterleavedBufferAttribute;
  return data?.version ?? (attribute as BufferAttribute).version;
}

function batchOf(mesh: Mesh): number {
  return (mesh as BatchedMesh).isBatchedMesh ? batchVersion(mesh) : 0;
}

/** A number of which of its materials are solid, and which sides of them. */
function solidityOf({ material }: Mesh): number {
  if (!Array.isArray(material)) return isSolid(material) ? 1 + material.side : 0;
  let all = material.length;
  for (let i = 0; i < material.length; i++) {
    const each = material[i];
    // Kept to 30 bits, which every engine holds without an object.
    all = (all * 5 + (isSolid(each) ? 1 + each!.side : 0)) & 0x3fffffff;
  }
  return all;
}
