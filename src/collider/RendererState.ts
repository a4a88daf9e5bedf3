import { Color, type RenderTarget, type WebGLRenderer } from 'three';

/**
 * What a draw of ours changes on the user's renderer, taken before and put back after. Viewport, scissor, tone mapping
 * and colour space need nothing: three restores them with the render target or ignores them for one.
 */
export class RendererState {
  #target: RenderTarget | null = null;
  #face = 0;
  #mip = 0;
  #xr = false;
  readonly #clearColor = new Color();
  #clearAlpha = 0;
  #autoClear = true;
  #autoClearColor = true;
  #autoClearDepth = true;
  #autoClearStencil = true;
  #sortObjects = true;
  #infoAutoReset = true;
  #calls = 0;
  #triangles = 0;
  #points = 0;
  #lines = 0;

  /** Takes the state and sets ours: black, transparent, cleared, unsorted, no XR, counters held. */
  enter(renderer: WebGLRenderer): void {
    this.#target = renderer.getRenderTarget();
    this.#face = renderer.getActiveCubeFace();
    this.#mip = renderer.getActiveMipmapLevel();
    this.#xr = renderer.xr.enabled;
    renderer.getClearColor(this.#clearColor);
    this.#clearAlpha = renderer.getClearAlpha();
    this.#autoClear = renderer.autoClear;
    this.#autoClearColor = renderer.autoClearColor;
    this.#autoClearDepth = renderer.autoClearDepth;
    this.#autoClearStencil = renderer.autoClearStencil;
    this.#sortObjects = renderer.sortObjects;
    const { info } = renderer;
    this.#infoAutoReset = info.autoReset;
    this.#calls = info.render.calls;
    this.#triangles = info.render.triangles;
    this.#points = info.render.points;
    this.#lines = info.render.lines;

    renderer.xr.enabled = false;
    renderer.setClearColor(0x000000, 0);
    renderer.autoClear = true;
    renderer.autoClearColor = true;
    renderer.autoClearDepth = true;
    renderer.autoClearStencil = true;
    renderer.sortObjects = false;
    info.autoReset = false;
  }

  /** Puts everything back. `info.render.frame` is left: three's uploads are guarded by it. */
  leave(renderer: WebGLRenderer): void {
    const { info } = renderer;
    info.autoReset = this.#infoAutoReset;
    info.render.calls = this.#calls;
    info.render.triangles = this.#triangles;
    info.render.points = this.#points;
    info.render.lines = this.#lines;
    renderer.sortObjects = this.#sortObjects;
    renderer.autoClear = this.#autoClear;
    renderer.autoClearColor = this.#autoClearColor;
    renderer.autoClearDepth = this.#autoClearDepth;
    renderer.autoClearStencil = this.#autoClearStencil;
    renderer.setClearColor(this.#clearColor, this.#clearAlpha);
    renderer.xr.enabled = this.#xr;
    // Last: it reloads the target's viewport and scissor.
    renderer.setRenderTarget(this.#target as never, this.#face, this.#mip);
    this.#target = null;
  }
}
