import {
  ArrayCamera,
  type Camera,
  Color,
  DirectionalLight,
  Mesh,
  PCFShadowMap,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  type SkinnedMesh,
  SphereGeometry,
  TorusKnotGeometry,
  Vector2,
  Vector3,
  Vector4,
} from 'three';
import { context, mrt, output, pass, reflector, uniform, vec4, velocity } from 'three/tsl';
import {
  type ContextNode,
  MeshPhysicalNodeMaterial,
  MeshStandardNodeMaterial,
  type Node,
  RenderPipeline,
  RenderTarget,
  type WebGPURenderer,
} from 'three/webgpu';
import type { CubeCollider } from 'three-cube-collider';
import type { Kind } from '../support/kinds/Kind.js';
import { deformedKinds } from '../support/kinds/deformedKinds.js';
import { type Backend, createRendering, type Rendering } from '../support/rendering.js';

export interface NodesUntouchedReport {
  /** Bytes of the user's pictures, how many differ with and without a collider, and how many show something. */
  bytes: number;
  differing: number;
  shown: number;
  /** Bytes that differ from frame to frame: the pictures show what moves. */
  moving: number;
  /** State of the renderer that an update changed, and how much was compared. */
  changed: string[];
  compared: number;
  /** Objects of the collider that came through the user's own function, and mirrors drawn for it. */
  intercepted: number;
  mirrored: number;
  /** Of the collider itself. */
  reads: number;
  /** How far off the floor below is seen, metres. */
  floor: number;
  warnings: string[];
}

const SIZE = 48;

/** A frame with shadows, glass, a mirror, a skin, a pipeline of passes with several outputs, and two eyes. */
class UserApp {
  readonly renderer: WebGPURenderer;
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(60, 1, 0.1, 50);
  readonly eyes: ArrayCamera;
  readonly target = new RenderTarget(SIZE, SIZE);
  readonly pipeline: RenderPipeline;
  readonly pane = new Mesh(new PlaneGeometry(2, 1.5), new MeshStandardNodeMaterial());
  readonly wave = uniform(0);
  readonly skin: Kind;
  /** Objects drawn by way of `setRenderObjectFunction`, by their materials' names. */
  readonly drawn: string[] = [];
  /** Draws of the mirror's own picture. */
  mirrored = 0;

  constructor(
    readonly rendering: Rendering,
    skin: Kind,
  ) {
    const { scene, camera } = this;
    const renderer = (this.renderer = rendering.renderer as unknown as WebGPURenderer);
    this.skin = skin;
    renderer.setPixelRatio(1.5);
    renderer.setSize(33, 31);
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = PCFShadowMap;
    renderer.setClearColor(0x3366aa, 0.75);
    // Darker, for all materials: it would spoil distances.
    renderer.contextNode = context({
      getOutput: (node: Node<'vec4'>) => node.mul(vec4(0.5, 0.5, 0.5, 1)),
    } as never) as ContextNode<unknown> as never;
    renderer.highPrecision = true;
    scene.background = new Color(0x334455);
    scene.environmentIntensity = 0.5;
    const floor = new Mesh(new PlaneGeometry(8, 8), new MeshStandardNodeMaterial());
    floor.rotation.x = -Math.PI / 2;
    floor.receiveShadow = true;
    const knot = new Mesh(new TorusKnotGeometry(0.4, 0.15, 40, 8), new MeshStandardNodeMaterial());
    knot.material.colorNode = vec4(0.8, 0.4, 0.2, 1).mul(this.wave.add(0.5));
    knot.position.set(-1, 0.8, 0);
    knot.castShadow = knot.receiveShadow = true;
    const glass = new Mesh(
      new SphereGeometry(0.5, 16, 12),
      new MeshPhysicalNodeMaterial({ transmission: 0.7, roughness: 0.1 }),
    );
    glass.position.set(0.9, 0.7, 0.5);
    const mirror = reflector({ resolutionScale: 0.5 });
    const { pane } = this;
    pane.material.colorNode = mirror as unknown as Node<'vec4'>;
    pane.add(mirror.target);
    pane.position.set(0, 0.8, -1.5);
    skin.object.position.set(0.1, 0.6, 0.9);
    skin.object.traverse((object) => (object.castShadow = true));
    const sun = new DirectionalLight(0xffffff, 3);
    sun.position.set(2, 5, 3);
    sun.castShadow = true;
    scene.add(floor, knot, glass, pane, skin.object, sun);
    scene.onBeforeRender = (() => {
      if (scene.name.includes('Reflector')) this.mirrored++;
    }) as never;
    camera.position.set(0.5, 1.8, 4.5);
    camera.lookAt(0, 0.6, 0);
    this.eyes = new ArrayCamera(
      [0, 1].map((i) => {
        const eye = new PerspectiveCamera(50, 0.5, 0.1, 20);
        eye.position.set(i - 0.5, 1.5, 4);
        eye.lookAt(0, 0.6, 0);
        eye.viewport = new Vector4((i * SIZE) / 2, 0, SIZE / 2, SIZE);
        eye.updateMatrixWorld();
        return eye;
      }),
    );
    const view = pass(scene, camera);
    view.setMRT(mrt({ output, velocity }));
    this.pipeline = new RenderPipeline(renderer);
    this.pipeline.outputNode = view
      .getTextureNode('output')
      .add(view.getTextureNode('velocity').mul(20));
    const { renderObject } = renderer as unknown as { renderObject: (...all: unknown[]) => void };
    renderer.setRenderObjectFunction(((...all: unknown[]) => {
      this.drawn.push((all[4] as { name: string }).name);
      renderObject.apply(renderer, all);
    }) as never);
  }

