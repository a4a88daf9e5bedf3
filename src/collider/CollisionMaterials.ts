import {
  BackSide,
  DoubleSide,
  GLSL3,
  type Material,
  NoBlending,
  ShaderMaterial,
  type Side,
} from 'three';
import type { TexelFormat } from '../cube/encoding.js';
import {
  axisFragmentShader,
  collisionVertexShader,
  surfaceFragmentShader,
} from './collisionShader.js';
import { isSolid } from './isSolid.js';

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

/**
 * The materials that scenery wears in the cubemap: one per side a source material shows, however many materials there
 * are. Those that change a surface's shape or coverage will be wrapped here (`for` is the one place that decides).
 */
export class CollisionMaterials {
  readonly #settings: CollisionMaterialSettings;
  readonly #bySide = new Map<Side, ShaderMaterial>();
  /** For groups that are no obstacle, or have no material. */
  readonly #nothing = new ShaderMaterial({ visible: false });
  readonly #arrays = new WeakMap<Material[], ShaderMaterial[]>();
  /** Shared by all: one value to set. */
  readonly #far: { value: number };

  constructor(settings: CollisionMaterialSettings) {
    this.#settings = settings;
    this.#far = { value: settings.far };
  }

  /** Reach, metres. */
  set far(far: number) {
    this.#far.value = far;
  }

  /** The collision material for a mesh's material, or one for each of several. */
  for(source: Material | Material[]): ShaderMaterial | ShaderMaterial[] {
    if (!Array.isArray(source)) return this.#ofSide(source.side);
    let materials = this.#arrays.get(source);
    if (materials === undefined) this.#arrays.set(source, (materials = []));
    materials.length = source.length;
    for (let i = 0; i < source.length; i++) {
      const material = source[i];
      materials[i] = isSolid(material) ? this.#ofSide(material!.side) : this.#nothing;
    }
    return materials;
  }

  dispose(): void {
    for (const material of this.#bySide.values()) material.dispose();
    this.#bySide.clear();
    this.#nothing.dispose();
  }

  #ofSide(side: Side): ShaderMaterial {
    let material = this.#bySide.get(side);
    if (material === undefined) this.#bySide.set(side, (material = this.#create(side)));
    return material;
  }

  #create(side: Side): ShaderMaterial {
    const { output, sides, format, resolution, near, rMin, rMax } = this.#settings;
    const axis = output === 'axis';
    // Culled as a BackSide material, three turns the facing round itself.
    const frontSign = sides === 'both' && side === BackSide ? -1 : 1;
    return new ShaderMaterial({
      name: `CubeCollider ${output}`,
      vertexShader: collisionVertexShader,
      fragmentShader: axis ? axisFragmentShader : surfaceFragmentShader(format),
      uniforms: {
        resolution: { value: resolution },
        near: { value: near },
        ...(axis
          ? { rMin: { value: rMin }, rMax: { value: rMax } }
          : {
              far: this.#far,
              frontSign: { value: frontSign },
              // Set by each object's proxy before it is drawn.
              object: { value: 0 },
            }),
      },
      glslVersion: axis ? null : GLSL3,
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
