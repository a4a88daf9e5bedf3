import {
  BoxGeometry,
  Color,
  CubeTexture,
  DirectionalLight,
  FogExp2,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  OrthographicCamera,
  PerspectiveCamera,
  Plane,
  PlaneGeometry,
  PointLight,
  Scene,
  SphereGeometry,
  Vector3,
  Vector4,
  WebGLRenderer,
  WebGLRenderTarget,
  Vector2,
  MeshPhysicalMaterial,
} from 'three';
import { CubeCollider, type CubeColliderOptions } from 'three-cube-collider';

export interface UntouchedReport {
  /** Pixels compared and, of these, how many bytes differ between a frame with and one without a probe before it. */
  bytes: number;
  differing: number;
  /** Bytes that are not the background's: the picture shows something. */
  drawn: number;
  /** Names of renderer, GL or info state that the probe changed. */
  changed: string[];
  /** Names of state compared. */
  compared: number;
  /** True if the user's objects kept parent, material and layers. */
  objectsKept: boolean;
}

/** A user's frame with shadows, fog, a background, clipping, transmission and a post-processing target. */
class UserApp {
  readonly renderer = new WebGLRenderer({ antialias: true });
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(60, 1, 0.1, 50);
  readonly post = new WebGLRenderTarget(96, 96, { samples: 4 });
  readonly #screen = new Scene();
  readonly #screenCamera = new OrthographicCamera();

