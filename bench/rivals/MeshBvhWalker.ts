import { Box3, Line3, Vector3 } from 'three';
import type { BufferGeometry } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { SHAPE } from './shape.js';
import type { Walker } from './Walker.js';

const SUB_STEPS = 5;

/**
 * The method of three-mesh-bvh's example characterMovement: five sub-steps, in each the capsule is pushed out of one
 * triangle after the other; pushed up by more than a quarter of its fall it stands.
 */
export class MeshBvhWalker implements Walker {
  readonly foot = new Vector3();
  readonly ready = true;
  readonly waiting = 0;
  readonly preparation: number;
  grounded = false;
  readonly #bvh: MeshBVH;
  readonly #velocity = new Vector3();
  readonly #axis = new Line3();
  readonly #box = new Box3();
  readonly #onTriangle = new Vector3();
  readonly #onAxis = new Vector3();
  readonly #push = new Vector3();

  /** @param level or one who walks in it already, whose tree it shares */
  constructor(level: BufferGeometry | MeshBvhWalker) {
    const start = performance.now();
    this.#bvh = level instanceof MeshBvhWalker ? level.#bvh : build(level);
    this.preparation = performance.now() - start;
  }

  place(foot: Vector3): void {
    this.foot.copy(foot);
    this.#velocity.set(0, 0, 0);
    this.grounded = false;
  }

  frame(velocity: Vector3, jump: boolean, dt: number): void {
    if (jump && this.grounded) {
      this.#velocity.y = SHAPE.jumpSpeed;
      this.grounded = false;
    }
    for (let i = 0; i < SUB_STEPS; i++) this.#step(velocity, dt / SUB_STEPS);
  }

  #step(walk: Vector3, dt: number): void {
    const velocity = this.#velocity;
    // Standing, a fall begins anew each step, so that it presses on the ground no more than it must.
    velocity.y = (this.grounded ? 0 : velocity.y) - SHAPE.gravity * dt;
    this.foot.addScaledVector(velocity, dt).addScaledVector(walk, dt);
    const push = this.#pushOut();

    this.grounded = push.y > Math.abs(dt * velocity.y * 0.25);
    const length = push.length();
    if (length > 0) this.foot.addScaledVector(push, Math.max(0, length - 1e-5) / length);
    if (this.grounded) velocity.set(0, 0, 0);
    else if (length > 0) velocity.addScaledVector(push, -push.dot(velocity) / (length * length));
  }

  /** How far the axis must go to be clear of every triangle it meets, one after the other. */
  #pushOut(): Vector3 {
    const { radius, height } = SHAPE;
    const axis = this.#axis;
    axis.start.copy(this.foot).y += height - radius;
    axis.end.copy(this.foot).y += radius;
    this.#push.copy(axis.start);
    const box = this.#box.makeEmpty().expandByPoint(axis.start).expandByPoint(axis.end);
    box.expandByScalar(radius);
    this.#bvh.shapecast({
      intersectsBounds: (bounds) => bounds.intersectsBox(box),
      intersectsTriangle: (triangle) => {
        const distance = triangle.closestPointToSegment(axis, this.#onTriangle, this.#onAxis);
        if (distance >= radius) return;
        const out = this.#onAxis.sub(this.#onTriangle).normalize();
        axis.start.addScaledVector(out, radius - distance);
        axis.end.addScaledVector(out, radius - distance);
      },
    });
    return this.#push.subVectors(axis.start, this.#push);
  }

  /** Of its tree, and of the geometry that the tree sorts and keeps. */
  get bytes(): number {
    const { _roots: roots } = this.#bvh as unknown as { _roots: ArrayBuffer[] };
    const { index, attributes } = this.#bvh.geometry;
    const kept = index!.array.byteLength + attributes.position!.array.byteLength;
    return roots.reduce((sum, root) => sum + root.byteLength, kept);
  }

  counts() {
    return {};
  }

  dispose(): void {
    // nothing but memory
  }
}

function build(geometry: BufferGeometry): MeshBVH {
  // Its index will be sorted.
  return new MeshBVH(geometry.clone());
}
