import { BoxGeometry, Group, Mesh, MeshBasicMaterial, Scene, WebGLRenderer } from 'three';
import { CubeCollider } from 'three-cube-collider';
import { busyLoop } from '../support/busyLoop.js';

/** Tiles that are there at a time, for each one added a frame. */
const KEPT = 30;

/** Calls whose time is three's or the GPU's. */
function timeOf(renderer: WebGLRenderer): { theirs: number } {
  const clock = { theirs: 0 };
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const watch = (owner: object, name: string) => {
    const methods = owner as Record<string, (...args: unknown[]) => unknown>;
    const method = methods[name]!.bind(owner);
    methods[name] = (...args) => {
      const start = performance.now();
      try {
        return method(...args);
      } finally {
        clock.theirs += performance.now() - start;
      }
    };
  };
  watch(renderer, 'render');
  for (const name of ['readPixels', 'clearBufferfv']) watch(gl, name);
  return clock;
}

/**
 * Tiles come and go every frame around a collider, each a group with a plate and two stones: a loader of map tiles at its
 * busiest. Every fourth frame one of those added lies within reach; is it seen in its first frame?
 *
 * @param seconds at 60 Hz
 */
export default async function stream({ tiles, seconds }: { tiles: number; seconds: number }) {
  const renderer = new WebGLRenderer();
  const clock = timeOf(renderer);
  const material = new MeshBasicMaterial();
  const world = new Group();
  const level = new Group();
  level.add(new Group());
  const scene = new Scene().add(world, level);
  for (let i = 0; i < 2000; i++) {
    const stone = new Mesh(new BoxGeometry(), material);
    stone.position.set(10 + 3 * (i % 50), 0, 3 * Math.floor(i / 50));
    level.children[0]!.add(stone);
  }
  const collider = new CubeCollider({ readback: 'sync', far: 2, supersample: 1 });
  const geometries: number[] = [];
  const alive: Group[] = [];
  const own: number[] = [];
  // Beside our own work, to tell its hitches from those of the machine.
  const control: number[] = [];
  const busy = busyLoop(0.5);
  let missed = 0;
  let asked = 0;
  let count = 0;
  const tile = (number: number, near: boolean) => {
    const group = new Group();
    const plate = new Mesh(new BoxGeometry(1, 0.1, 1), material);
    group.add(plate);
    for (let i = 0; i < 2; i++) {
      const stone = new Mesh(plate.geometry, material);
      stone.position.set(0.1 * i, -0.2, 0);
      group.add(new Group().add(stone));
    }
    // Side by side: none hides another in the thirty frames that it is there.
    if (near) {
      group.position.set(0.3 * (count++ % 9) - 1.2, -1, 0);
      group.scale.x = 0.25;
    } else group.position.set(8 + (number % 50), 0, -8);
    world.add(group);
    alive.push(group);
    return plate;
  };
  const drop = () => {
    const group = alive.shift()!;
    (group.children[0] as Mesh).geometry.dispose();
    world.remove(group);
  };
  const frames = Math.round(60 * seconds);
  for (let frame = -30; frame < frames; frame++) {
    if (frame === 0) geometries.push(renderer.info.memory.geometries);
    let near: Mesh | null = null;
    for (let i = 0; i < tiles; i++) {
      while (alive.length >= KEPT * tiles) drop();
      const plate = tile(frame, i === 0 && frame % 4 === 0);
      if (i === 0 && frame % 4 === 0) near = plate;
    }
    const start = performance.now();
    clock.theirs = 0;
    collider.survey(scene);
    collider.update(renderer, scene);
    if (frame >= 0) {
      own.push(performance.now() - start - clock.theirs);
      control.push(busy());
    }
    if (near !== null) {
      asked++;
      const number = collider.field!.objects.indexOf(near) + 1;
      if (number === 0 || !collider.field!.object.includes(number)) missed++;
    }
    // A frame's end: lets the page breathe.
    if (frame % 30 === 0) await new Promise((resolve) => setTimeout(resolve));
  }
  while (alive.length > 0) drop();
  for (let i = 0; i < 8; i++) collider.survey(scene);
  collider.update(renderer, scene);
  const held = collider.field!.objects.length;
  collider.dispose();
  geometries.push(renderer.info.memory.geometries);
  renderer.dispose();
  renderer.forceContextLoss();
  return { tiles, own, control, missed, asked, held, geometries };
}
