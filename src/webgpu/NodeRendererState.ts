import { context } from 'three/tsl';
import { Color, type WebGPURenderer } from 'three/webgpu';

type MRT = ReturnType<WebGPURenderer['getMRT']> | null;
type RenderObject = ReturnType<WebGPURenderer['getRenderObjectFunction']>;
type Target = ReturnType<WebGPURenderer['getRenderTarget']>;

/** Our own draws know nothing of what the user lets all materials know; always the same, as programs depend on it. */
const NO_CONTEXT = /* @__PURE__ */ context({});

/** What a draw of ours changes on the user's renderer, taken before and put back after. */
export class NodeRendererState {
  #target: Target = null;
  #face = 0;
  #mip = 0;
  #mrt: MRT = null;
  #renderObject: RenderObject = null;
  readonly #clearColor = new Color();
  #clearAlpha = 1;
  #autoClear = true;
  #autoClearColor = true;
  #autoClearDepth = true;
  #autoClearStencil = true;
  #opaque = true;
  #transparent = true;
  #sortObjects = true;
  #xr = false;
  #context: WebGPURenderer['contextNode'] | null = null;
  #inspecting: boolean | undefined;
  readonly #info = { frameCalls: 0, drawCalls: 0, triangles: 0, points: 0, lines: 0 };

  /** Takes the state and sets ours. */
  enter(renderer: WebGPURenderer): void {
    this.#target = renderer.getRenderTarget();
    this.#face = renderer.getActiveCubeFace();
    this.#mip = renderer.getActiveMipmapLevel();
    this.#mrt = renderer.getMRT();
    this.#renderObject = renderer.getRenderObjectFunction();
    renderer.getClearColor(this.#clearColor as never);
    this.#clearAlpha = renderer.getClearAlpha();
    this.#autoClear = renderer.autoClear;
    this.#autoClearColor = renderer.autoClearColor;
    this.#autoClearDepth = renderer.autoClearDepth;
    this.#autoClearStencil = renderer.autoClearStencil;
    this.#opaque = renderer.opaque;
    this.#transparent = renderer.transparent;
    this.#sortObjects = renderer.sortObjects;
    this.#xr = renderer.xr.enabled;
    this.#context = renderer.contextNode;
    const inspector = renderer.inspector as { enabled?: boolean } | undefined;
    this.#inspecting = inspector?.enabled;
    const { render } = renderer.info;
    const info = this.#info;
    info.frameCalls = render.frameCalls;
    info.drawCalls = render.drawCalls;
    info.triangles = render.triangles;
    info.points = render.points;
    info.lines = render.lines;

    renderer.setMRT(null as never);
    renderer.setRenderObjectFunction(null as never);
    renderer.setClearColor(0, 0);
    renderer.autoClear = true;
    renderer.autoClearColor = true;
    renderer.autoClearDepth = true;
    renderer.opaque = true;
    renderer.transparent = true;
    renderer.sortObjects = false;
    renderer.xr.enabled = false;
    renderer.contextNode = NO_CONTEXT as never;
    if (inspector !== undefined && this.#inspecting === true) inspector.enabled = false;
  }

  /** Puts everything back. `info.calls` and `info.render.calls` are left: three tells by them what is up to date. */
  leave(renderer: WebGPURenderer): void {
    const { render } = renderer.info;
    Object.assign(render, this.#info);
    renderer.contextNode = this.#context!;
    renderer.xr.enabled = this.#xr;
    renderer.sortObjects = this.#sortObjects;
    renderer.transparent = this.#transparent;
    renderer.opaque = this.#opaque;
    renderer.autoClearStencil = this.#autoClearStencil;
    renderer.autoClearDepth = this.#autoClearDepth;
    renderer.autoClearColor = this.#autoClearColor;
    renderer.autoClear = this.#autoClear;
    renderer.setClearColor(this.#clearColor, this.#clearAlpha);
    renderer.setRenderObjectFunction(this.#renderObject as never);
    renderer.setMRT(this.#mrt as never);
    const inspector = renderer.inspector as { enabled?: boolean } | undefined;
    if (inspector !== undefined && this.#inspecting === true) inspector.enabled = true;
    renderer.setRenderTarget(this.#target, this.#face, this.#mip);
    this.#target = this.#mrt = this.#renderObject = this.#context = null;
  }
}
