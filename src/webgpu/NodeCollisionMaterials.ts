import { uniform } from 'three/tsl';
import {
  BackSide,
  DoubleSide,
  type Material,
  type MeshStandardMaterial,
  NodeMaterial,
  type Side,
} from 'three/webgpu';
import type { CubeColliderSettings } from '../collider/CubeColliderOptions.js';
import { isSolid, type Solidity } from '../collider/isSolid.js';
import { alphaCut } from '../collider/materialKind.js';
import { CollisionNodeMaterial } from './CollisionNodeMaterial.js';
import { DerivedNodeMaterial } from './DerivedNodeMaterial.js';
import type { TexelUniforms } from './surfaceTexel.js';

/** What is kept for one of the user's. */
interface Worn {
  /** Its own collision material; null of plain ones. */
  derived: DerivedNodeMaterial | null;
  /** Lets go of the user's. */
  readonly release: () => void;
}

/** Programs must not be shared between colliders: their numbers are written into them. */
let nextKey = 0;

/**
 * The materials that scenery wears in the cubemap of a `WebGPURenderer`: one per side for all plain materials together,
 * and one for each of the user's that moves vertices or cuts holes, kept until that is disposed of. What is not a node
 * material three draws by its built-in properties alone, and so do we.
 */
export class NodeCollisionMaterials {
  readonly #settings: CubeColliderSettings;
  readonly #uniforms: TexelUniforms;
  readonly #bySide = new Map<Side, CollisionNodeMaterial>();
  readonly #worn = new Map<Material, Worn>();
  readonly #disposed: (source: Material) => void;
  /** For groups that are no obstacle, or have no material. */
  readonly #nothing = new NodeMaterial();
  readonly #arrays: Record<Solidity, WeakMap<Material[], Material[]>> = {
    opaque: new WeakMap(),
    shown: new WeakMap(),
    all: new WeakMap(),
  };

  /** @param disposed told of each of the user's that was drawn and is disposed of */
  constructor(settings: CubeColliderSettings, disposed: (source: Material) => void) {
    const { resolution, supersample, far, output, rMin, rMax } = settings;
    this.#settings = settings;
    this.#disposed = disposed;
    this.#nothing.visible = false;
    this.#uniforms = {
      key: `CubeCollider ${nextKey++}`,
      resolution: resolution * supersample,
      far: uniform(far),
      shell: output === 'axis' ? { rMin, rMax } : null,
    };
  }

  /** Reach, metres. */
  set far(far: number) {
    this.#uniforms.far.value = far;
  }

  /**
   * The collision material for a mesh's material, or one for each of several.
   *
   * @param solidity which of several are obstacles
   */
  for(source: Material | Material[], solidity: Solidity): Material | Material[] {
    if (!Array.isArray(source)) return this.#of(source);
    let materials = this.#arrays[solidity].get(source);
    if (materials === undefined) this.#arrays[solidity].set(source, (materials = []));
    materials.length = source.length;
    for (let i = 0; i < source.length; i++) {
      const material = source[i];
      materials[i] = isSolid(material, solidity) ? this.#of(material!) : this.#nothing;
    }
    return materials;
  }

  dispose(): void {
    for (const material of this.#bySide.values()) material.dispose();
    this.#bySide.clear();
    for (const source of this.#worn.keys()) this.#drop(source);
    this.#nothing.dispose();
  }

  #of(source: Material): Material {
    let worn = this.#worn.get(source);
    if (worn === undefined) this.#worn.set(source, (worn = this.#wear(source)));
    if (!needsOwn(source)) return this.#ofSide(source.side);
    worn.derived ??= new DerivedNodeMaterial(source, this.#uniforms, this.#settings.near);
    worn.derived.follow(this.#settings.sides);
    return worn.derived;
  }

  #wear(source: Material): Worn {
    const onDispose = () => {
      this.#drop(source);
      this.#disposed(source);
    };
    source.addEventListener('dispose', onDispose);
    return { derived: null, release: () => source.removeEventListener('dispose', onDispose) };
  }

  #drop(source: Material): void {
    const worn = this.#worn.get(source)!;
    this.#worn.delete(source);
    worn.release();
    worn.derived?.dispose();
  }

  #ofSide(side: Side): CollisionNodeMaterial {
    let material = this.#bySide.get(side);
    if (material !== undefined) return material;
    material = new CollisionNodeMaterial(this.#uniforms, this.#settings.near);
    material.side = this.#settings.sides === 'both' ? DoubleSide : side;
    material.frontSign = side === DoubleSide ? 0 : side === BackSide ? -1 : 1;
    this.#bySide.set(side, material);
    return material;
  }
}

/** The nodes that may move vertices or discard fragments. */
const TRICKS = [
  ...['positionNode', 'vertexNode', 'geometryNode', 'depthNode', 'maskNode', 'alphaTestNode'],
  ...['colorNode', 'opacityNode', 'outputNode', 'fragmentNode'],
] as const; // prettier-ignore

type AnyMaterial = Material & Partial<Record<(typeof TRICKS)[number], unknown>>;

/** May it move vertices or cut holes, as three's node renderer draws it? */
function needsOwn(source: AnyMaterial): boolean {
  if (alphaCut(source) > 0 || (source as MeshStandardMaterial).displacementMap) return true;
  for (const name of TRICKS) if (source[name]) return true;
  // Shaders in GLSL and hooks into them are not run there.
  return false;
}