  /** What the user does between the collider's update and the picture. */
  pose(i: number): void {
    if (i > 0) this.skin.change();
    this.wave.value = 0.2 * i;
    this.scene.children[1]!.rotation.y = 0.3 * i;
  }

  /** The pipeline into a target, the two eyes beside it, and all of it onto the page's canvas. */
  async frame(): Promise<Uint8Array> {
    const { renderer, target, scene, pipeline } = this;
    const parts: Uint8Array[] = [];
    const read = async () =>
      parts.push((await renderer.readRenderTargetPixelsAsync(target, 0, 0, SIZE, SIZE)) as never);
    renderer.setRenderTarget(target);
    pipeline.render();
    renderer.setRenderTarget(null);
    pipeline.render();
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = SIZE;
    const page = canvas.getContext('2d')!;
    page.drawImage(renderer.domElement, 0, 0, SIZE, SIZE);
    parts.push(new Uint8Array(page.getImageData(0, 0, SIZE, SIZE).data));
    await read();
    renderer.setRenderTarget(target);
    renderer.autoClear = false;
    renderer.clear();
    // three's mirrors know nothing of several eyes.
    this.pane.visible = false;
    renderer.render(scene, this.eyes as Camera);
    this.pane.visible = true;
    renderer.autoClear = true;
    renderer.setRenderTarget(null);
    await read();
    const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
    let at = 0;
    for (const part of parts) {
      all.set(part, at);
      at += part.length;
    }
    return all;
  }

  /** By name; objects are compared by identity through `identify`. */
  state(identify: (object: unknown) => number): Record<string, string> {
    const { renderer, scene } = this;
    const inner = renderer as unknown as {
      getOutputRenderTarget(): unknown;
      getCanvasTarget(): unknown;
      lighting: unknown;
      drawingPipeline: unknown;
      library: unknown;
      inspector: { enabled?: boolean };
      _currentRenderContext: unknown;
      _currentRenderObjectFunction: unknown;
      _handleObjectFunction: unknown;
      _callDepth: number;
      _nodes: { nodeFrame: { frameId: number; time: number } };
    };
    const { info, shadowMap, xr } = renderer;
    // Its `calls` go on: three tells by them what is up to date.
    const render = { ...info.render, calls: 0 };
    const state = {
      renderTarget: identify(renderer.getRenderTarget()),
      outputRenderTarget: identify(inner.getOutputRenderTarget()),
      canvasTarget: identify(inner.getCanvasTarget()),
      face: renderer.getActiveCubeFace(),
      mip: renderer.getActiveMipmapLevel(),
      mrt: identify(renderer.getMRT()),
      renderObjectFunction: identify(renderer.getRenderObjectFunction()),
      clear: [
        ...renderer
          .getClearColor(new Color() as never)
          .toArray()
          .slice(0, 3),
        renderer.getClearAlpha(),
        renderer.getClearDepth(),
        renderer.getClearStencil(),
      ],
      autoClear: [
        renderer.autoClear,
        renderer.autoClearColor,
        renderer.autoClearDepth,
        renderer.autoClearStencil,
      ],
      drawn: [renderer.sortObjects, renderer.opaque, renderer.transparent],
      viewport: renderer.getViewport(new Vector4()).toArray(),
      scissor: renderer.getScissor(new Vector4()).toArray(),
      scissorTest: renderer.getScissorTest(),
      size: [...renderer.getDrawingBufferSize(new Vector2()), renderer.getPixelRatio()],
      tones: [renderer.toneMapping, renderer.toneMappingExposure, renderer.outputColorSpace],
      context: [identify(renderer.contextNode), renderer.contextNode.version],
      contextValue: Object.entries(renderer.contextNode.value as object).map(
        ([name, value]) => `${name} ${identify(value)}`,
      ),
      highPrecision: renderer.highPrecision,
      shadowMap: [shadowMap.enabled, shadowMap.type],
      xr: [xr.enabled, xr.isPresenting],
      parts: [inner.lighting, inner.drawingPipeline, inner.library, inner.inspector].map(identify),
      inspecting: inner.inspector?.enabled,
      within: [
        inner._currentRenderContext,
        inner._currentRenderObjectFunction,
        inner._handleObjectFunction,
      ].map(identify),
      depth: inner._callDepth,
      frame: inner._nodes.nodeFrame.frameId,
      time: inner._nodes.nodeFrame.time,
      info: [info.autoReset, info.frame, info.compute.calls, JSON.stringify(render)],
      scene: [scene.background, scene.environment, scene.overrideMaterial, scene.fog].map(identify),
      family: scene.children.map((child) => [
        identify(child.parent),
        identify((child as Mesh).material),
        child.layers.mask,
        child.children.length,
        ((child as Mesh).material as { version?: number } | undefined)?.version,
        Object.keys(child).length,
      ]),
      skeleton: this.#bones(),
    };
    return Object.fromEntries(
      Object.entries(state).map(([name, value]) => [name, JSON.stringify(value) ?? '']),
    );
  }