  constructor() {
    const { renderer, scene, camera } = this;
    // At this ratio three rounds the viewport when it is set, and floors it when the canvas is bound.
    renderer.setPixelRatio(1.5);
    renderer.setSize(97, 95);
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.autoUpdate = false;
    renderer.shadowMap.needsUpdate = true;
    renderer.setClearColor(0x3366aa, 0.75);
    renderer.clippingPlanes = [new Plane(new Vector3(0, -1, 0.2).normalize(), 1.7)];
    renderer.localClippingEnabled = true;
    renderer.toneMappingExposure = 1.3;
    scene.fog = new FogExp2(0x8899aa, 0.08);
    scene.background = new CubeTexture(
      Array.from({ length: 6 }, (_, i) => flatCanvas(new Color().setHSL(i / 6, 0.5, 0.5))),
    );
    scene.background.needsUpdate = true;
    const floor = new Mesh(new PlaneGeometry(8, 8), new MeshStandardMaterial({ color: 0x998877 }));
    floor.rotation.x = -Math.PI / 2;
    floor.receiveShadow = true;
    scene.add(floor);
    const shapes = [
      new BoxGeometry(),
      new SphereGeometry(0.6, 24, 16),
      new BoxGeometry(0.5, 2, 0.5),
    ];
    shapes.forEach((geometry, i) => {
      const material =
        i === 1
          ? new MeshPhysicalMaterial({ transmission: 0.6, roughness: 0.2 })
          : new MeshStandardMaterial({ color: new Color().setHSL(i / 3, 0.8, 0.5) });
      if (i === 2) material.clippingPlanes = [new Plane(new Vector3(-1, 0, 0), 1.6)];
      const mesh = new Mesh(geometry, material);
      mesh.position.set(1.4 * (i - 1), 0.8, -0.4 * i);
      mesh.castShadow = mesh.receiveShadow = true;
      scene.add(mesh);
    });
    const glass = new Mesh(
      new PlaneGeometry(1, 1),
      new MeshBasicMaterial({ color: 0xff8844, transparent: true, opacity: 0.4 }),
    );
    glass.position.set(0, 1, 1.4);
    scene.add(glass);
    const sun = new DirectionalLight(0xffffff, 3);
    sun.position.set(2, 5, 3);
    sun.castShadow = true;
    const lamp = new PointLight(0xffaa66, 8);
    lamp.position.set(-1, 2, 1);
    lamp.castShadow = true;
    scene.add(sun, lamp);
    camera.position.set(0.5, 1.8, 4.5);
    camera.lookAt(0, 0.6, 0);
    this.#screen.add(
      new Mesh(new PlaneGeometry(2, 2), new MeshBasicMaterial({ map: this.post.texture })),
    );
  }

  /** Scene into the post target, then the target onto the canvas; returns the pixels of both. */
  frame(): Uint8Array {
    const { renderer } = this;
    renderer.setRenderTarget(this.post);
    renderer.render(this.scene, this.camera);
    renderer.setRenderTarget(null);
    renderer.autoClear = false;
    renderer.clear();
    renderer.render(this.#screen, this.#screenCamera);
    renderer.autoClear = true;
    const { width, height } = renderer.domElement;
    const canvas = new Uint8Array(4 * width * height);
    const gl = renderer.getContext();
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, canvas);
    const resolved = document.createElement('canvas');
    resolved.width = resolved.height = 96;
    const context = resolved.getContext('2d')!;
    context.drawImage(renderer.domElement, 0, 0, 96, 96);
    const page = context.getImageData(0, 0, 96, 96).data;
    const all = new Uint8Array(canvas.length + page.length);
    all.set(canvas);
    all.set(page, canvas.length);
    return all;
  }

  /** Renderer, GL and counter state, by name. Objects are compared by identity through `identify`. */
  state(identify: (object: unknown) => number): Record<string, string> {
    const { renderer } = this;
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const names = [
      'VIEWPORT', 'SCISSOR_BOX', 'SCISSOR_TEST', 'COLOR_CLEAR_VALUE', 'DEPTH_CLEAR_VALUE', 'STENCIL_CLEAR_VALUE',
      'COLOR_WRITEMASK', 'DEPTH_WRITEMASK', 'DRAW_FRAMEBUFFER_BINDING', 'READ_FRAMEBUFFER_BINDING',
      'READ_BUFFER', 'DRAW_BUFFER0', 'DRAW_BUFFER1',
      'PIXEL_PACK_BUFFER_BINDING', 'PIXEL_UNPACK_BUFFER_BINDING', 'PACK_ALIGNMENT', 'PACK_ROW_LENGTH',
      'UNPACK_ALIGNMENT', 'UNPACK_FLIP_Y_WEBGL', 'UNPACK_PREMULTIPLY_ALPHA_WEBGL', 'RASTERIZER_DISCARD',
    ] as const; // prettier-ignore
    const state: Record<string, string> = {};
    for (const name of names) {
      const value: unknown = gl.getParameter(gl[name]);
      const plain =
        value === null ||
        typeof value !== 'object' ||
        ArrayBuffer.isView(value) ||
        Array.isArray(value);
      state[`gl.${name}`] = plain ? String(value) : `object ${identify(value)}`;
    }
    const { info, shadowMap, xr } = renderer;
    Object.assign(state, {
      renderTarget: `object ${identify(renderer.getRenderTarget())}`,
      face: renderer.getActiveCubeFace(),
      mip: renderer.getActiveMipmapLevel(),
      clearColor: renderer.getClearColor(new Color()).getHexString(),
      clearAlpha: renderer.getClearAlpha(),
      autoClear: [
        renderer.autoClear,
        renderer.autoClearColor,
        renderer.autoClearDepth,
        renderer.autoClearStencil,
      ],
      sortObjects: renderer.sortObjects,
      viewport: renderer.getViewport(new Vector4()).toArray(),
      currentViewport: renderer.getCurrentViewport(new Vector4()).toArray(),
      scissor: renderer.getScissor(new Vector4()).toArray(),
      scissorTest: renderer.getScissorTest(),
      size: renderer.getDrawingBufferSize(new Vector2()).toArray(),
      toneMapping: [renderer.toneMapping, renderer.toneMappingExposure, renderer.outputColorSpace],
      shadowMap: [shadowMap.enabled, shadowMap.autoUpdate, shadowMap.needsUpdate, shadowMap.type],
      clipping: [renderer.clippingPlanes.length, renderer.localClippingEnabled],
      xr: [xr.enabled, xr.isPresenting],
      info: [
        info.autoReset,
        info.render.calls,
        info.render.triangles,
        info.render.points,
        info.render.lines,
      ],
    });
    return Object.fromEntries(Object.entries(state).map(([name, value]) => [name, String(value)]));
  }
}

