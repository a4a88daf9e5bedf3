import {
  BoxGeometry,
  type BufferGeometry,
  DataTexture,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PlaneGeometry,
  Scene,
  Vector3,
} from 'three';
import {
  CharacterController,
  type CubeCollider,
  CubeColliderGroup,
  type CubeColliderOptions,
  type SurfaceField,
} from 'three-cube-collider';
import { type Backend, createRendering } from '../support/rendering.js';

export interface GroupCase {
  backend: Backend;
  collider?: CubeColliderOptions;
}

export interface GroupReport {
  /** Of all texels of all fields, and of these those that tell what the collider alone tells there. */
  texels: number;
  same: number;
  /** Those that see anything at all. */
  seen: number;
  /** Updates that drew, cubemaps, and reads. */
  draws: number;
  cubemaps: number;
  reads: number;
  /** Draw calls that the fields say they took. */
  calls: number;
  /** Textures left on the GPU after all was disposed of. */
  left: number;
}

/** Cubemaps in one update: of twelve places three updates' worth, the second of two renders. */
const SIZE = 7;
const PLACES = 12;

/** A floor with stones, instances, and a plate that its alpha map cuts holes into. */
function createScene(): Scene {
  const scene = new Scene();
  const floor = new Mesh(new PlaneGeometry(40, 40), new MeshStandardMaterial());
  floor.rotation.x = -Math.PI / 2;
  const stones = new InstancedMesh(new BoxGeometry(0.4, 0.5, 0.3), new MeshBasicMaterial(), 60);
  for (let i = 0; i < stones.count; i++) {
    const turn = new Matrix4().makeRotationY(i);
    stones.setMatrixAt(i, turn.setPosition((i % 10) - 4.5, 0.25, Math.floor(i / 10) - 2.5));
  }
  scene.add(floor, stones);
  const checks = new Uint8Array([0, 255, 0, 255, 255, 0, 255, 0, 0, 255, 0, 255, 255, 0, 255, 0]);
  const holes = new DataTexture(new Uint8Array([...checks].flatMap((v) => [v, v, v, 255])), 4, 4);
  holes.needsUpdate = true;
  for (let i = 0; i < PLACES; i++) {
    const wall = new Mesh(new BoxGeometry(0.2, 2, 1.5), new MeshStandardMaterial());
    wall.position.set(1.6 * (i % 4) - 2.6, 1, 2.2 * Math.floor(i / 4) - 2);
    wall.rotation.y = 0.7 * i;
    const plate = new Mesh(
      new PlaneGeometry(1.2, 1.2),
      new MeshStandardMaterial({ alphaMap: holes, alphaTest: 0.5 }),
    );
    plate.position.copy(wall.position).add(new Vector3(0.5, 0.4, 0.6));
    scene.add(wall, plate);
  }
  return scene;
}

const placeOf = (i: number) =>
  new Vector3(1.6 * (i % 4) - 1.9, 0.9 + 0.05 * i, 2.2 * Math.floor(i / 4) - 1.3);

/** What a field tells of a texel, whatever numbers its draw gave to objects. */
function told(field: SurfaceField, texel: number): unknown[] {
  const { distance, direction, normal, front, object, instance, objects } = field;
  const three = (of: Float32Array) => [...of.subarray(3 * texel, 3 * texel + 3)];
  const number = object[texel]!;
  return [
    distance[texel],
    ...three(direction),
    ...three(normal),
    front[texel],
    instance[texel],
    number === 0 ? null : objects[number - 1]!.uuid,
  ];
}

/** Rasterisers interpolate a little otherwise at another place of a target: half a micrometre. */
function isSame(a: unknown, b: unknown): boolean {
  return a === b || (typeof a === 'number' && Math.abs(a - (b as number)) < 1e-5);
}

