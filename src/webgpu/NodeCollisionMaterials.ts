import { uniform } from 'three/tsl';
import { BackSide, DoubleSide, type Material, NodeMaterial, type Side } from 'three/webgpu';
import type { CubeColliderSettings } from '../collider/CubeColliderOptions.js';
import { isSolid, type Solidity } from '../collider/isSolid.js';
import { alphaCut, materialKind } from '../collider/materialKind.js';
import { CollisionNodeMaterial } from './CollisionNodeMaterial.js';
import { DerivedNodeMaterial } from './derivedNodeMaterial.js';
import type { TexelUniforms } from './surfaceTexel.js';

/** One of the user's that has a collision material of its own. */
interface Derived {
  readonly material: DerivedNodeMaterial;
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
  readonly #derived = new Map<Material, Derived>();
  /** For groups that are no obstacle, or have no material. */
  readonly #nothing = new NodeMaterial();
  readonly #arrays: Record<Solidity, WeakMap<Material[], Material[]>> = {
    opaque: new WeakMap(),
    shown: new WeakMap(),
    all: new WeakMap(),
  };

  constructor(settings: CubeColliderSettings) {
    const { resolution, supersample, far, output, rMin, rMax } = settings;
    this.#settings = settings;
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
    for (const source of this.#derived.keys()) this.#drop(source);
    this.#nothing.dispose();
  }

  #of(source: Material): Material {
    if (!needsOwn(source)) return this.#ofSide(source.side);
    let derived = this.#derived.get(source);
    if (derived === undefined) this.#derived.set(source, (derived = this.#derive(source)));
    derived.material.follow(this.#settings.sides);
    return derived.material;
  }

  #derive(source: Material): Derived {
    const material = new DerivedNodeMaterial(source, this.#uniforms, this.#settings.near);
    const onDispose = () => this.#drop(source);
    source.addEventListener('dispose', onDispose);
    return { material, release: () => source.removeEventListener('dispose', onDispose) };
  }

  #drop(source: Material): void {
    const derived = this.#derived.get(source)!;
    this.#derived.delete(source);
    derived.release();
    derived.material.dispose();
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

/** May it move vertices or cut holes, as three's node renderer draws it? */
function needsOwn(source: Material & { isNodeMaterial?: boolean }): boolean {
  if (source.isNodeMaterial === true) return true;
  // Shaders in GLSL and hooks into them are not run there.
  const kind = materialKind(source);
  return kind === 'cut' || (kind === 'shader' && alphaCut(source) > 0);
}
