import {
  BufferGeometry,
  OrthographicCamera,
  Float32BufferAttribute,
  GLSL3,
  Mesh,
  NoBlending,
  ShaderMaterial,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import { atlasSize } from '../cube/atlas.js';
import { decodeDistanceGLSL, hasIdTexture, type TexelFormat } from '../cube/encoding.js';
import { keepPlaceGLSL } from '../cube/finerTexel.js';
import { PrivateScene } from './PrivateScene.js';
import { createTexelTarget } from './texelTarget.js';

const vertexShader = /* glsl */ `
void main() {
  gl_Position = vec4( position.xy, 0.0, 1.0 );
}`;

/** For each texel of the atlas: the nearest of its block of finer ones, whole, with its place in the block. */
function nearestShader(format: TexelFormat): string {
  const beside = hasIdTexture(format);
  return /* glsl */ `
layout( location = 0 ) out highp vec4 texel;
${beside ? 'layout( location = 1 ) out highp uvec2 ids;' : 'uvec2 ids;'}
uniform sampler2D finer;
uniform int firstRow; // of those that it fills now
uniform highp usampler2D finerIds;
${decodeDistanceGLSL(format)}
${keepPlaceGLSL(format)}

void main() {
  ivec2 from = ( ivec2( gl_FragCoord.xy ) - ivec2( 0, firstRow ) ) * SUPERSAMPLE;
  texel = vec4( 0.0 );
  ids = uvec2( 0u );
  ivec2 place = ivec2( 0 );
  float nearest = 0.0;
  for ( int y = 0; y < SUPERSAMPLE; y ++ ) {
    for ( int x = 0; x < SUPERSAMPLE; x ++ ) {
      vec4 candidate = texelFetch( finer, from + ivec2( x, y ), 0 );
      float distance = decodeDistance( candidate, 1.0 ); // only compared
      if ( distance > 0.0 && ( nearest == 0.0 || distance < nearest ) ) {
        nearest = distance;
        texel = candidate;
        place = ivec2( x, y );
      }
    }
  }
  if ( nearest == 0.0 ) return;
  ${beside ? 'ids = texelFetch( finerIds, from + place, 0 ).rg;' : ''}
  keepPlace( texel, ids, place );
}`;
}

/**
 * Thin things: surfaces are drawn two or four times finer than they are read, and this pass keeps the nearest texel of
 * each block. What that texel holds comes along whole; where in the block it lay comes along too, so that its direction,
 * and with it its point, stays exact. The texels are never mixed: a mean of a pole and the wall behind is neither.
 *
 * An outline is missed only where it passes between the middles of the finer texels, which lie 2·z/(N·s) metres apart at
 * a depth of z along the face's axis (N = `resolution`, s = `supersample`). See docs/architecture.md, "Thin things".
 */
export class NearestPass {
  /** The atlas: what is read, and shown. */
  readonly result: WebGLRenderTarget;
  readonly #triangle: Mesh<BufferGeometry, ShaderMaterial>;
  readonly #scene = new PrivateScene();
  readonly #camera = new OrthographicCamera();
  /** Of what one reduction fills, and of one cubemap. */
  readonly #height: number;
  readonly #rows: number;

  /**
   * @param finer the atlas drawn at `supersample` times `resolution` texels per face edge
   * @param cubemaps how many `result` holds; `finer` may hold fewer
   */
  constructor(
    resolution: number,
    supersample: number,
    format: TexelFormat,
    finer: WebGLRenderTarget,
    cubemaps = 1,
  ) {
    const { width, height } = atlasSize(resolution, cubemaps);
    this.#height = finer.height / supersample;
    this.#rows = atlasSize(resolution).height;
    this.result = createTexelTarget(width, height, format, false, finer.textures.length > 1);
    const material = new ShaderMaterial({
      name: 'CubeCollider nearest',
      vertexShader,
      fragmentShader: nearestShader(format),
      defines: { SUPERSAMPLE: supersample },
      uniforms: {
        finer: { value: finer.textures[0] },
        finerIds: { value: finer.textures[1] ?? null },
        firstRow: { value: 0 },
      },
      glslVersion: GLSL3,
      depthTest: false,
      depthWrite: false,
      blending: NoBlending,
      toneMapped: false,
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute(
      'position',
      new Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3),
    );
    this.#triangle = new Mesh(geometry, material);
    this.#triangle.frustumCulled = false;
    this.#scene.add(this.#triangle);
  }

  /**
   * Fills `result` and leaves it the current target, ready to be read.
   *
   * @param first the cubemap from which on it is filled, with as many as are drawn finer
   */
  reduce(renderer: WebGLRenderer, first = 0): void {
    const { result } = this;
    const row = first * this.#rows;
    this.#triangle.material.uniforms.firstRow!.value = row;
    result.viewport.set(0, row, result.width, Math.min(this.#height, result.height - row));
    renderer.setRenderTarget(result);
    renderer.render(this.#scene, this.#camera);
  }

  /** The program ready before the first frame. */
  compile(renderer: WebGLRenderer): void {
    renderer.compile(this.#scene, this.#camera);
  }

  dispose(): void {
    this.result.dispose();
    this.#triangle.geometry.dispose();
    this.#triangle.material.dispose();
  }
}
