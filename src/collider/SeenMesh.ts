import {
  type BatchedMesh,
  type BufferAttribute,
  type BufferGeometry,
  type GLBufferAttribute,
  type InstancedMesh,
  type InterleavedBufferAttribute,
  type Material,
  Matrix4,
  type Mesh,
  type Texture,
} from 'three';
import { batchVersion } from './isRigid.js';
import { isSolid } from './isSolid.js';
import { alphaCut } from './materialKind.js';

type Attribute = BufferAttribute | InterleavedBufferAttribute | GLBufferAttribute;

interface WithMaps extends Material {
  map?: Texture | null;
  alphaMap?: Texture | null;
}

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
  #appearance = 0;

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
    this.#appearance = appearanceOf(mesh);
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
      appearanceOf(mesh) !== this.#appearance
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

/**
 * A number of which of its materials are solid, which sides of them, and what is cut out of them: by alpha, and by
 * clipping planes of their own.
 */
function appearanceOf({ material, userData }: Mesh): number {
  const all = userData.collider === true ? 1 : 0;
  if (!Array.isArray(material)) return join(all, appearance(material));
  let each = join(all, material.length);
  for (let i = 0; i < material.length; i++) each = join(each, appearance(material[i]));
  return each;
}

function appearance(material: WithMaps | null | undefined): number {
  if (!material) return 0;
  const { side, clippingPlanes } = material;
  // Both, so that it tells the same whatever the policy for transparent ones.
  let all = 1 + side + (isSolid(material) ? 3 : 0) + (isSolid(material, 'shown') ? 6 : 0);
  const cut = alphaCut(material);
  if (cut > 0) {
    all = join(mix(mix(all, cut), material.opacity), textureOf(material.map));
    all = join(all, textureOf(material.alphaMap));
  }
  if (clippingPlanes !== null && clippingPlanes.length > 0) {
    all = join(all, material.clipIntersection ? 2 : 1);
    for (let i = 0; i < clippingPlanes.length; i++) {
      const { normal, constant } = clippingPlanes[i]!;
      all = mix(mix(mix(mix(all, normal.x), normal.y), normal.z), constant);
    }
  }
  return all;
}

function textureOf(texture: Texture | null | undefined): number {
  if (!texture) return 0;
  const { offset, repeat, rotation } = texture;
  const place = mix(mix(mix(mix(rotation, offset.x), offset.y), repeat.x), repeat.y);
  return join(join(texture.id, texture.version), place);
}

const float = new Float32Array(1);
const bits = new Int32Array(float.buffer);

/** Of two integers; small ones all the way, for which no engine makes an object. */
function join(a: number, b: number): number {
  return ((a & 0xffffff) * 31 + (b & 0xffffff)) & 0xffffff;
}

/** Of an integer and a fraction, its sign and exponent folded in. */
function mix(a: number, b: number): number {
  float[0] = b;
  const all = bits[0]!;
  return join(a, all ^ (all >>> 20));
}
