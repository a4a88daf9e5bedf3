import { PerspectiveCamera, Vector3 } from 'three';
import { CameraBoom } from '../../src/controls/CameraBoom.js';
import { CharacterController } from '../../src/character/CharacterController.js';
import { CharacterControls } from '../../src/controls/CharacterControls.js';
import { nearRadius } from '../../src/controls/nearRadius.js';
import type { Judgement, World } from './world/World.js';
import { WorldCollider, type WorldColliderOptions } from './world/WorldCollider.js';

const RENDERER = {};
const SCENE = {};
const UP = new Vector3(0, 1, 0);
const EYES = 1.6;

export interface BoomWalkOptions extends WorldColliderOptions {
  foot?: readonly [number, number, number];
  rate?: number;
}

/** A character in an analytic world with a third-person camera on a boom, judged exactly after every frame. */
export class BoomWalk {
  readonly character: CharacterController;
  readonly controls: CharacterControls;
  readonly camera = new PerspectiveCamera(70, 16 / 9, 0.05, 100);
  readonly boom: CameraBoom;
  readonly eye: WorldCollider;
  readonly rate: number;
  /** Each frame's distance from the head to the camera, metres. */
  readonly lengths: number[] = [];
  /** Frames in which something stood between head and camera, or in which the near plane was in something. */
  hidden = 0;
  cut = 0;
  /** Of what a ray along the boom had free, how much the camera got, 0 to 1: each frame's, summed. */
  given = 0;
  /** Least gap of the ball that holds the near plane, metres. */
  least = Infinity;
  frames = 0;
  readonly #body: WorldCollider;
  readonly #asked = { direction: new Vector3(), way: new Vector3(), distance: 0, free: 0 };
  readonly #head = new Vector3();
  readonly #judgement: Judgement = { depth: 0, solid: null };

  constructor(
    readonly world: World,
    {
      foot = [0, 0.02, 0],
      rate = 60,
      latency = 3,
      resolution = 16,
      ...options
    }: BoomWalkOptions = {},
  ) {
    this.rate = rate;
    this.#body = new WorldCollider(world, { latency: 2, resolution: 16 });
    this.eye = new WorldCollider(world, { latency, resolution, ...options });
    this.boom = new CameraBoom(this.eye);
    this.character = new CharacterController(this.#body);
    this.character.teleport(new Vector3(...foot));
    this.controls = new CharacterControls(this.character, this.camera, null, {
      view: 'third',
      boom: {
        reach: (pivot, direction, distance, radius) => {
          const free = this.boom.reach(pivot, direction, distance, radius);
          this.#asked.direction.copy(direction);
          return Object.assign(this.#asked, { distance, free }).free;
        },
      },
    });
  }

  /** Walks for some seconds; `steer` sets what it wants, once a frame. */
  run(seconds: number, steer: (time: number, walk: Vector3) => void = () => {}): this {
    const dt = 1 / this.rate;
    const walk = new Vector3();
    for (let i = 0; i < Math.round(seconds * this.rate); i++) {
      steer(i * dt, walk);
      this.character.walk(walk);
      this.#body.tick();
      this.eye.tick();
      this.character.update(RENDERER, SCENE, dt);
      this.controls.follow(dt);
      this.boom.update(RENDERER, SCENE, dt);
      this.#judge();
    }
    return this;
  }

  #judge(): void {
    const { camera, character, world } = this;
    this.frames++;
    const head = this.#head.copy(character.position);
    head.y += EYES;
    this.lengths.push(head.distanceTo(camera.position));
    world.refresh();
    const radius = nearRadius(camera);
    const foot = camera.position.clone();
    foot.y -= radius;
    const { depth } = world.judge(foot, UP, radius, 2 * radius, this.#judgement);
    this.least = Math.min(this.least, -depth);
    if (depth > 0) this.cut++;
    const { way, direction, distance } = this.#asked;
    if (cast(world, head, camera.position) < head.distanceTo(camera.position)) this.hidden++;
    way.copy(head).addScaledVector(direction, distance);
    this.given += this.#asked.free / Math.min(distance, cast(world, head, way));
  }
}

/** How far it is from one place toward another until something is met, metres, by exact rays; Infinity for nothing. */
function cast(world: World, from: Vector3, to: Vector3): number {
  let nearest = Infinity;
  const way = to.clone().sub(from).normalize();
  if (way.lengthSq() === 0) return nearest;
  for (const solid of world.solids) {
    const o = from.clone().applyMatrix4(solid.inverse);
    const d = way.clone().transformDirection(solid.inverse);
    nearest = Math.min(nearest, solid.cast(o.x, o.y, o.z, d.x, d.y, d.z));
  }
  return nearest;
}