/** Fields of many colliders drawn together, against those that each draws alone. */
export default async function group({ backend, collider = {} }: GroupCase): Promise<GroupReport> {
  const { renderer, collider: create } = await createRendering(backend);
  const scene = createScene();
  const together = new CubeColliderGroup<typeof renderer>({ size: SIZE });
  const near = 0.02;
  const alone = create({ far: 2.5, near, ...collider });
  const colliders = Array.from({ length: PLACES }, (_, i) => {
    // Each its own reach; seen is as far as any that is drawn with it.
    const made = create({ far: i % 5 === 0 ? 2.5 : 2, near, ...collider });
    made.position.copy(placeOf(i));
    together.add(made);
    return made;
  });
  await colliders[0]!.compile(renderer, scene);
  for (const each of colliders) each.update(renderer, scene);
  for (let i = 0; i < 400 && colliders.some(({ field }) => field === null); i++) {
    together.update(renderer, scene);
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
  const report = { texels: 0, same: 0, seen: 0, calls: 0 };
  for (const each of colliders) {
    const { field } = each;
    if (field === null) throw new Error('A collider of the group never got a field.');
    report.calls += each.stats.drawCalls;
    alone.position.copy(each.position);
    alone.far = field.far;
    const own = (await alone.updateAsync(renderer, scene))!;
    for (let texel = 0; texel < own.count; texel++) {
      const a = told(own, texel);
      const b = told(field, texel);
      report.texels++;
      if (own.distance[texel]! < Infinity) report.seen++;
      if (a.every((value, i) => isSame(value, b[i]))) report.same++;
    }
  }
  const { draws, cubemaps, reads } = together.stats;
  alone.dispose();
  together.dispose();
  for (const each of colliders) each.dispose();
  for (const { material } of scene.children as Mesh<BufferGeometry, MeshStandardMaterial>[]) {
    material.alphaMap?.dispose();
  }
  const left = renderer.info.memory.textures;
  renderer.dispose();
  return { ...report, draws, cubemaps, reads, left };
}

export interface CrowdReport {
  /** Lowest foot, highest foot at the end, metres; the floor is at 0. */
  lowest: number;
  highest: number;
  /** Frames of the walk. */
  frames: number;
  /** Shortest and longest way, metres. */
  shortest: number;
  longest: number;
  /** Deepest that any was in one of the four walls around, metres. */
  deepest: number;
  held: number;
  steps: number;
  draws: number;
  cubemaps: number;
  reads: number;
  /** Whether one that was taken out walked on by its own means. */
  walkedAlone: boolean;
}

/** How far each is to walk, metres, and in how many frames at most: on a slow machine most wait for their cubemaps. */
const WAY = 1;
const PATIENCE = 1500;
/** Half of the room's width, metres. */
const ROOM = 5;
const RADIUS = 0.3;

/** Thirty characters that walk about in a room, each its own way, for `frames` or more. */
export async function crowd({
  backend,
  frames,
}: {
  backend: Backend;
  frames: number;
}): Promise<CrowdReport> {
  const { renderer, collider: create } = await createRendering(backend);
  renderer.setSize(16, 16);
  const scene = new Scene();
  const floor = new Mesh(new BoxGeometry(2 * ROOM, 1, 2 * ROOM), new MeshBasicMaterial());
  floor.position.y = -0.5;
  scene.add(floor);
  for (let i = 0; i < 4; i++) {
    const wall = new Mesh(new BoxGeometry(2 * ROOM, 4, 0.2), new MeshBasicMaterial());
    wall.rotation.y = (i * Math.PI) / 2;
    wall.position.set(0, 2, -ROOM - 0.1).applyAxisAngle(new Vector3(0, 1, 0), wall.rotation.y);
    scene.add(wall);
  }
  const together = new CubeColliderGroup<typeof renderer>();
  const walkers = Array.from({ length: 30 }, (_, i) => {
    const collider: CubeCollider = create({});
    together.add(collider);
    const character = new CharacterController(collider, { radius: RADIUS, height: 1.6 });
    character.teleport(new Vector3(1.4 * (i % 6) - 3.5, 0.05, 1.6 * Math.floor(i / 6) - 3.2));
    return { collider, character, from: character.position.clone(), way: 0 };
  });
  await walkers[0]!.collider.compile(renderer, scene);
  let deepest = -Infinity;
  const last = new Vector3();
  const frame = (i: number) => {
    walkers.forEach(({ character }, n) => {
      const turn = n + Math.floor(i / 60 + n / 7);
      character.walk(last.set(3 * Math.cos(2.4 * turn), 0, 3 * Math.sin(2.4 * turn)));
      character.update(renderer, scene, 1 / 60);
    });
    together.update(renderer, scene);
  };
  const onTheirWay = () => walkers.some(({ way }) => way <= WAY);
  let walked = 0;
  for (; walked < frames || (onTheirWay() && walked < PATIENCE); walked++) {
    frame(walked);
    await new Promise((resolve) => setTimeout(resolve, walked < 10 ? 30 : 3));
    for (const walker of walkers) {
      const { x, z } = walker.character.body.position;
      deepest = Math.max(deepest, Math.abs(x) + RADIUS - ROOM, Math.abs(z) + RADIUS - ROOM);
      walker.way += walker.from.distanceTo(walker.character.body.position);
      walker.from.copy(walker.character.body.position);
    }
  }
  const { draws, cubemaps, reads } = together.stats;
  const feet = walkers.map(({ character }) => character.body.position.y);
  const ways = walkers.map(({ way }) => way);
  // One goes its own way.
  const { collider, character } = walkers[0]!;
  together.remove(collider);
  const before = character.body.position.clone();
  const kept = together.stats.cubemaps;
  const wentAlone = () => character.body.position.distanceTo(before) > 0.5;
  // Its own programs may take a while.
  for (let i = 0; i < 500 && !wentAlone(); i++) {
    character.walk(last.set(before.x > 0 ? -3 : 3, 0, 0));
    character.update(renderer, scene, 1 / 60);
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
  const report: CrowdReport = {
    lowest: Math.min(...feet),
    highest: Math.max(...feet),
    frames: walked,
    shortest: Math.min(...ways),
    longest: Math.max(...ways),
    deepest,
    held: walkers.reduce((sum, walker) => sum + walker.character.stats.held, 0),
    steps: walkers.reduce((sum, walker) => sum + walker.character.stats.steps, 0),
    draws,
    cubemaps,
    reads,
    walkedAlone: wentAlone() && together.stats.cubemaps === kept,
  };
  together.dispose();
  for (const walker of walkers) {
    walker.character.dispose();
    walker.collider.dispose();
  }
  renderer.dispose();
  return report;
}
