import { BoxGeometry, Mesh, MeshStandardMaterial, Scene, Vector3, WebGLRenderer } from 'three';
import {
  AxisResponse,
  CharacterController,
  CubeCollider,
  type CubeColliderOptions,
} from 'three-cube-collider';

const RADIUS = 0.5;

/**
 * A sphere of half a metre among boxes on a floor, walked by the paper's response on the real GPU: it drops, stands,
 * walks into a wall, over a low kerb and against a high one. Distances in metres.
 */
export default async function axisWalk({
  rate,
  options,
}: {
  rate: number;
  options: CubeColliderOptions;
}) {
  const renderer = new WebGLRenderer();
  const scene = new Scene();
  const box = (x0: number, y0: number, z0: number, x1: number, y1: number, z1: number) => {
    const mesh = new Mesh(new BoxGeometry(x1 - x0, y1 - y0, z1 - z0), new MeshStandardMaterial());
    mesh.position.set((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2);
    scene.add(mesh);
  };
  const low = 0.25 * RADIUS;
  const high = 0.45 * RADIUS;
  box(-20, -1, -20, 20, 0, 20);
  box(3, -1, -2, 4, 3, 2);
  box(-1, -1, 3, 1, low, 8);
  box(-1, -1, -8, 1, high, -3);

  const collider = new CubeCollider({ rMin: RADIUS / 2, rMax: RADIUS, ...options });
  const character = new CharacterController(collider, {
    radius: RADIUS,
    response: new AxisResponse(),
  });
  const walk = new Vector3();
  const frame = async () => {
    character.update(renderer, scene, 1 / rate);
    // An asynchronous read needs the event loop.
    if (collider.readback === 'async') await new Promise((resolve) => setTimeout(resolve, 4));
  };
  /** Walks for some seconds; returns the foot's farthest way from where it began, along the floor. */
  const run = async (seconds: number, x = 0, z = 0) => {
    character.walk(walk.set(x, 0, z));
    const from = character.position.clone();
    let farthest = 0;
    for (let i = 0; i < seconds * rate; i++) {
      await frame();
      const { position } = character;
      farthest = Math.max(farthest, Math.hypot(position.x - from.x, position.z - from.z));
    }
    return farthest;
  };
  /** Walks until it has stood still for half a second, however late the reads come, or has walked `metres`. */
  const untilStill = async (x = 0, z = 0, metres = Infinity) => {
    character.walk(walk.set(x, 0, z));
    const from = character.position.clone();
    const near = from.clone();
    for (let still = 0, i = 0; still < rate / 2 && i < 60 * rate; i++) {
      await frame();
      const { position, ready } = character;
      still = ready && position.distanceTo(near) < 0.002 ? still + 1 : 0;
      if (still === 0) near.copy(position);
      if (position.distanceTo(from) > metres) break;
    }
  };
  const to = async (x: number, y: number, z: number) => {
    character.teleport(new Vector3(x, y, z));
    await untilStill();
  };

  await to(0, 1.5, 0);
  const standsAt = character.position.y;
  const grounded = character.grounded;
  const creep = await run(5);
  const sinks = Math.abs(character.position.y - standsAt);
  await untilStill(2, 0);
  const intoWall = character.position.x + RADIUS - 3;
  await to(0, 0.1, 2);
  await untilStill(0, 2, 3.5);
  const onLow = { y: character.position.y - low, z: character.position.z };
  await to(0, 0.1, -2);
  await untilStill(0, -2);
  const againstHigh = { y: character.position.y, z: character.position.z };
  const { stats } = collider;
  collider.dispose();
  renderer.dispose();
  return { standsAt, grounded, creep, sinks, intoWall, onLow, againstHigh, stats };
}