/** Two user frames, the second once without and once with a probe before it, compared byte by byte. */
export default async function untouched(options: CubeColliderOptions): Promise<UntouchedReport> {
  const identities: unknown[] = [];
  const identify = (object: unknown) => {
    if (!identities.includes(object)) identities.push(object);
    return identities.indexOf(object);
  };
  const app = new UserApp();
  const collider = new CubeCollider({ far: 3, ...options });
  collider.position.set(0.3, 1, 0.2);
  const family = () =>
    app.scene.children.map((child) => [
      identify(child.parent),
      identify((child as Mesh).material),
      child.layers.mask,
      child.children.length,
    ]);
  const familyBefore = JSON.stringify(family());

  app.frame();
  const alone = app.frame();
  const infoAlone = app.state(identify).info;

  const changed = new Set<string>();
  let compared = 0;
  const differences = (before: Record<string, string>, after: Record<string, string>) => {
    for (const name in before) {
      compared++;
      if (before[name] !== after[name]) changed.add(`${name}: ${before[name]} -> ${after[name]}`);
    }
  };
  const probe = () => {
    const before = app.state(identify);
    collider.update(app.renderer, app.scene);
    differences(before, app.state(identify));
  };

  // Just after the user set a viewport, between frames with the canvas bound; then with a target of the user's, its scissor set and clearing off.
  app.renderer.setViewport(0, 0, 97, 95);
  probe();
  app.renderer.setScissorTest(true);
  app.renderer.setScissor(1, 1, 5, 5);
  probe();
  app.renderer.setRenderTarget(null);
  probe();
  app.renderer.setScissorTest(false);
  app.renderer.setRenderTarget(app.post);
  app.renderer.autoClear = app.renderer.autoClearDepth = app.renderer.sortObjects = false;
  app.renderer.info.autoReset = false;
  app.renderer.setScissorTest(true);
  app.renderer.setScissor(3, 4, 50, 60);
  app.renderer.setViewport(5, 6, 40, 30);
  app.renderer.shadowMap.needsUpdate = true;
  probe();
  app.renderer.shadowMap.needsUpdate = false;
  app.renderer.setScissorTest(false);
  app.renderer.setViewport(0, 0, 97, 95);
  app.renderer.info.autoReset = app.renderer.sortObjects = app.renderer.autoClearDepth = true;
  app.renderer.autoClear = true;
  app.post.scissorTest = true;
  app.renderer.setRenderTarget(app.post);
  app.renderer.setScissorTest(false);
  probe();
  app.post.scissorTest = false;
  app.renderer.setRenderTarget(null);
  await collider.updateAsync(app.renderer, app.scene);
  probe();

  const beside = app.frame();
  differences({ infoOfTheFrame: infoAlone! }, { infoOfTheFrame: app.state(identify).info! });
  let differing = 0;
  let drawn = 0;
  for (let i = 0; i < alone.length; i++) {
    if (alone[i] !== beside[i]) differing++;
    if (alone[i] !== alone[i % 4]) drawn++;
  }
  const report = {
    bytes: alone.length,
    differing,
    drawn,
    changed: [...changed],
    compared,
    objectsKept: JSON.stringify(family()) === familyBefore,
  };
  collider.dispose();
  app.renderer.dispose();
  return report;
}

function flatCanvas(color: Color): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 8;
  const context = canvas.getContext('2d')!;
  context.fillStyle = `#${color.getHexString()}`;
  context.fillRect(0, 0, 8, 8);
  return canvas;
}
