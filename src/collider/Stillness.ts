import type { BufferGeometry, Mesh, Object3D } from 'three';
import type { SceneNode } from './SceneNode.js';

/** Numbers kept of an object: position, quaternion and scale (or its world matrix); its geometry's bounding sphere. */
const STRIDE = 20;
const SPHERE = 16;

/**
 * Tells, from a few numbers in one flat array, that an object is where it was, so that nothing of it need be worked out
 * again: of ten thousand that stand still hardly one is asked for more.
 */
export class Stillness {
  #numbers = new Float64Array(STRIDE * 512);
  /** Numbers given to moves: no two of any objects are the same. */
  #moves = 0;

  /** Makes room for the numbers of so many. */
  reserve(slots: number): void {
    if (STRIDE * slots <= this.#numbers.length) return;
    const grown = new Float64Array(2 * STRIDE * slots);
    grown.set(this.#numbers);
    this.#numbers = grown;
  }

  /**
   * Is a mesh's bounding sphere the one that was noted, as its world matrix and its geometry's own sphere are the same?
   * Where it is not, or nothing was noted, it has to be found, and then noted.
   *
   * @param call number of the call
   * @param refreshes whether world matrices follow from poses, as three's next render has it
   */
  isStill(node: SceneNode, call: number, refreshes: boolean): boolean {
    const moved = this.#movedOf(node, call, refreshes);
    const { object, geometry } = node;
    if (geometry === null || moved !== node.noted) return false;
    if ((object as Mesh).geometry !== geometry || !object.frustumCulled) return false;
    const { boundingSphere } = geometry;
    if (boundingSphere === null) return false;
    const numbers = this.#numbers;
    const at = STRIDE * node.slot + SPHERE;
    const { center } = boundingSphere;
    return (
      numbers[at] === center.x &&
      numbers[at + 1] === center.y &&
      numbers[at + 2] === center.z &&
      numbers[at + 3] === boundingSphere.radius
    );
  }

  /** Notes that the sphere of a mesh which was just asked about is known, and follows from those two alone. */
  note(node: SceneNode, geometry: BufferGeometry): void {
    const { center, radius } = geometry.boundingSphere!;
    const at = STRIDE * node.slot + SPHERE;
    center.toArray(this.#numbers, at);
    this.#numbers[at + 3] = radius;
    node.geometry = geometry;
    node.noted = node.moved;
  }

  /** Number of the object's last move, or of that of any above it. */
  #movedOf(node: SceneNode, call: number, refreshes: boolean): number {
    if (node.settled === call) return node.moved;
    node.settled = call;
    const above = node.parent === null ? 0 : this.#movedOf(node.parent, call, refreshes);
    const posed = refreshes && node.isPosed();
    if (!posed && refreshes) node.refresh(call);
    const same = posed
      ? this.#samePose(node.object, STRIDE * node.slot) && node.above === above
      : this.#sameMatrix(node.object, STRIDE * node.slot);
    if (!same || node.posed !== posed) node.moved = ++this.#moves;
    node.posed = posed;
    node.above = above;
    return node.moved;
  }

  /** Compares, and keeps what it is now. */
  #samePose({ position, quaternion, scale }: Object3D, at: number): boolean {
    const numbers = this.#numbers;
    if (
      numbers[at] === position.x &&
      numbers[at + 1] === position.y &&
      numbers[at + 2] === position.z &&
      numbers[at + 3] === quaternion.x &&
      numbers[at + 4] === quaternion.y &&
      numbers[at + 5] === quaternion.z &&
      numbers[at + 6] === quaternion.w &&
      numbers[at + 7] === scale.x &&
      numbers[at + 8] === scale.y &&
      numbers[at + 9] === scale.z
    ) {
      return true;
    }
    position.toArray(numbers, at);
    quaternion.toArray(numbers, at + 3);
    scale.toArray(numbers, at + 7);
    return false;
  }

  #sameMatrix({ matrixWorld: { elements } }: Object3D, at: number): boolean {
    const numbers = this.#numbers;
    let same = true;
    for (let i = 0; i < 16; i++) {
      if (numbers[at + i] === elements[i]!) continue;
      numbers[at + i] = elements[i]!;
      same = false;
    }
    return same;
  }
}
