import {
  DoubleSide,
  type Material,
  NoBlending,
  ShaderMaterial,
  type Side,
  type WebGLRenderer,
} from 'three';
import type { TexelFormat } from '../cube/encoding.js';
import type { Warnings } from '../Warnings.js';
import { type CollisionProgram, collisionProgram } from './collisionProgram.js';
import { createCutMaterial } from './cutMaterial.js';
import type { DerivedMaterial } from './derivedMaterial.js';
import { isSolid, type Solidity } from './isSolid.js';
import { frontSignOf, materialKind } from './materialKind.js';
import { emptyProgram, firstError } from './shaderFailure.js';
import { WrappedMaterial } from './WrappedMaterial.js';

/** What the materials must know of their collider. */
export interface CollisionMaterialSettings {
  readonly output: 'surface' | 'axis';
  readonly sides: 'both' | 'drawn';
  readonly format: TexelFormat;
  readonly resolution: number;
  readonly near: number;
  readonly far: number;
  readonly rMin: number;
  readonly rMax: number;
}

/** The collision material of one of the user's that does not share the plain ones. */
interface Derived {
  readonly material: DerivedMaterial;
  /** Null where none of the user's code is run. */
  readonly wrap: WrappedMaterial | null;
  /** Lets go of the user's material. */
  readonly release: () => void;
}

/**
 * The materials that scenery wears in the cubemap (`for` is the one place that decides): one per side for all plain
 * materials together, and one for each of the user's that changes a surface's shape or coverage, kept until that is
 * disposed of.
 */
