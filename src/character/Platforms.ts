import { Matrix4, type Object3D, Quaternion, Vector3 } from 'three';
import type { Capsule } from '../field/Capsule.js';
import type { FieldMemory } from '../field/FieldMemory.js';
import { timeOfImpact } from '../field/timeOfImpact.js';

/** What moves farther than this part of the radius at once might pass by unnoticed: it is swept. */
const SWEPT_RATIO = 0.4;

/**
 * Carries surfels along with the objects they belong to, and tells what that does to the body: what it stands on takes
 * it along, what runs into it pushes.
 */
export class Platforms {
  /** How far the ground took the body, metres, body's frame. */
  readonly ride = new Vector3();
  /** How far it must be pushed at once by what is too fast for contacts to tell. */
  readonly push = new Vector3();

  readonly #memory: FieldMemory;
  readonly #toBody: Quaternion;
  /** World matrix of the ground when it last took the body along. */
  readonly #groundPose = new Matrix4();
  #ground: Object3D | null = null;
  /** Objects of the newest field, and their world matrices when they were carried last. */
  readonly #objects: Object3D[] = [];
  readonly #poses: Matrix4[] = [];

  constructor(memory: FieldMemory, toBody: Quaternion) {
    this.#memory = memory;
    this.#toBody = toBody;
  }

  reset(): void {
    this.#ground = null;
    this.#objects.length = 0;
  }

  /**
   * Brings the newest field's surfels to where their objects are; forgets older fields if any moved.
   *
   * @param ground what the body stands on
   * @param refresh whether to bring world matrices up to date first
   * @returns whether anything moved
   */
  carry(body: Capsule, ground: Object3D | null, refresh: boolean): boolean {
    this.ride.set(0, 0, 0);
    this.push.set(0, 0, 0);
    let moved = this.#take(body, ground, refresh);
    const newest = this.#memory.newest;
    if (newest === null) return moved;
    for (let i = 0; i < newest.objects.length; i++) {
      const object = newest.objects[i]!;
      if (refresh) object.updateWorldMatrix(true, false);
      if (object.matrixWorld.equals(newest.poses[i]!)) continue;
      moved = true;
      this.#memory.forgetOlder();
      if (object !== ground) this.#sweep(body, object, newest.poses[i]!);
      newest.carry(i + 1, this.#toBody);
      this.#memory.revision++;
    }
    this.#objects.length = newest.objects.length;
    for (let i = 0; i < newest.objects.length; i++) {
      this.#objects[i] = newest.objects[i]!;
      (this.#poses[i] ??= new Matrix4()).copy(newest.poses[i]!);
    }
    return moved;
  }

  /**
   * A new field is drawn at its own time: brings what has moved since then or before to where the last frame left it, so
   * that `carry` makes the way of this frame.
   */
  newField(): void {
    const newest = this.#memory.newest!;
    for (let i = 0; i < newest.objects.length; i++) {
      const object = newest.objects[i]!;
      const known = this.#objects.indexOf(object);
      const pose = known >= 0 ? this.#poses[known]! : object.matrixWorld;
      if (!pose.equals(newest.poses[i]!)) newest.carry(i + 1, this.#toBody, pose);
    }
  }

  /** All fields were forgotten: what comes next is where it is, and nothing has moved there. */
  forget(): void {
    this.#objects.length = 0;
  }

  /** The ground's own way since the last frame, whatever fields came between. */
  #take(body: Capsule, ground: Object3D | null, refresh: boolean): boolean {
    if (ground !== null && refresh) ground.updateWorldMatrix(true, false);
    const same = ground !== null && ground === this.#ground;
    const moved = same && !ground.matrixWorld.equals(this.#groundPose);
    if (moved) {
      displacement(this.#groundPose, ground.matrixWorld, body, 0, this.#toBody, this.ride);
    }
    this.#ground = ground;
    if (ground !== null) this.#groundPose.copy(ground.matrixWorld);
    return moved;
  }

  /** Adds to `push` what an object's move does to the body beyond what an overlap shows. */
  #sweep(body: Capsule, object: Object3D, from: Matrix4): void {
    const way = displacement(
      from,
      object.matrixWorld,
      body,
      body.height / 2,
      this.#toBody,
      between,
    );
    if (way.length() < SWEPT_RATIO * body.radius) return;
    // Seen from the object, the body comes toward it.
    const part = timeOfImpact(this.#memory, body, back.copy(way).negate(), 0, 0, object);
    if (part < 1) this.push.addScaledVector(way, 1 - part);
  }
}

/**
 * Where a move from one world matrix to another takes the point of the body that is `height` above the foot.
 *
 * @returns `target`: the way, body's frame, metres
 */
function displacement(
  from: Matrix4,
  to: Matrix4,
  body: Capsule,
  height: number,
  toBody: Quaternion,
  target: Vector3,
): Vector3 {
  toWorld.copy(toBody).invert();
  place.set(body.x, body.y + height, body.z).applyQuaternion(toWorld);
  target.copy(place).applyMatrix4(inverse.copy(from).invert()).applyMatrix4(to);
  return target.sub(place).applyQuaternion(toBody);
}

const back = /* @__PURE__ */ new Vector3();
const between = /* @__PURE__ */ new Vector3();
const place = /* @__PURE__ */ new Vector3();
const inverse = /* @__PURE__ */ new Matrix4();
const toWorld = /* @__PURE__ */ new Quaternion();
