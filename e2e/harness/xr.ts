import { metaQuest3, XRDevice } from 'iwer';
import {
  type ArrayCamera,
  BackSide,
  BoxGeometry,
  Color,
  DirectionalLight,
  Group,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
  SphereGeometry,
  Vector4,
  WebGLRenderer,
} from 'three';
import { CubeCollider, type CubeColliderOptions } from 'three-cube-collider';

export interface XrCase {
  collider?: CubeColliderOptions;
  /** A headset's session brings a framebuffer of its own; the emulated one draws onto the canvas. */
  ownFramebuffer: boolean;
}

/** A lit room of 6 m with a few things in it. */
function makeScene(): Scene {
  const room = new Mesh(new BoxGeometry(6, 4, 6), new MeshStandardMaterial({ side: BackSide }));
  room.receiveShadow = true;
  const crate = new Mesh(new BoxGeometry(0.5, 0.5, 0.5), new MeshStandardMaterial());
  crate.position.set(0.6, 1.2, -1);
  crate.rotation.set(0.3, 0.5, 0);
  const ball = new Mesh(new SphereGeometry(0.4, 24, 16), new MeshStandardMaterial());
  ball.position.set(-0.9, 1.4, -0.6);
  const sun = new DirectionalLight(0xffffff, 3);
  sun.position.set(0.5, 1.8, 1);
  for (const mesh of [crate, ball]) mesh.castShadow = true;
  sun.castShadow = true;
  const scene = new Scene().add(new Group().add(room, crate), ball, sun);
  scene.background = new Color(0x335577);
  return scene;
}

/** What a renderer, its context and its XR cameras are at. */
function stateOf(renderer: WebGLRenderer, camera: PerspectiveCamera): string[] {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const { xr, info } = renderer;
  // But for the number of the frame: three guards its uploads by it.
  const { calls, triangles, points, lines } = info.render;
  const eyes: ArrayCamera = xr.getCamera();
  const names = [
    'VIEWPORT', 'SCISSOR_BOX', 'SCISSOR_TEST', 'COLOR_CLEAR_VALUE', 'COLOR_WRITEMASK', 'DEPTH_WRITEMASK',
    'PIXEL_PACK_BUFFER_BINDING', 'RASTERIZER_DISCARD',
  ] as const; // prettier-ignore
  const parameters = names.map((name) => `${name} ${gl.getParameter(gl[name]) as unknown}`);
  const poses = [camera, eyes, ...eyes.cameras].map((each) =>
    JSON.stringify([
      each.layers.mask,
      each.matrixWorld.elements,
      each.projectionMatrix.elements,
      (each as unknown as { viewport?: Vector4 }).viewport?.toArray(),
    ]),
  );
  return [
    ...parameters,
    ...poses,
    `xr ${[xr.enabled, xr.isPresenting, xr.cameraAutoUpdate, eyes.cameras.length].join()}`,
    `viewport ${renderer.getCurrentViewport(new Vector4()).toArray().join()}`,
    `counters ${[calls, triangles, points, lines, info.autoReset].join()}`,
    `clear ${renderer.autoClear} ${renderer.sortObjects} ${renderer.shadowMap.needsUpdate}`,
  ];
}

