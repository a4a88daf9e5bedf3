import { Mesh, Vector3, type BufferGeometry } from 'three';
import { Capsule } from 'three/addons/math/Capsule.js';
import { Octree } from 'three/addons/math/Octree.js';
import { SHAPE } from './shape.js';
import type { Walker } from './Walker.js';

const SUB_STEPS = 5;
/** 1/s, of the example; a tenth of it in the air. */
const DAMPING = 4;
/** Of Chromium's heap, measured: two boxes, two arrays and a set of layers; three vectors. */
const NODE_BYTES = 460;
const TRIANGLE_BYTES = 230;

/**
 * The method of three's example games_fps: five sub-steps on an `Octree`, its `capsuleIntersect` deciding all. The
 * example steers by acceleration; here the wanted velocity is set each frame, as for the others. What it keeps of its
 * fall on the floor, damped, is the example's own.
 */
export class OctreeWalker implements Walker {
  readonly foot = new Vector3();
  readonly ready = true;
  readonly waiting = 0;
  readonly preparation: number;
  grounded = false;
  readonly #octree: Octree;
  readonly #capsule = new Capsule(new Vector3(), new Vector3(), SHAPE.radius);
  readonly #velocity = new Vector3();
  readonly #travel = new Vector3();

  /** @param level or one who walks in it already, whose tree it shares */
  constructor(level: BufferGeometry | OctreeWalker) {
    const start = performance.now();
    this.#octree = level instanceof OctreeWalker ? level.#octree : build(level);
    this.preparation = performance.now() - start;
  }

  place(foot: Vector3): void {
    this.#capsule.start.copy(foot).y += SHAPE.radius;
    this.#capsule.end.copy(foot).y += SHAPE.height - SHAPE.radius;
    this.#velocity.set(0, 0, 0);
    this.grounded = false;
    this.foot.copy(foot);
  }

  frame(velocity: Vector3, jump: boolean, dt: number): void {
    this.#velocity.x = velocity.x;
    this.#velocity.z = velocity.z;
    if (jump && this.grounded) this.#velocity.y = SHAPE.jumpSpeed;
    for (let i = 0; i < SUB_STEPS; i++) this.#step(dt / SUB_STEPS);
    this.foot.copy(this.#capsule.start).y -= SHAPE.radius;
  }

  #step(dt: number): void {
    const velocity = this.#velocity;
    if (this.grounded) {
      velocity.y *= Math.exp(-DAMPING * dt);
    } else {
      velocity.y -= SHAPE.gravity * dt;
      velocity.y *= 1 + 0.1 * (Math.exp(-DAMPING * dt) - 1);
    }
    this.#capsule.translate(this.#travel.copy(velocity).multiplyScalar(dt));
    const hit = this.#octree.capsuleIntersect(this.#capsule);
    this.grounded = false;
    if (!hit) return;
    this.grounded = hit.normal.y > 0;
    if (!this.grounded) velocity.addScaledVector(hit.normal, -hit.normal.dot(velocity));
    if (hit.depth >= 1e-10) this.#capsule.translate(hit.normal.multiplyScalar(hit.depth));
  }

  /** Of its tree, about: what V8 keeps for a node and for a triangle, and four bytes for each mention of one in a leaf. */
  get bytes(): number {
    const triangles = new Set<object>();
    let total = 0;
    const weigh = (node: Octree): void => {
      total += NODE_BYTES + 4 * node.triangles.length;
      for (const triangle of node.triangles) triangles.add(triangle);
      for (const child of node.subTrees) weigh(child);
    };
    weigh(this.#octree);
    return total + TRIANGLE_BYTES * triangles.size;
  }

  counts() {
    return {};
  }

  dispose(): void {
    this.#octree.clear();
  }
}

function build(geometry: BufferGeometry): Octree {
  const mesh = new Mesh(geometry);
  mesh.updateMatrixWorld();
  return new Octree().fromGraphNode(mesh);
}
