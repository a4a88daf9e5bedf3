import RAPIER from '@dimforge/rapier3d-compat';
import { Vector3, type BufferGeometry } from 'three';
import { SHAPE } from './shape.js';
import type { Walker } from './Walker.js';

/** The gap it keeps, metres: the value of Rapier's guide. */
const OFFSET = 0.01;
const SLOPE = Math.PI / 4;
const OTHERS = RAPIER.QueryFilterFlags.EXCLUDE_KINEMATIC;

/**
 * Rapier's `KinematicCharacterController` as its guide sets it up: a kinematic body with a capsule, an offset, slopes to
 * 45°, autostep and snap on. Gravity and jumps are the caller's, as the guide says.
 */
export class RapierWalker implements Walker {
  readonly foot = new Vector3();
  readonly ready = true;
  readonly waiting = 0;
  readonly preparation: number;
  grounded = false;
  readonly #world: RAPIER.World;
  readonly #guest: boolean;
  readonly #body: RAPIER.RigidBody;
  readonly #collider: RAPIER.Collider;
  readonly #controller: RAPIER.KinematicCharacterController;
  #rise = 0;

  /** @param level or one who walks in it already, whose world it shares: that one moves it on */
  private constructor(level: BufferGeometry | RapierWalker) {
    const start = performance.now();
    this.#guest = level instanceof RapierWalker;
    this.#world = level instanceof RapierWalker ? level.#world : build(level);
    this.#body = this.#world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased());
    this.#collider = this.#world.createCollider(
      RAPIER.ColliderDesc.capsule(SHAPE.height / 2 - SHAPE.radius, SHAPE.radius),
      this.#body,
    );
    this.#controller = this.#world.createCharacterController(OFFSET);
    this.#controller.setMaxSlopeClimbAngle(SLOPE);
    this.#controller.setMinSlopeSlideAngle(SLOPE);
    this.#controller.enableAutostep(0.4, 0.2, true);
    this.#controller.enableSnapToGround(0.4);
    this.#world.step();
    this.preparation = performance.now() - start;
  }

  static async create(level: BufferGeometry | RapierWalker): Promise<RapierWalker> {
    await ready();
    return new RapierWalker(level);
  }

  place(foot: Vector3): void {
    this.#body.setTranslation({ x: foot.x, y: foot.y + SHAPE.height / 2, z: foot.z }, true);
    this.#rise = 0;
    this.grounded = false;
    this.#world.step();
    this.foot.copy(foot);
  }

  frame(velocity: Vector3, jump: boolean, dt: number): void {
    if (this.grounded) this.#rise = jump ? SHAPE.jumpSpeed : 0;
    this.#rise -= SHAPE.gravity * dt;
    const wanted = { x: velocity.x * dt, y: this.#rise * dt, z: velocity.z * dt };
    // Walkers are no obstacles to each other.
    this.#controller.computeColliderMovement(this.#collider, wanted, OTHERS);
    const travel = this.#controller.computedMovement();
    // Just off the ground it still counts as grounded: that must not end the jump.
    this.grounded = this.#rise <= 0 && this.#controller.computedGrounded();
    // A ceiling ends a jump.
    if (wanted.y > 0 && travel.y < 0.5 * wanted.y) this.#rise = 0;
    const { x, y, z } = this.#body.translation();
    this.#body.setNextKinematicTranslation({ x: x + travel.x, y: y + travel.y, z: z + travel.z });
    if (!this.#guest) {
      this.#world.timestep = dt;
      this.#world.step();
    }
    const now = this.#body.translation();
    this.foot.set(now.x, now.y - SHAPE.height / 2, now.z);
  }

  counts() {
    return {};
  }

  dispose(): void {
    if (!this.#guest) this.#world.free();
  }
}

function build(geometry: BufferGeometry): RAPIER.World {
  const position = geometry.attributes.position!.array as Float32Array;
  const index = geometry.index?.array ?? Uint32Array.from({ length: position.length / 3 }, at);
  const world = new RAPIER.World({ x: 0, y: -SHAPE.gravity, z: 0 });
  world.createCollider(RAPIER.ColliderDesc.trimesh(position, new Uint32Array(index)));
  return world;
}

let loaded: Promise<void> | null = null;

/** Its WebAssembly, loaded once, so that no walker's preparation counts it. */
export function ready(): Promise<void> {
  return (loaded ??= RAPIER.init().catch((error: unknown) => {
    loaded = null; // to be tried again
    throw error;
  }));
}

function at(_: unknown, i: number): number {
  return i;
}
