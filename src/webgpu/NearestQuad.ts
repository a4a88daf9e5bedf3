import { float, Fn, If, int, ivec2, screenCoordinate, textureLoad, uniform, vec4 } from 'three/tsl';
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
  /** Of what one reduction fills, and of one cubemap. */
  readonly #height: number;
  readonly #rows: number;
  readonly #upward: boolean;
  readonly #firstRow = uniform(0, 'int');

  /**
   * @param drawn its rows count downward, and so do those of each tile
   * @param cubemaps how many `result` holds; `drawn` may hold fewer
   * @param upward whether a target's rows are read in the order in which shaders count them, or the other way round
   */
  constructor(
    resolution: number,
    supersample: number,
    drawn: RenderTarget,
    cubemaps: number,
    upward: boolean,
  ) {
    const { width, height } = atlasSize(resolution, cubemaps);
    this.result = createFloatTarget(width, height, false);
    this.#height = drawn.height / supersample;
    this.#rows = atlasSize(resolution).height;
    this.#upward = upward;
    const material = this.#material;
    material.name = 'CubeCollider nearest';
    material.lights = material.fog = material.toneMapped = false;
    material.depthTest = material.depthWrite = false;
    material.blending = NoBlending;
    const own = int(screenCoordinate.y);
    const row = (upward ? own : int(height - 1).sub(own)).sub(this.#firstRow);
    material.fragmentNode = nearest(resolution, supersample, drawn, row) as never;
    this.#quad = new QuadMesh(material);
  }

  /**
   * Fills `result` and leaves it the current target.
   *
   * @param first the cubemap from which on it is filled, with as many as were drawn
   */
  reduce(renderer: WebGPURenderer, first = 0): void {
    const { result } = this;
    const row = first * this.#rows;
    const height = Math.min(this.#height, result.height - row);
    this.#firstRow.value = row;
    result.viewport.set(0, this.#upward ? row : result.height - row - height, result.width, height);
    // Whatever is beside the viewport stays.
    renderer.autoClear = first === 0;
    renderer.setRenderTarget(result);
    this.#quad.render(renderer);
  }

  dispose(): void {
    this.result.dispose();
    this.#material.dispose();
  }
}

/** @param place the row of those filled now, in the order in which they are read */
function nearest(
  resolution: number,
  supersample: number,
  { texture: drawn }: RenderTarget,
  place: Node<'int'>,
): Node<'vec4'> {
  return Fn(() => {
    const column = int(screenCoordinate.x).mul(supersample).toVar();
    const row = place.toVar();
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
    const finer = float(0).toVar();
    for (let y = 0; y < supersample; y++) {
      for (let x = 0; x < supersample; x++) {
        const candidate = textureLoad(drawn, ivec2(column.add(x), bottom.sub(y)), int(0)).toVar();
        const seen = candidate.x.greaterThan(0);
        If(seen.and(texel.x.equal(0).or(candidate.x.lessThan(texel.x))), () => {
          texel.assign(candidate);
          finer.assign(x + 4 * y);
        });
      }
    }
    if (supersample === 1) return texel;
    const amount = texel.z.abs().min(65537).mul(PLACES).add(finer);
    const kept = texel.z.lessThan(0).select(amount.negate(), amount);
    return vec4(texel.xy, texel.x.greaterThan(0).select(kept, float(0)), texel.w);
  })() as Node<'vec4'>;
}
