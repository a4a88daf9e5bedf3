import { float, Fn, If, int, ivec2, screenCoordinate, textureLoad, vec4 } from 'three/tsl';
import {
  NoBlending,
  type Node,
  NodeMaterial,
  QuadMesh,
  type RenderTarget,
  type WebGPURenderer,
} from 'three/webgpu';
import { atlasSize } from '../cube/atlas.js';
import { PLACES } from '../cube/finerTexel.js';
import { createFloatTarget } from './texelTargets.js';

/**
 * Makes of the drawn atlas the one that is read, in the order in which the decoder reads it (bottom row first): of each
 * block of finer texels the nearest, whole, with its place in the block. See `NearestPass`, which does it for WebGL.
 */
export class NearestQuad {
  /** The atlas: what is read, and shown. */
  readonly result: RenderTarget;
  readonly #quad: QuadMesh;
  readonly #material = new NodeMaterial();

  /**
   * @param drawn its rows count downward, and so do those of each tile
   * @param upward whether a target's rows are read in the order in which shaders count them, or the other way round
   */
  constructor(resolution: number, supersample: number, drawn: RenderTarget, upward: boolean) {
    const { width, height } = atlasSize(resolution);
    this.result = createFloatTarget(width, height, false);
    const material = this.#material;
    material.name = 'CubeCollider nearest';
    material.lights = material.fog = material.toneMapped = false;
    material.depthTest = material.depthWrite = false;
    material.blending = NoBlending;
    material.fragmentNode = nearest(resolution, supersample, drawn, upward) as never;
    this.#quad = new QuadMesh(material);
  }

  /** Fills `result` and leaves it the current target. */
  reduce(renderer: WebGPURenderer): void {
    renderer.setRenderTarget(this.result);
    this.#quad.render(renderer);
  }

  dispose(): void {
    this.result.dispose();
    this.#material.dispose();
  }
}

function nearest(
  resolution: number,
  supersample: number,
  { texture: drawn }: RenderTarget,
  upward: boolean,
): Node<'vec4'> {
  const rows = 2 * resolution;
  return Fn(() => {
    const column = int(screenCoordinate.x).mul(supersample).toVar();
    const own = int(screenCoordinate.y);
    const row = (upward ? own : int(rows - 1).sub(own)).toVar();
    const tile = row.div(resolution).toVar();
    // The block's lowest row, counted downward within its tile.
    const fine = resolution * supersample;
    const bottom = tile
      .add(1)
      .mul(fine)
      .sub(row.sub(tile.mul(resolution)).mul(supersample))
      .sub(1)
      .toVar();
    const texel = vec4(0).toVar();
    const place = float(0).toVar();
    for (let y = 0; y < supersample; y++) {
      for (let x = 0; x < supersample; x++) {
        const candidate = textureLoad(drawn, ivec2(column.add(x), bottom.sub(y)), int(0)).toVar();
        const seen = candidate.x.greaterThan(0);
        If(seen.and(texel.x.equal(0).or(candidate.x.lessThan(texel.x))), () => {
          texel.assign(candidate);
          place.assign(x + 4 * y);
        });
      }
    }
    if (supersample === 1) return texel;
    const amount = texel.z.abs().min(65537).mul(PLACES).add(place);
    const kept = texel.z.lessThan(0).select(amount.negate(), amount);
    return vec4(texel.xy, texel.x.greaterThan(0).select(kept, float(0)), texel.w);
  })() as Node<'vec4'>;
}