/** In a session that presents: pictures with and without the collider before them, state, and what the collider sees. */
export default async function xr({ collider: options, ownFramebuffer }: XrCase) {
  const device = new XRDevice(metaQuest3, { stereoEnabled: true });
  device.installRuntime({ forceInstall: true });
  device.position.set(0.1, 1.6, 0.4);
  device.quaternion.set(-0.05, 0.1, 0, 0.99);
  const renderer = new WebGLRenderer();
  renderer.shadowMap.enabled = true;
  renderer.xr.enabled = true;
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const session = await navigator.xr!.requestSession('immersive-vr', {
    optionalFeatures: ['local-floor'],
  });
  const framebuffer = ownFramebuffer ? framebufferOf(gl) : null;
  if (ownFramebuffer) {
    Object.defineProperty(XRWebGLLayer.prototype, 'framebuffer', {
      configurable: true,
      get: () => framebuffer,
    });
  }
  await renderer.xr.setSession(session);

  const scene = makeScene();
  const camera = new PerspectiveCamera(70, 1, 0.05, 20);
  const collider = new CubeCollider({ far: 4, ...options });
  collider.position.set(0, 1.2, 0.2);
  const report = {
    presenting: false,
    ended: false,
    eyes: 0,
    /** How often another framebuffer than the session's was bound, after a render or an update. */
    astray: 0,
    frames: 0,
    colours: 0,
    /** Bytes by which the eyes' pictures differ from each other, and with the collider from those without. */
    eyesDiffer: 0,
    differing: 0,
    changed: [] as string[],
    /** Fields that came, and texels of them that are not as without XR. */
    fields: 0,
    texels: 0,
    wrong: 0,
  };
  const look = () => {
    if (gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING) !== framebuffer) report.astray++;
  };
  const picture = () => {
    renderer.render(scene, camera);
    look();
    const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
    const pixels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return { pixels, width };
  };
  const seen: { center: number[]; distance: Float32Array }[] = [];
  let time = 0;

  await new Promise<void>((resolve, reject) => {
    renderer.setAnimationLoop(() => {
      try {
        report.frames++;
        // The user's frame, twice in each: without the collider, and after it has drawn.
        const target = renderer.getRenderTarget();
        const { pixels, width } = picture();
        const before = stateOf(renderer, camera);
        collider.survey(scene);
        collider.update(renderer, scene);
        look();
        report.changed.push(...stateOf(renderer, camera).filter((value, i) => value !== before[i]));
        if (target === null || renderer.getRenderTarget() !== target) report.astray++;
        const beside = picture().pixels;
        if (report.frames === 1) {
          report.presenting = renderer.xr.isPresenting;
          report.eyes = renderer.xr.getCamera().cameras.length;
          report.colours = new Set(new Uint32Array(pixels.buffer)).size;
          report.eyesDiffer = halvesDiffer(pixels, width);
        }
        for (let i = 0; i < pixels.length; i++) if (pixels[i] !== beside[i]) report.differing++;
        const { field } = collider;
        if (field !== null && field.time !== time) {
          ({ time } = field);
          seen.push({ center: field.center.toArray(), distance: field.distance.slice() });
        }
        // It walks on, once what was seen here is known.
        collider.position.x = 0.1 * seen.length;
        if (seen.length >= 4 || report.frames > 600) resolve();
      } catch (error) {
        reject(error as Error);
      }
    });
  });
  renderer.setAnimationLoop(null);
  await session.end();
  report.ended = !renderer.xr.isPresenting;
  collider.dispose();

  // The same places, seen by a renderer that knows nothing of XR.
  const plain = new WebGLRenderer();
  const twin = new CubeCollider({ far: 4, ...options, readback: 'sync' });
  for (const { center, distance } of seen) {
    twin.position.fromArray(center);
    twin.update(plain, scene);
    report.fields++;
    const there = twin.field!.distance;
    for (let i = 0; i < there.length; i++) {
      if (there[i] !== Infinity) report.texels++;
      if (there[i] !== distance[i]) report.wrong++;
    }
  }
  twin.dispose();
  for (const each of [renderer, plain]) each.dispose();
  device.uninstallRuntime();
  return report;
}

/** As a headset's: of the size of the canvas, with depth. */
function framebufferOf(gl: WebGL2RenderingContext): WebGLFramebuffer {
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  for (const [attachment, format] of [
    [gl.COLOR_ATTACHMENT0, gl.RGBA8],
    [gl.DEPTH_STENCIL_ATTACHMENT, gl.DEPTH24_STENCIL8],
  ] as const) {
    const buffer = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
    gl.renderbufferStorage(gl.RENDERBUFFER, format, window.innerWidth, window.innerHeight);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
  }
  gl.bindRenderbuffer(gl.RENDERBUFFER, null);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  return framebuffer;
}

function halvesDiffer(pixels: Uint8Array, width: number): number {
  let differing = 0;
  for (let i = 0; i < pixels.length; i++) {
    const x = (i >> 2) % width;
    if (x < width / 2 && pixels[i] !== pixels[i + 2 * width]) differing++;
  }
  return differing;
}
