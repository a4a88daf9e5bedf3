import {
  BufferGeometry,
  Camera,
  CanvasTexture,
  Float32BufferAttribute,
  LinearFilter,
  Mesh,
  NoColorSpace,
  ShaderMaterial,
  Vector2,
  Vector3,
  Vector4,
  type WebGLRenderer,
} from 'three';
import type { CubeCollider } from '../collider/CubeCollider.js';
import { RendererState } from '../collider/RendererState.js';
import { drawLabels } from './drawLabels.js';
import { layOut } from './unfold.js';
import { unfoldFragmentShader, unfoldVertexShader } from './unfoldShader.js';

/** What the helper reads of a collider. */
export type ViewableCollider = Pick<
  CubeCollider,
  'renderTarget' | 'output' | 'format' | 'resolution' | 'stats' | 'rMin' | 'rMax' | 'maxima'
>;

/** Where the picture goes, and how large it is. */
export interface CubeColliderHelperOptions {
  /** Width of the picture, CSS pixels; its height follows. @default 220 */
  size?: number;
  /** Space to the edges of the canvas, CSS pixels. @default 12 */
  margin?: number;
  /** @default 'bottom-left' */
  corner?: 'top-left' | 'top-right' | 'bottom-left' | 'bottom-right';
}

const _drawing = /* @__PURE__ */ new Vector2();
const _viewport = /* @__PURE__ */ new Vector4();
const _scissor = /* @__PURE__ */ new Vector4();

/**
 * Shows what a collider sees, live: its six faces unfolded into a cross (see `unfold.ts`), bright where something is
 * near. In the paper's mode a ring marks the texel that each face's maximum comes from.
 *
 * It is drawn over the picture like three's `ViewHelper`, straight from the collider's render target: nothing is read
 * back for it.
 *
 * ```js
 * const helper = new CubeColliderHelper( collider );
 *
 * renderer.render( scene, camera );
 * helper.render( renderer );
 * ```
 */
export class CubeColliderHelper {
  /** Whether `render` draws. @default true */
  visible = true;
  /** Width of the picture, CSS pixels; its height follows. */
  size: number;
  /** Space to the edges of the canvas, CSS pixels. */
  margin: number;
  /** Corner of the canvas. */
  corner: NonNullable<CubeColliderHelperOptions['corner']>;

  readonly #uniforms = {
    atlas: { value: null as unknown },
    labels: { value: null as CanvasTexture | null },
    size: { value: new Vector2() },
    padding: { value: 0 },
    cell: { value: 0 },
    ramp: { value: new Vector4() },
    far: { value: 1 },
    resolution: { value: 1 },
    winners: { value: Array.from({ length: 6 }, () => new Vector3()) },
  };
  readonly #triangle: Mesh<BufferGeometry, ShaderMaterial>;
  readonly #camera = new Camera();
  readonly #state = new RendererState();
  /** What the shader and the labels were made for. */
  #programKey = '';
  #labelKey = '';

  /** @param collider what to show; may be exchanged at any time */
  constructor(
    public collider: ViewableCollider,
    { size = 220, margin = 12, corner = 'bottom-left' }: CubeColliderHelperOptions = {},
  ) {
    this.size = size;
    this.margin = margin;
    this.corner = corner;
    const geometry = new BufferGeometry();
    geometry.setAttribute(
      'position',
      new Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3),
    );
    const material = new ShaderMaterial({
      name: 'CubeColliderHelper',
      vertexShader: unfoldVertexShader,
      uniforms: this.#uniforms,
      transparent: true,
      depthTest: false,
      depthWrite: false,
      toneMapped: false,
    });
    this.#triangle = new Mesh(geometry, material);
    this.#triangle.frustumCulled = false;
    this.#triangle.matrixAutoUpdate = false;
  }

  /** Draws into a corner of the canvas, over what is there. Call it after your own render. */
  render(renderer: WebGLRenderer): void {
    const { collider } = this;
    const target = collider.renderTarget;
    if (!this.visible || target === null || renderer.xr.isPresenting) return;
    this.#prepare(renderer);
    const uniforms = this.#uniforms;
    uniforms.atlas.value = target.texture;
    uniforms.far.value = collider.stats.far;
    uniforms.resolution.value = collider.resolution;
    uniforms.winners.value.forEach((winner, face) => {
      const maxima = collider.output === 'axis' ? collider.maxima : null;
      if (maxima === null) winner.setScalar(0);
      else winner.set(maxima.texel[2 * face]!, maxima.texel[2 * face + 1]!, maxima.red[face]!);
    });

    const { x: width, y: height } = uniforms.size.value;
    renderer.getSize(_drawing);
    const left = this.corner.endsWith('left') ? this.margin : _drawing.x - this.margin - width;
    const bottom = this.corner.startsWith('bottom')
      ? this.margin
      : _drawing.y - this.margin - height;

    const scissorTest = renderer.getScissorTest();
    renderer.getViewport(_viewport);
    renderer.getScissor(_scissor);
    this.#state.enter(renderer);
    try {
      renderer.setRenderTarget(null);
      renderer.autoClear = false;
      renderer.setScissorTest(false);
      renderer.setViewport(left, bottom, width, height);
      renderer.render(this.#triangle, this.#camera);
    } finally {
      renderer.setViewport(_viewport);
      renderer.setScissor(_scissor);
      renderer.setScissorTest(scissorTest);
      this.#state.leave(renderer);
    }
  }

  /** Frees what it has on the GPU. */
  dispose(): void {
    this.#triangle.geometry.dispose();
    this.#triangle.material.dispose();
    this.#uniforms.labels.value?.dispose();
    this.#uniforms.labels.value = null;
    this.#labelKey = '';
  }

  /** Makes shader and labels anew where the collider, the size or the screen is another. */
  #prepare(renderer: WebGLRenderer): void {
    const { output, format, resolution, stats, rMin, rMax } = this.collider;
    const uniforms = this.#uniforms;
    const programKey = `${output} ${format}`;
    if (programKey !== this.#programKey) {
      this.#programKey = programKey;
      this.#triangle.material.fragmentShader = unfoldFragmentShader(output, format ?? 'RGBA8');
      this.#triangle.material.needsUpdate = true;
    }
    const pixelRatio = renderer.getPixelRatio();
    // The reach of what is in the atlas; a character may have asked for another since.
    const ends = (output === 'axis' ? [rMin, rMax] : [0, stats.far]).map(metres);
    const labelKey = [output, resolution, ...ends, this.size, pixelRatio].join(' ');
    if (labelKey === this.#labelKey) return;
    this.#labelKey = labelKey;

    const layout = layOut(this.size);
    uniforms.size.value.set(layout.width, layout.height);
    uniforms.padding.value = layout.padding;
    uniforms.cell.value = layout.cell;
    uniforms.ramp.value.fromArray(layout.ramp);
    const canvas = document.createElement('canvas');
    drawLabels(canvas, layout, pixelRatio, {
      title: output === 'axis' ? 'Six maxima' : 'Cubemap',
      detail: `6 × ${resolution}² texels`,
      near: `near ${ends[0]!}`,
      far: `far ${ends[1]!} m`,
    });
    uniforms.labels.value?.dispose();
    const texture = new CanvasTexture(canvas);
    texture.colorSpace = NoColorSpace;
    texture.premultiplyAlpha = true;
    texture.generateMipmaps = false;
    texture.minFilter = LinearFilter;
    uniforms.labels.value = texture;
  }
}

/** Two digits after the point at most. */
function metres(value: number): string {
  return String(Math.round(value * 100) / 100);
}
