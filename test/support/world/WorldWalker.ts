import { Quaternion, Vector3 } from 'three';
import { CharacterController } from '../../../src/character/CharacterController.js';
import type { CharacterOptions } from '../../../src/character/characterOptions.js';
import type { Solid } from './Solid.js';
import type { Judgement, World } from './World.js';
import { WorldCollider, type WorldColliderOptions } from './WorldCollider.js';

const RENDERER = {};
const SCENE = {};
const Y = new Vector3(0, 1, 0);

export interface WalkerOptions extends WorldColliderOptions {
  /** Frames a second. */
  rate?: number;
  /** Where the foot begins, in the world's own frame. */
  foot?: readonly [number, number, number];
  /** Turns the world and the character alike, so that the world's own +Y becomes this. */
  up?: Vector3;
  character?: Omit<CharacterOptions, 'up'>;
  /** Moves what moves, once a frame before the character. Seconds since the beginning, and of this frame. */
  drive?: (time: number, dt: number) => void;
  /** Judges every frame exactly. Default true. */
  judged?: boolean;
}

/**
 * A character in an analytic world, driven frame by frame as an app would and judged after each. Whatever `up` is, all
 * it takes and tells is in the world's own frame, +Y up.
 */
export class WorldWalker {
  readonly collider: WorldCollider;
  readonly character: CharacterController;
  readonly rate: number;
  drive: ((time: number, dt: number) => void) | null;
  /** Seconds and frames since the beginning. */
  time = 0;
  frames = 0;
  /** Depth of every frame's stepped body, metres, negative for gaps; and the worst of them. */
  readonly depths: number[] = [];
  worst = -Infinity;
  worstAt = '';
  /** The same of the drawn body. */
  worstDrawn = -Infinity;
  /** Frames in which the body's middle or foot went through a surface. */
  crossings = 0;
  crossedAt = '';
  readonly #up: Vector3;
  readonly #turn: Quaternion;
  readonly #back: Quaternion;
  readonly #judged: boolean;
  readonly #foot = new Vector3();
  readonly #drawn = new Vector3();
  readonly #before = { low: new Vector3(), middle: new Vector3(), known: false };
  readonly #judgement: Judgement = { depth: 0, solid: null };

