import {
  BoxGeometry,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import {
  CharacterController,
  CharacterControls,
  CubeCollider,
  type CubeColliderOptions,
} from 'three-cube-collider';

const DT = 1 / 60;
/** On the plaza, where there is nothing but the floor: x, z, metres. */
const CLEAR = [-3, 9] as const;

/** The demo's level as `GLTFLoader` gives it, a character in it, and a lift. */
async function makeWorld(options: CubeColliderOptions = {}) {
  const renderer = new WebGLRenderer();
  renderer.setSize(64, 64);
  document.body.append(renderer.domElement);
  const scene = new Scene();
  scene.add((await new GLTFLoader().loadAsync('/level.glb')).scene);
  const lift = new Mesh(new BoxGeometry(1.6, 0.2, 1.6), new MeshBasicMaterial());
  lift.name = 'lift';
  lift.position.set(0, -50, 0);
  scene.add(lift);

  const character = new CharacterController<WebGLRenderer, Scene>(new CubeCollider(options));
  const events: string[] = [];
  const speeds: number[] = [];
  for (const type of ['jump', 'land', 'leave', 'step', 'squeeze', 'respawn'] as const) {
    character.addEventListener(type, () => events.push(type));
  }
  character.addEventListener('land', ({ speed }) => speeds.push(speed));
  character.addEventListener('contact', ({ object }) => events.push(`contact ${object.name}`));
  const controls = new CharacterControls(character, new PerspectiveCamera(), renderer.domElement);
  let time = 0;

  return {
    scene,
    lift,
    character,
    controls,
    events,
    speeds,
    /** One frame of the page. */
    async frame(): Promise<void> {
      controls.update(DT);
      character.update(renderer, scene, DT);
      controls.follow(DT);
      await new Promise(requestAnimationFrame);
    },
    async frames(count: number): Promise<void> {
      for (let i = 0; i < count; i++) await this.frame();
    },
    async put(x: number, y: number, z: number): Promise<void> {
      character.teleport(new Vector3(x, y, z));
      // Read asynchronously, the first field is some frames away.
      for (let i = 0; i < 300 && !(character.ready && character.grounded); i++) await this.frame();
      events.length = speeds.length = 0;
    },
    /** Frames until it has not moved for ten of them. */
    async untilItStops(): Promise<number[]> {
      const last = character.position.clone();
      for (let still = 0, i = 0; still < 10 && i < 600; i++) {
        await this.frame();
        still = character.position.distanceTo(last) < 1e-4 ? still + 1 : 0;
        last.copy(character.position);
      }
      return last.toArray();
    },
    /** What it stands on and touches, in plain data. */
    touched() {
      const { contacts, ground } = character;
      return {
        ground: ground?.object?.name ?? null,
        contacts: contacts.map(({ object, gap, normal }) => ({
          object: object?.name ?? null,
          gap,
          normal: normal.toArray(),
        })),
      };
    },
    /** Rides the lift, up and aside, for some seconds; tells how far it slipped on it. */
    async ride(seconds: number) {
      const [x, z] = CLEAR;
      const move = () => {
        time += DT;
        const part = 0.5 - 0.5 * Math.cos(0.9 * time);
        lift.position.set(x + 0.8 * Math.sin(0.7 * time), 0.1 + 1.5 * part, z);
      };
      time = 0;
      move();
      await this.put(x, 0.3, z);
      // It rides from the frame after its landing on.
      await this.frames(2);
      const place = () => character.position.clone().sub(lift.position);
      const start = place();
      let slip = 0;
      let lowest = Infinity;
      let highest = -Infinity;
      let grounds = 0;
      const frames = Math.round(seconds / DT);
      for (let i = 0; i < frames; i++) {
        move();
        await this.frame();
        const now = place();
        slip = Math.max(slip, Math.hypot(now.x - start.x, now.z - start.z));
        lowest = Math.min(lowest, now.y - 0.1);
        highest = Math.max(highest, now.y - 0.1);
        if (character.ground?.object === lift) grounds++;
      }
      return { slip, lowest, highest, grounds, frames, rode: lift.position.y };
    },
  };
}

type World = Awaited<ReturnType<typeof makeWorld>>;

declare global {
  interface Window {
    world: World;
  }
}

/** Leaves a world in `window.world`. */
export default async function character(options: CubeColliderOptions): Promise<void> {
  window.world = await makeWorld(options);
}

/**
 * Two characters walk from two places, each alone and both at once, on one renderer and one scene.
 *
 * @returns how far apart the ends of alone and together are, metres, and how far they walked
 */
export async function pair() {
  const renderer = new WebGLRenderer();
  const scene = new Scene();
  scene.add((await new GLTFLoader().loadAsync('/level.glb')).scene);
  const ways = [
    { from: new Vector3(0, 0.02, -3), walk: new Vector3(0.6, 0, -2.5) },
    { from: new Vector3(3.5, 0.02, 4), walk: new Vector3(3, 0, 0.2) },
  ];
  const run = (indices: number[]) => {
    const characters = indices.map((i) => {
      const made = new CharacterController(new CubeCollider({ readback: 'sync' }));
      made.teleport(ways[i]!.from);
      return made;
    });
    for (let frame = 0; frame < 90; frame++) {
      characters.forEach((each, i) => {
        each.walk(ways[indices[i]!]!.walk);
        each.update(renderer, scene, DT);
      });
    }
    return characters.map(({ position, collider }) => {
      (collider as CubeCollider).dispose();
      return position.clone();
    });
  };
  const alone = [...run([0]), ...run([1])];
  const together = run([0, 1]);
  renderer.dispose();
  return {
    apart: alone.map((place, i) => place.distanceTo(together[i]!)),
    walked: together.map((place, i) => place.distanceTo(ways[i]!.from)),
  };
}