  #bones(): number[] {
    const [{ mesh }] = this.skin.shown() as [{ mesh: SkinnedMesh }];
    return [...mesh.skeleton.boneMatrices!.slice(16, 32)];
  }
}

/** The same frames of an app with a collider and of one without, compared byte by byte. */
export default async function nodesUntouched({
  backend,
}: {
  backend: Backend;
}): Promise<NodesUntouchedReport> {
  const warnings: string[] = [];
  const { warn } = console;
  console.warn = (...words: unknown[]) => warnings.push(words.join(' '));
  const identities: unknown[] = [];
  const identify = (object: unknown) => {
    if (!identities.includes(object)) identities.push(object);
    return identities.indexOf(object);
  };
  const create = async () =>
    new UserApp(
      await createRendering(backend),
      await deformedKinds['SkinnedMesh, attached']!(null as never, null),
    );
  const [alone, beside] = [await create(), await create()];
  const collider = beside.rendering.collider({ far: 3 });
  collider.position.set(0.3, 1, 0.2);
  const report: NodesUntouchedReport = {
    bytes: 0,
    differing: 0,
    shown: 0,
    moving: 0,
    changed: [],
    compared: 0,
    intercepted: 0,
    mirrored: 0,
    reads: 0,
    floor: Infinity,
    warnings,
  };
  let before: Uint8Array | null = null;
  for (let i = 0; i < 4; i++) {
    const theirs = await inLoop(alone, () => {
      alone.pose(i);
      return alone.frame();
    });
    const mine = await inLoop(beside, () => {
      updateWatched(beside, collider, i, identify, report);
      beside.pose(i);
      return beside.frame();
    });
    report.bytes += theirs.length;
    for (let k = 0; k < theirs.length; k++) {
      if (theirs[k] !== mine[k]) report.differing++;
      if (theirs[k] !== theirs[k % 4]) report.shown++;
      if (before !== null && before[k] !== theirs[k]) report.moving++;
    }
    before = theirs;
  }
  // In as many frames the mirror is drawn as often, for the user's own pictures alone.
  report.mirrored = beside.mirrored - alone.mirrored;
  report.intercepted = beside.drawn.filter((name) => name.startsWith('CubeCollider')).length;
  await collider.updateAsync(beside.renderer as never, beside.scene);
  report.reads = collider.stats.reads;
  const field = collider.field!;
  for (let i = 0; i < field.count; i++) {
    const down = new Vector3().fromArray(field.direction, 3 * i).normalize().y;
    if (down < -0.99)
      report.floor = Math.min(report.floor, Math.abs(field.distance[i]! + 1 / down));
  }
  collider.dispose();
  for (const app of [alone, beside]) app.renderer.dispose();
  console.warn = warn;
  return report;
}

/** Within a frame as three counts them. */
function inLoop<T>({ renderer }: UserApp, work: () => Promise<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    void renderer.setAnimationLoop(() => {
      void renderer.setAnimationLoop(null);
      Promise.resolve().then(work).then(resolve, reject);
    });
  });
}

/** An update under whatever state the user may have left, which must be the same afterwards. */
function updateWatched(
  app: UserApp,
  collider: CubeCollider,
  i: number,
  identify: (object: unknown) => number,
  report: NodesUntouchedReport,
): void {
  const { renderer } = app;
  const odd = i % 2 === 1;
  if (odd) {
    renderer.setRenderTarget(app.target);
    renderer.setMRT(mrt({ output }) as never);
    renderer.autoClear = renderer.autoClearDepth = renderer.sortObjects = false;
    renderer.opaque = false;
    renderer.info.autoReset = false;
    renderer.setScissorTest(true);
    renderer.setScissor(3, 4, 20, 10);
    renderer.setViewport(5, 6, 10, 12);
  }
  const before = app.state(identify);
  collider.update(renderer as never, app.scene);
  const after = app.state(identify);
  for (const name in before) {
    report.compared++;
    if (before[name] !== after[name]) {
      report.changed.push(`${name}: ${before[name]} -> ${after[name]}`);
    }
  }
  if (!odd) return;
  renderer.setRenderTarget(null);
  renderer.setMRT(null as never);
  renderer.autoClear = renderer.autoClearDepth = renderer.sortObjects = true;
  renderer.opaque = true;
  renderer.info.autoReset = true;
  renderer.setScissorTest(false);
  renderer.setViewport(0, 0, 33, 31);
}