export class CollisionMaterials {
  readonly #settings: CollisionMaterialSettings;
  readonly #renderer: WebGLRenderer;
  readonly #warnings: Warnings;
  readonly #program: CollisionProgram;
  readonly #bySide = new Map<Side, ShaderMaterial>();
  readonly #derived = new Map<Material, Derived>();
  /** Materials that could not be wrapped, at which version, and how often. */
  readonly #failed = new WeakMap<Material, { version: number; times: number }>();
  /** For groups that are no obstacle, or have no material. */
  readonly #nothing = new ShaderMaterial({ visible: false });
  readonly #arrays: Record<Solidity, WeakMap<Material[], Material[]>> = {
    opaque: new WeakMap(),
    shown: new WeakMap(),
    all: new WeakMap(),
  };
  /** Shared by all: one value to set. */
  readonly #far: { value: number };

  constructor(settings: CollisionMaterialSettings, renderer: WebGLRenderer, warnings: Warnings) {
    this.#settings = settings;
    this.#renderer = renderer;
    this.#warnings = warnings;
    this.#far = { value: settings.far };
    this.#program = collisionProgram(settings, this.#far);
  }

  /** Reach, metres. */
  set far(far: number) {
    this.#far.value = far;
  }

  /**
   * The collision material for a mesh's material, or one for each of several.
   *
   * @param solidity which of several are obstacles
   */
  for(source: Material | Material[], solidity: Solidity = 'opaque'): Material | Material[] {
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

  /** For `renderer.debug.onShaderError`, while ours are drawn: notes what cannot be wrapped, and draws nothing with it. */
  readonly shaderFailed = (
    gl: WebGLRenderingContext,
    program: WebGLProgram,
    vertexShader: WebGLShader,
    fragmentShader: WebGLShader,
  ): void => {
    const reason = firstError(gl, program, vertexShader, fragmentShader);
    for (const { wrap } of this.#derived.values()) {
      if (wrap?.made(program)) wrap.failure ??= reason;
    }
    emptyProgram(gl, program, vertexShader, fragmentShader);
  };

  /**
   * Gives up, with a warning each, on what has turned out not to be wrapped since it was asked last.
   *
   * @returns whether there was any: what was drawn since then lacks it
   */
  giveUp(): boolean {
    let any = false;
    for (const [source, { wrap }] of this.#derived) {
      if (wrap === null || wrap.failure === null) continue;
      any = true;
      this.#fail(source, wrap.failure);
      this.#drop(source);
    }
    return any;
  }

  /** Makes the programs of `materials` ready, as far as three has begun them, so that their failures are known. */
  finish(materials: Iterable<Material>): void {
    for (const material of materials) {
      const { currentProgram } = this.#renderer.properties.get(material) as {
        currentProgram?: { getUniforms(): unknown };
      };
      currentProgram?.getUniforms();
    }
  }

  dispose(): void {
    for (const material of this.#bySide.values()) material.dispose();
    this.#bySide.clear();
    for (const source of this.#derived.keys()) this.#drop(source);
    this.#nothing.dispose();
  }

  #of(source: Material): Material {
    const kind = materialKind(source);
    if (kind === 'plain') return this.#ofSide(source.side);
    if (kind === 'foreign' && !this.#hasFailed(source)) {
      this.#fail(source, 'it is made for another renderer');
    }
    if (this.#hasFailed(source)) return this.#ofSide(source.side);
    let derived = this.#derived.get(source);
    if (derived !== undefined && (derived.wrap !== null) !== (kind === 'shader')) {
      // The user took a hook away, or gave it one.
      this.#drop(source);
      derived = undefined;
    }
    derived ??= this.#derive(source, kind === 'shader');
    derived.wrap?.follow();
    return derived.material;
  }

  #derive(source: Material, runsCode: boolean): Derived {
    const { sides } = this.#settings;
    const wrap = runsCode
      ? new WrappedMaterial(source, this.#renderer, {
          ...this.#settings,
          uniforms: this.#program.uniforms,
        })
      : null;
    const material = wrap?.material ?? createCutMaterial(source, sides, this.#program);
    const onDispose = () => this.#drop(source);
    source.addEventListener('dispose', onDispose);
    const release = () => source.removeEventListener('dispose', onDispose);
    const derived = { material, wrap, release };
    this.#derived.set(source, derived);
    return derived;
  }

  #drop(source: Material): void {
    const derived = this.#derived.get(source)!;
    this.#derived.delete(source);
    derived.release();
    derived.material.dispose();
  }

  /** A new version gets a second chance, but no third: an app may make a new one at every draw. */
  #hasFailed(source: Material): boolean {
    const failed = this.#failed.get(source);
    return failed !== undefined && (failed.version === source.version || failed.times > 1);
  }

  #fail(source: Material, reason: string): void {
    const times = (this.#failed.get(source)?.times ?? 0) + 1;
    this.#failed.set(source, { version: source.version, times });
    const name = source.name === '' ? '' : ` "${source.name}"`;
    this.#warnings.once(
      `${source.type}${name} cannot be drawn into the cubemap (${reason}); what wears it collides by its plain ` +
        `vertices.`,
      source.uuid,
    );
  }

  #ofSide(side: Side): ShaderMaterial {
    let material = this.#bySide.get(side);
    if (material === undefined) this.#bySide.set(side, (material = this.#create(side)));
    return material;
  }

  #create(side: Side): ShaderMaterial {
    const { output, sides } = this.#settings;
    const { vertexShader, fragmentShader, glslVersion, uniforms } = this.#program;
    const frontSign = frontSignOf(side, sides);
    return new ShaderMaterial({
      name: `CubeCollider ${output}`,
      vertexShader,
      fragmentShader,
      uniforms: {
        ...uniforms,
        // Set by each object's proxy before it is drawn.
        ...(output === 'axis' ? {} : { frontSign: { value: frontSign }, object: { value: 0 } }),
      },
      glslVersion,
      side: sides === 'both' ? DoubleSide : side,
      // Drawn twice otherwise, if a user's override ever made it transparent.
      forceSinglePass: true,
      blending: NoBlending,
      toneMapped: false,
      fog: false,
      lights: false,
      // The user's global planes cut the cubemap as they cut the picture.
      clipping: true,
    });
  }
}