  constructor(
    readonly world: World,
    {
      rate = 60,
      foot = [0, 0.02, 0],
      up = Y,
      character = {},
      drive,
      judged = true,
      ...collider
    }: WalkerOptions = {},
  ) {
    this.rate = rate;
    this.#up = up.clone().normalize();
    this.#turn = new Quaternion().setFromUnitVectors(Y, this.#up);
    this.#back = this.#turn.clone().invert();
    this.#judged = judged;
    this.drive = drive ?? null;
    world.root.quaternion.copy(this.#turn);
    this.drive?.(0, 0);
    world.refresh();
    this.collider = new WorldCollider(world, collider);
    this.character = new CharacterController(this.collider, { ...character, up: this.#up.clone() });
    this.teleport(...foot);
  }

  /** The stepped foot. */
  get foot(): Vector3 {
    return this.#foot.copy(this.character.body.position).applyQuaternion(this.#back);
  }

  /** The foot as drawn. */
  get drawn(): Vector3 {
    return this.#drawn.copy(this.character.position).applyQuaternion(this.#back);
  }

  /** A new vector: the character's velocity, in the world's own frame. */
  get velocity(): Vector3 {
    return this.character.velocity.clone().applyQuaternion(this.#back);
  }

  teleport(x: number, y: number, z: number): this {
    this.character.teleport(this.#toWorld(x, y, z));
    this.#before.known = false;
    return this;
  }

  walk(x: number, z = 0): this {
    this.character.walk(this.#toWorld(x, 0, z));
    return this;
  }

  move(x: number, y: number, z: number): this {
    this.character.move(this.#toWorld(x, y, z));
    return this;
  }

  /** Runs for some seconds; `each` sees every frame after it. */
  run(seconds: number, each?: (walker: this) => void): this {
    return this.frame(Math.round(seconds * this.rate), each);
  }

  frame(count = 1, each?: (walker: this) => void): this {
    const dt = 1 / this.rate;
    for (let i = 0; i < count; i++) {
      this.time += dt;
      this.frames++;
      this.collider.tick();
      this.drive?.(this.time, dt);
      this.character.update(RENDERER, SCENE, dt);
      if (this.#judged) this.#judge();
      each?.(this);
    }
    return this;
  }

  /** Runs until at rest for want of news: fields have come in, gravity has settled. */
  settle(seconds = 1): this {
    this.run(seconds);
    this.worst = this.worstDrawn = -Infinity;
    this.depths.length = 0;
    return this;
  }

  /** Part `p` (0..1) of the frames were less deep than this, metres; never below 0. */
  percentile(p: number): number {
    const sorted = this.depths.slice().sort((a, b) => a - b);
    return Math.max(0, sorted[Math.min(sorted.length - 1, Math.floor(p * sorted.length))] ?? 0);
  }

  /** Exact gap between the body now and the nearest surface, metres. */
  get gap(): number {
    const { radius, height, position } = this.character.body;
    this.world.refresh();
    return -this.world.judge(position, this.#up, radius, height, this.#judgement).depth;
  }

  /** Where it is and how it got there, for a message. */
  get story(): string {
    const { x, y, z } = this.foot;
    const at = [x, y, z].map((n) => n.toFixed(4)).join(', ');
    return `frame ${this.frames} at (${at}), ${this.rate} Hz, ${this.collider.latency} late`;
  }

  #toWorld(x: number, y: number, z: number): Vector3 {
    return new Vector3(x, y, z).applyQuaternion(this.#turn);
  }

  #judge(): void {
    const { body, position } = this.character;
    this.world.refresh();
    const { depth, solid } = this.world.judge(
      body.position,
      this.#up,
      body.radius,
      body.height,
      this.#judgement,
    );
    this.depths.push(depth);
    if (!(depth <= this.worst)) {
      this.worst = depth;
      this.worstAt = `${(1000 * depth).toFixed(2)} mm in ${solid?.object.name}: ${this.story}`;
    }
    this.#cross();
    if (!position.equals(body.position)) {
      this.world.judge(position, this.#up, body.radius, body.height, this.#judgement);
    }
    if (!(this.#judgement.depth <= this.worstDrawn)) this.worstDrawn = this.#judgement.depth;
  }

  /** Whether the body's lower end and middle went through a surface since the last frame, which may itself have moved. */
  #cross(): void {
    const { body } = this.character;
    const before = this.#before;
    low.copy(body.position).addScaledVector(this.#up, body.radius);
    middle.copy(body.position).addScaledVector(this.#up, body.height / 2);
    for (const solid of before.known ? this.world.solids : []) {
      if (!solid.object.visible || !wasThere(solid)) continue;
      if (!passes(solid, before.low, low) && !passes(solid, before.middle, middle)) continue;
      this.crossings++;
      this.crossedAt ||= `${solid.object.name}: ${this.story}`;
    }
    before.low.copy(low);
    before.middle.copy(middle);
    before.known = true;
    for (const solid of this.world.solids) keepInverse(solid);
  }
}

const low = new Vector3();
const middle = new Vector3();
const from = new Vector3();
const to = new Vector3();
const inverses = new WeakMap<Solid, Solid['inverse']>();

const wasThere = (solid: Solid) => inverses.has(solid);

function keepInverse(solid: Solid): void {
  const kept = inverses.get(solid);
  if (kept) kept.copy(solid.inverse);
  else inverses.set(solid, solid.inverse.clone());
}

/** Whether a way from an old place to a new one, each in the solid's own frame of its time, meets the solid. */
function passes(solid: Solid, before: Vector3, after: Vector3): boolean {
  from.copy(before).applyMatrix4(inverses.get(solid)!);
  to.copy(after).applyMatrix4(solid.inverse).sub(from);
  const length = to.length();
  if (length === 0) return false;
  to.divideScalar(length);
  return solid.cast(from.x, from.y, from.z, to.x, to.y, to.z) <= length;
}
