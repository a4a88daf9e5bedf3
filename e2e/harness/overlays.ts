import {
  BackSide,
  BoxGeometry,
  Color,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  PerspectiveCamera,
  RenderTarget,
  Scene,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { CharacterController } from 'three-cube-collider';
import {
  CharacterHelper,
  ContactsHelper,
  FreeSpaceHelper,
  HELPER_COLORS,
  ReadbackTimeline,
  SurfelsHelper,
  UnfoldedField,
} from 'three-cube-collider/helpers';
import { type Backend, createRendering } from '../support/rendering.js';

const SIZE = 128;

/** Triangles of the last picture. */
let drawn = 0;

/** Pixels that a helper changes in all, and near the place where it must, by how much they go toward its colour. */
export interface Shown {
  changed: number;
  toward: Record<string, number>;
}

type Helper = Object3D & { update(): void; dispose(): void };

/** A character that has walked against a wall, in a room open at one side, and everything that shows what it sees. */
export default async function overlays({ backend }: { backend: Backend }) {
  const { renderer, collider: createCollider, see } = await createRendering(backend);
  const scene = new Scene();
  // Grey, open toward +Z, where nobody walks: a wall at x = 0.6.
  const grey = new MeshBasicMaterial({ color: 0x808080, side: BackSide });
  const open = new MeshBasicMaterial({ visible: false });
  const room = new Mesh(new BoxGeometry(6, 2.4, 6), [grey, grey, grey, grey, open, grey]);
  room.position.set(-2.4, 1.2, 0);
  scene.add(room);
  const collider = createCollider({ resolution: 16, transparent: 'solid' });
  const character = new CharacterController(collider);
  character.teleport(new Vector3(0, 0.1, 0));
  const steps = async (count: number) => {
    for (let i = 0; i < count; i++) {
      character.update(renderer, scene, 1 / 60);
      await see(collider, scene);
    }
  };
  character.walk(new Vector3(2, 0, 0));
  await steps(24);
  character.walk(new Vector3());
  await steps(2);

  const camera = new PerspectiveCamera(75, 1, 0.05, 20);
  camera.position.set(-1.9, 1.7, 1.9);
  camera.lookAt(0.2, 0.9, 0);
  camera.updateMatrixWorld();
  const target =
    backend === 'WebGL2' ? new WebGLRenderTarget(SIZE, SIZE) : new RenderTarget(SIZE, SIZE);
  target.texture.name = 'output';
  const picture = () => draw(renderer, scene, camera, target);
  const pixelOf = (point: Vector3) => {
    const { x, y } = point.clone().project(camera);
    const column = Math.floor((0.5 + 0.5 * x) * SIZE);
    const row = Math.floor((0.5 + 0.5 * y) * SIZE);
    // WebGPU reads from the top.
    return SIZE * (backend === 'WebGPU' ? SIZE - 1 - row : row) + column;
  };

  await see(collider, scene);
  const distances = collider.field!.distance.slice();
  const ids = collider.field!.object.slice();
  const draws = collider.stats.drawCalls;
  const without = await picture();
  const { memory } = renderer.info as unknown as { memory: Record<string, number> };
  const memoryBefore = { ...memory };
  const triangles = drawn;

  const surfels = new SurfelsHelper(collider);
  const contacts = new ContactsHelper(character);
  const free = new FreeSpaceHelper(collider);
  const body = new CharacterHelper(character);
  const foot = character.position;
  const { radius, height } = character.body;
  const at = (x: number, y: number, z: number) => foot.clone().add(new Vector3(x, y, z));
  /** Where each must show, and in which colour. */
  const places: [string, Helper, number, Vector3[]][] = [
    ['floor', surfels, HELPER_COLORS.floor, [at(-0.5, -foot.y, 0.3), at(-0.6, -foot.y, 0.5)]],
    ['wall', surfels, HELPER_COLORS.wall, [at(0.37, 1, 0.5), at(0.37, 0.8, 0.6)]],
    ['touch', contacts, HELPER_COLORS.floor, [at(0, 0.05, 0)]],
    ['push', contacts, HELPER_COLORS.wall, character.contacts.slice(0, 9).map(arrowHead)],
    ['net', free, HELPER_COLORS.free, [at(-0.6, 1, 1.3), at(-0.3, 0.9, 1.4)]],
    ['capsule', body, HELPER_COLORS.grounded, [at(-radius, 0.9, 0), at(0, height / 2, radius)]],
  ];
  const shown: Record<string, Shown> = {};
  for (const [name, helper, color, points] of places) {
    scene.add(helper);
    helper.update();
    const now = await picture();
    const toward: Record<string, number> = {};
    points.forEach((point, i) => {
      toward[i] = nearest(now, without, pixelOf(point), new Color(color));
    });
    shown[name] = { changed: differing(now, without), toward };
    helper.removeFromParent();
  }

  const all = [surfels, contacts, free, body];
  scene.add(...all);
  for (const helper of all) helper.update();
  await picture();
  const trianglesShown = drawn;
  const { changed, moved } = collider.survey(scene);
  await see(collider, scene);
  const solid = collider.field!.distance.filter((d, i) => d !== distances[i]).length;
  const others = collider.field!.object.filter((id, i) => id !== ids[i]).length;
  const hidden = all.map((helper) => {
    helper.visible = false;
    helper.update();
    return helper.visible;
  });
  const asleep = differing(await picture(), without);
  const trianglesAsleep = drawn;
  for (const helper of all) {
    helper.visible = true;
    helper.dispose();
  }
  await picture();
  const left = { ...memory };

  const strip = element(400, 120);
  const timeline = new ReadbackTimeline(collider, strip, { character, seconds: 3 });
  for (let i = 0; i < 6; i++) {
    collider.invalidate();
    timeline.update();
    await steps(1);
    timeline.update();
  }
  const cross = element(220, 168);
  const unfolded = new UnfoldedField(collider, cross);
  unfolded.update();
  const report = {
    shown,
    contacts: character.contacts.length,
    survey: { changed, moved },
    solid,
    others,
    drawCalls: collider.stats.drawCalls - draws,
    trianglesMore: trianglesShown - triangles,
    hidden,
    asleep,
    trianglesAsleep: trianglesAsleep - triangles,
    memory: ['geometries', 'textures', 'attributes', 'indexAttributes'].map(
      (name) => (left[name] ?? 0) - (memoryBefore[name] ?? 0),
    ),
    ticks: count(strip, (r, g, b) => r > 180 && g > 180 && b < 110),
    bars: count(strip, (r, g, b) => r < 120 && g > 140 && b > 190),
    near: count(cross, (_, g, b) => g > 150 && b < 140),
  };
  strip.remove();
  cross.remove();
  collider.dispose();
  renderer.dispose();
  return report;
}

function arrowHead({ point, normal }: { point: Vector3; normal: Vector3 }): Vector3 {
  return point.clone().addScaledVector(normal, 0.42);
}

async function draw(
  renderer: WebGLRenderer,
  scene: Scene,
  camera: PerspectiveCamera,
  target: RenderTarget,
): Promise<Uint8Array> {
  // On WebGPU it counts on until the next frame.
  renderer.info.reset();
  renderer.setRenderTarget(target as never);
  renderer.render(scene, camera);
  drawn = renderer.info.render.triangles;
  renderer.setRenderTarget(null);
  if ((renderer as { isWebGLRenderer?: boolean }).isWebGLRenderer === true) {
    const pixels = new Uint8Array(4 * SIZE * SIZE);
    renderer.readRenderTargetPixels(target as never, 0, 0, SIZE, SIZE, pixels);
    return pixels;
  }
  const read = renderer.readRenderTargetPixelsAsync as unknown as (
    ...args: unknown[]
  ) => Promise<Uint8Array>;
  return (await read.call(renderer, target, 0, 0, SIZE, SIZE)).slice();
}

function differing(one: Uint8Array, other: Uint8Array): number {
  let pixels = 0;
  for (let i = 0; i < one.length; i += 4) {
    if ([0, 1, 2].some((c) => Math.abs(one[i + c]! - other[i + c]!) > 2)) pixels++;
  }
  return pixels;
}

/** How far the pixels around one went from what they were to a colour: of a change of its hue, 1 is the whole way. */
function nearest(now: Uint8Array, before: Uint8Array, pixel: number, color: Color): number {
  const wanted = color.toArray().map((part) => 255 * part);
  let best = 0;
  for (let dy = -3; dy <= 3; dy++) {
    for (let dx = -3; dx <= 3; dx++) {
      const i = 4 * (pixel + SIZE * dy + dx);
      const way = wanted.map((part, c) => part - before[i + c]!);
      const gone = wanted.map((_, c) => now[i + c]! - before[i + c]!);
      const dot = way.reduce((sum, part, c) => sum + part * gone[c]!, 0);
      const square = way.reduce((sum, part) => sum + part * part, 0);
      const off = Math.hypot(...gone.map((part, c) => part - (dot / square) * way[c]!));
      // Another colour is none.
      if (off < 12) best = Math.max(best, dot / square);
    }
  }
  return best;
}

function element(width: number, height: number): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.style.cssText = `width: ${width}px; height: ${height}px; display: block`;
  document.body.append(canvas);
  return canvas;
}

function count(
  canvas: HTMLCanvasElement,
  is: (red: number, green: number, blue: number) => boolean,
): number {
  const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
  let pixels = 0;
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3]! > 0 && is(data[i]!, data[i + 1]!, data[i + 2]!)) pixels++;
  }
  return pixels;
}
