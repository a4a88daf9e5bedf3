import { type RenderTarget, Vector4, type WebGLRenderer } from 'three';

type ShaderErrorHandler = NonNullable<WebGLRenderer['debug']['onShaderError']>;

const current = new Vector4();

/**
 * What a draw of ours changes on the user's renderer, taken before and put back after.
 *
 * Tone mapping and colour space need nothing: three ignores them for a render target. The clear colour is never touched
 * (`PrivateScene`, `clearTexels`). Viewport and scissor come back with the canvas; where the user has a target bound
 * they may differ from that target's, and are kept here. Nothing here waits for the GPU but one question, for the
 * scissor box, asked only where a scissor test is on and its box cannot be known otherwise.
 */
export class RendererState {
  #target: RenderTarget | null = null;
  #face = 0;
  #mip = 0;
  readonly #viewport = new Vector4();
  readonly #scissor = new Vector4();
  #scissorTest = false;
  #keepsScissor = false;
  #xr = false;
  #autoClear = true;
  #sortObjects = true;
  #infoAutoReset = true;
  #calls = 0;
  #triangles = 0;
  #points = 0;
  #lines = 0;
  #checkShaderErrors = true;
  #onShaderError: ShaderErrorHandler | null = null;

  /**
   * Takes the state and sets ours: no automatic clear, no sorting, no XR, counters held.
   *
   * @param onShaderError told of programs that fail, instead of the console; left out, errors go where they went
   */
  enter(renderer: WebGLRenderer, onShaderError?: ShaderErrorHandler): void {
    this.#target = renderer.getRenderTarget();
    this.#face = renderer.getActiveCubeFace();
    this.#mip = renderer.getActiveMipmapLevel();
    renderer.getCurrentViewport(this.#viewport);
    const gl = renderer.getContext();
    this.#scissorTest = gl.isEnabled(gl.SCISSOR_TEST);
    this.#keepsScissor = this.#scissorTest && (this.#target !== null || hasBrokenScissor(renderer));
    if (this.#keepsScissor) this.#scissor.fromArray(gl.getParameter(gl.SCISSOR_BOX) as Int32Array);
    this.#xr = renderer.xr.enabled;
    this.#autoClear = renderer.autoClear;
    this.#sortObjects = renderer.sortObjects;
    const { info } = renderer;
    this.#infoAutoReset = info.autoReset;
    this.#calls = info.render.calls;
    this.#triangles = info.render.triangles;
    this.#points = info.render.points;
    this.#lines = info.render.lines;
    const { debug } = renderer;
    this.#checkShaderErrors = debug.checkShaderErrors;
    this.#onShaderError = debug.onShaderError;

    if (onShaderError !== undefined) {
      debug.checkShaderErrors = true;
      debug.onShaderError = onShaderError;
    }
    renderer.xr.enabled = false;
    renderer.autoClear = false;
    renderer.sortObjects = false;
    info.autoReset = false;
  }

  /** Puts everything back. `info.render.frame` is left: three's uploads are guarded by it. */
  leave(renderer: WebGLRenderer): void {
    const { debug, info } = renderer;
    debug.checkShaderErrors = this.#checkShaderErrors;
    debug.onShaderError = this.#onShaderError;
    this.#onShaderError = null;
    info.autoReset = this.#infoAutoReset;
    info.render.calls = this.#calls;
    info.render.triangles = this.#triangles;
    info.render.points = this.#points;
    info.render.lines = this.#lines;
    renderer.sortObjects = this.#sortObjects;
    renderer.autoClear = this.#autoClear;
    renderer.xr.enabled = this.#xr;
    renderer.setRenderTarget(this.#target as never, this.#face, this.#mip);
    if (!renderer.getCurrentViewport(current).equals(this.#viewport)) {
      if (this.#target === null) {
        // The pixel ratio is broken, and three rounds a viewport that is set but floors it when the canvas is bound.
        // Setting it once more makes it current again.
        renderer.setViewport(renderer.getViewport(current));
      } else {
        // The user called setViewport with a target bound, or XR drew the last eye: a viewport that is not the target's
        // own. Lent to it, it becomes current again.
        const { viewport } = this.#target;
        current.copy(viewport);
        viewport.copy(this.#viewport);
        renderer.setRenderTarget(this.#target as never, this.#face, this.#mip);
        viewport.copy(current);
      }
    }
    if (this.#target !== null) renderer.state.setScissorTest(this.#scissorTest);
    if (this.#keepsScissor) renderer.state.scissor(this.#scissor);
    this.#target = null;
  }
}

/** At such a pixel ratio three rounds a scissor box that is set, but floors it when the canvas is bound. */
function hasBrokenScissor(renderer: WebGLRenderer): boolean {
  const { x, y, z, w } = renderer.getScissor(current).multiplyScalar(renderer.getPixelRatio());
  return !(
    Number.isInteger(x) &&
    Number.isInteger(y) &&
    Number.isInteger(z) &&
    Number.isInteger(w)
  );
}
