import {
  BoxGeometry,
  Mesh,
  MeshBasicMaterial,
  Scene,
  SphereGeometry,
  Vector3,
  Vector4,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { CubeCollider, type CubeColliderOptions } from 'three-cube-collider';
import { CubeColliderHelper } from 'three-cube-collider/helpers';
import { FACES } from '../../src/cube/faces.js';
import { layOut, UNFOLDED } from '../../src/helpers/unfold.js';

const SIZE = 440;
/** Where a small ball is seen in every face: right of the middle and a little above, so no turn or mirror hides. */
const BALL = [0.75, 0.625] as const;
const CASES: CubeColliderOptions[] = [
  { format: 'RGBA32F' },
  { format: 'RGBA16F' },
  { format: 'RGBA8' },
  { supersample: 4 },
  { output: 'axis', rMin: 0.1, rMax: 3 },
];

/** A room whose six walls are at 0.6 m, 1 m … 2.6 m in the faces' order, with a ball before each: of the walls it sees the backs. */
function room(): Scene {
  const scene = new Scene();
  const box = new Mesh(new BoxGeometry(1.6, 3.2, 4.8), new MeshBasicMaterial());
  box.position.set(-0.2, -0.2, -0.2);
  scene.add(box);
  for (const { forward, right, up } of FACES) {
    const ball = new Mesh(new SphereGeometry(0.08), new MeshBasicMaterial());
    ball.position
      .set(...forward)
      .addScaledVector(new Vector3(...right), 2 * BALL[0] - 1)
      .addScaledVector(new Vector3(...up), 2 * BALL[1] - 1)
      .multiplyScalar(0.4);
    scene.add(ball);
  }
  return scene;
}

/**
 * One helper shown one collider after another: per collider the brightness of each face's wall, whether its ball is
 * the brightest there, and whether a ring marks it. Then what the helper leaves changed, and which corners it draws in.
 */
export default function helper() {
  const renderer = new WebGLRenderer();
  const width = 1000;
  const height = 800;
  renderer.setSize(width, height);
  const gl = renderer.getContext();
  const pixel = (x: number, y: number) => {
    const bytes = new Uint8Array(4);
    gl.readPixels(Math.round(x), Math.round(y), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return bytes;
  };
  const brightness = (x: number, y: number) => {
    const [r, g, b] = pixel(x, y);
    return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
  };
  const scene = room();
  const view = new CubeColliderHelper(new CubeCollider(), { size: SIZE, margin: 10 });
  renderer.setClearColor(0, 1);
  renderer.clear();
  view.render(renderer);
  const beforeFirst = brightness(20, 20);

  const { padding, cell, width: panelWidth, height: panelHeight } = layOut(SIZE);
  const shown = CASES.map((options) => {
    const collider = new CubeCollider({ far: 3, readback: 'sync', ...options });
    collider.update(renderer, scene);
    view.collider = collider;
    renderer.clear();
    view.render(renderer);
    const place = (face: number, u: number, v: number) =>
      UNFOLDED[face]!.map((at, i) => 10 + padding + (at + [u, v][i]!) * cell) as [number, number];
    const walls: number[] = [];
    let balls = 0;
    let rings = 0;
    FACES.forEach((_, face) => {
      const [u, v] = BALL;
      const ball = brightness(...place(face, u, v));
      const others = [place(face, 1 - u, v), place(face, u, 1 - v), place(face, v, u)];
      if (others.every((other) => ball > brightness(...other) + 5)) balls++;
      walls.push(brightness(...place(face, 0.5, 0.25)));
      // The ring's radius is 0.085 of a face, and its white is the only blue among bright colours.
      const { maxima, resolution } = collider;
      if (maxima === null) return;
      const [x, y] = place(
        face,
        (Math.floor(maxima.texel[2 * face]!) + 0.5) / resolution,
        (Math.floor(maxima.texel[2 * face + 1]!) + 0.5) / resolution,
      );
      let blue = 0;
      for (let dx = -2; dx <= 2; dx++) {
        blue = Math.max(blue, pixel(x + 0.085 * cell + dx, y)[2]!);
      }
      const onBall = Math.hypot(
        maxima.texel[2 * face]! / resolution - u,
        maxima.texel[2 * face + 1]! / resolution - v,
      );
      if (blue > 180 && onBall < 0.1) rings++;
    });
    const ordered = walls.every((wall, i) => i === 0 || wall < walls[i - 1]! - 5);
    return { ordered, balls, rings };
  });

  const target = new WebGLRenderTarget(16, 16);
  const state = () => ({
    target: renderer.getRenderTarget() === target,
    viewport: String(renderer.getViewport(new Vector4()).toArray()),
    current: String(gl.getParameter(gl.VIEWPORT)),
    scissor: String(renderer.getScissor(new Vector4()).toArray()),
    scissorTest: renderer.getScissorTest(),
    enabled: gl.isEnabled(gl.SCISSOR_TEST),
    autoClear: renderer.autoClear,
    calls: renderer.info.render.calls,
  });
  const changed: string[] = [];
  const corners: Record<string, boolean[]> = {};
  for (const corner of ['bottom-left', 'bottom-right', 'top-left', 'top-right'] as const) {
    view.corner = corner;
    renderer.setRenderTarget(null);
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, width, height);
    renderer.clear();
    renderer.setScissorTest(true);
    renderer.setScissor(1, 2, 30, 40);
    renderer.setViewport(5, 6, 70, 80);
    renderer.setRenderTarget(corner === 'top-left' ? target : null);
    const before: Record<string, unknown> = state();
    view.render(renderer);
    const after: Record<string, unknown> = state();
    for (const name in before) if (before[name] !== after[name]) changed.push(name);
    renderer.setRenderTarget(null);
    // Just inside all four edges of where the panel would be.
    corners[corner] = [0, 1].flatMap((top) =>
      [0, 1].map((right) => {
        const x = right ? width - 10 - panelWidth : 10;
        const y = top ? height - 10 - panelHeight : 10;
        return [
          [3, panelHeight / 2],
          [panelWidth - 4, panelHeight / 2],
          [panelWidth / 2, 3],
          [panelWidth / 2, panelHeight - 4],
        ].every(([dx, dy]) => brightness(x + dx!, y + dy!) > 0);
      }),
    );
  }
  view.visible = false;
  renderer.setScissorTest(false);
  renderer.clear();
  view.render(renderer);
  const hidden = brightness(width - 10 - panelWidth / 2, height - 10 - panelHeight / 2);
  view.dispose();
  renderer.dispose();
  return { beforeFirst, shown, changed, corners, hidden };
}
