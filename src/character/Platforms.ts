import { Matrix4, type Object3D, Quaternion, Vector3 } from 'three';
import type { Capsule } from '../field/Capsule.js';
import type { FieldMemory } from '../field/FieldMemory.js';
import { timeOfImpact } from '../field/timeOfImpact.js';
import { Anchor } from './Anchor.js';
import type { Contact } from './Contact.js';

/** Poses of what bends that are remembered: fields come late. */
const REMEMBERED = 16;
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
  /** What the body stands on, and how it lay when it last took the body along. */
  readonly #anchor = new Anchor();
  readonly #groundPose = new Matrix4();
  /** The same before that, each with the character's clock; a ring. */
  readonly #past = Array.from({ length: REMEMBERED }, () => ({ clock: NaN, pose: new Matrix4() }));
  #turn = 0;
  /** Objects of the newest field, and their world matrices when they were carried last. */
  readonly #objects: Object3D[] = [];
  readonly #poses: Matrix4[] = [];

  constructor(memory: FieldMemory, toBody: Quaternion) {
    this.#memory = memory;
    this.#toBody = toBody;
  }

  /** Whether the body rides on something whose world matrix does not tell where it is: a skin, an instance. */
  bends = false;

  reset(): void {
    this.#anchor.release();
    this.bends = false;
    this.#objects.length = 0;
  }

  /**
   * Brings the newest field's surfels to where their objects are; forgets older fields if any moved.
   *
   * @param ground what the body stands on
   * @param refresh whether to bring world matrices up to date first
   * @param clock the character's, seconds
   * @returns whether anything moved
   */
  carry(body: Capsule, ground: Contact | null, refresh: boolean, clock: number): boolean {
    this.ride.set(0, 0, 0);
    this.push.set(0, 0, 0);
    const rides = this.#take(body, ground, refresh, clock);
    const newest = this.#memory.newest;
    if (newest === null) return rides;
    this.bends = rides && this.#anchor.deforms;
    if (this.bends) this.#bend(since);
    let moved = rides;
    for (let i = 0; i < newest.objects.length; i++) {
      const object = newest.objects[i]!;
      if (refresh) object.updateWorldMatrix(true, false);
      if (object.matrixWorld.equals(newest.poses[i]!)) continue;
      moved = true;
      this.#memory.forgetOlder();
      if (this.bends && object === this.#anchor.object && this.#anchor.instance < 0) {
        // Its place has been told by its own vertices.
        newest.poses[i]!.copy(object.matrixWorld);
        continue;
      }
      if (object !== this.#anchor.object) this.#sweep(body, object, newest.poses[i]!);
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
    if (this.#anchor.object === null || !this.#anchor.deforms) return;
    const then = this.#poseAt(newest.asked);
    if (then !== null) this.#bend(displaced(then, this.#groundPose));
  }

  /** How the anchor lay at a time; null if that is not known any more. */
  #poseAt(time: number): Matrix4 | null {
    let best = null;
    for (const past of this.#past) {
      if (past.clock <= time + 1e-6 && !(best !== null && past.clock <= best.clock)) best = past;
    }
    return best === null ? null : best.pose;
  }

  /** Carries the newest field's surfels of what the body stands on along. @param way world space */
  #bend(way: Matrix4): void {
    const { object, instance } = this.#anchor;
    const newest = this.#memory.newest!;
    const id = newest.objects.indexOf(object!) + 1;
    if (id === 0) return;
    this.#memory.forgetOlder();
    newest.bend(id, instance, way, this.#toBody);
    this.#memory.revision++;
  }

  /** All fields were forgotten: what comes next is where it is, and nothing has moved there. */
  forget(): void {
    this.#objects.length = 0;
  }

  /** The ground's own way since the last frame, whatever fields came between. */
  #take(body: Capsule, ground: Contact | null, refresh: boolean, clock: number): boolean {
    const anchor = this.#anchor;
    if (ground === null || ground.object === null) {
      anchor.release();
      return false;
    }
    const { object, instance, point } = ground;
    if (refresh) object.updateWorldMatrix(true, false);
    let moved = false;
    // First how the place that it stood on has moved, then whether it stands on another.
    if (object === anchor.object) {
      anchor.follow();
      moved = !anchor.pose.equals(this.#groundPose);
    }
    if (moved) {
      displacement(this.#groundPose, anchor.pose, body, 0, this.#toBody, this.ride);
      displaced(this.#groundPose, anchor.pose);
      // A matrix that cannot be inverted, a vertex that is none: no ride.
      moved = Number.isFinite(this.ride.x + this.ride.y + this.ride.z);
      if (!moved) this.ride.set(0, 0, 0);
    }
    if (!anchor.hold(object, instance, point)) for (const each of this.#past) each.clock = NaN;
    this.#groundPose.copy(anchor.pose);
    const past = this.#past[this.#turn++ % REMEMBERED]!;
    past.clock = clock;
    past.pose.copy(anchor.pose);
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

/** The way from one pose to another, world space, into `since`. */
function displaced(from: Matrix4, to: Matrix4): Matrix4 {
  return since.copy(from).invert().premultiply(to);
}

const since = /* @__PURE__ */ new Matrix4();
const back = /* @__PURE__ */ new Vector3();
const between = /* @__PURE__ */ new Vector3();
const place = /* @__PURE__ */ new Vector3();
const inverse = /* @__PURE__ */ new Matrix4();
const toWorld = /* @__PURE__ */ new Quaternion();
