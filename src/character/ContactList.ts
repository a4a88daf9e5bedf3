import {
  Box3,
  type EventDispatcher,
  Matrix4,
  type Mesh,
  type Object3D,
  type Quaternion,
  Vector3,
} from 'three';
import type { ContactSet } from '../field/ContactSet.js';
import type { FieldMemory } from '../field/FieldMemory.js';
import { type SlideLimits, type SlideResponse, TOUCH } from '../response/SlideResponse.js';
import type { CharacterEventMap } from './characterEvents.js';
import type { CharacterState } from './CharacterState.js';
import { Contact } from './Contact.js';

/** Where the normal rises less than the surface's own by this, an edge is touched: a part of it. */
const EDGE = 0.08;

/** What the body touches and stands on, and the events that tell of it. */
export class ContactList {
  /** What is touched now; overwritten by the next step. */
  readonly contacts: Contact[] = [];
  /** The contact that carries the body, of several the flattest; null in the air. */
  ground: Contact | null = null;
  /** Whether it touches the edge of something flat enough to stand on. */
  edged = false;

  readonly #pool: Contact[] = [];
  /** Solid things and sensors touched when events were sent last. Lists are short: no sets, whose loops make objects. */
  readonly #told: Object3D[] = [];
  readonly #toldSensors: Object3D[] = [];
  readonly #sensors: Object3D[] = [];

  clear(): void {
    this.contacts.length = 0;
    this.ground = null;
    this.edged = false;
  }

  /** Takes over what the response found around the body. */
  fill(
    response: SlideResponse,
    memory: FieldMemory,
    limits: SlideLimits,
    toWorld: Quaternion,
    walking: boolean,
  ): void {
    const set = response.contacts;
    this.contacts.length = 0;
    this.ground = null;
    this.edged = false;
    let flattest = -Infinity;
    for (let i = 0; i < set.count; i++) {
      if (set.gap[i]! > limits.skin + TOUCH) continue;
      const contact = this.#take(set, i, memory, toWorld);
      if (isEdge(set, i, limits)) this.edged = true;
      if (!walking || !response.carries(set, i, limits)) continue;
      const up = set.normal[3 * i + 1]!;
      if (up <= flattest) continue;
      flattest = up;
      this.ground = contact;
    }
  }

  #take(set: ContactSet, i: number, memory: FieldMemory, toWorld: Quaternion): Contact {
    const place = this.contacts.length;
    const contact = (this.#pool[place] ??= new Contact());
    this.contacts.push(contact);
    const { surfels } = memory.kept[set.kept[i]!]!;
    const surfel = set.surfel[i]!;
    const { point, normal } = set;
    contact.point.set(point[3 * i]!, point[3 * i + 1]!, point[3 * i + 2]!).applyQuaternion(toWorld);
    contact.normal
      .set(normal[3 * i]!, normal[3 * i + 1]!, normal[3 * i + 2]!)
      .applyQuaternion(toWorld);
    contact.gap = set.gap[i]!;
    const id = surfels.object[surfel]!;
    contact.object = id === 0 ? null : surfels.objects[id - 1]!;
    contact.instance = surfels.instance[surfel]!;
    return contact;
  }

  /** Looks which sensors the body is in: by their geometry's bounding box, in their own frame. */
  findSensors(sensors: readonly Object3D[], state: CharacterState): void {
    this.#sensors.length = 0;
    for (let i = 0; i < sensors.length; i++) {
      if (isInside(sensors[i]!, state)) this.#sensors.push(sensors[i]!);
    }
  }

  /** Sends `contact` and `separate` for what has changed since the last call. */
  report(events: EventDispatcher<CharacterEventMap>): void {
    const { contacts } = this;
    const told = this.#told;
    for (let i = told.length - 1; i >= 0; i--) {
      const object = told[i]!;
      if (this.#touches(object)) continue;
      told.splice(i, 1);
      events.dispatchEvent({ type: 'separate', object, sensor: false });
    }
    for (let i = 0; i < contacts.length; i++) {
      const { object } = contacts[i]!;
      if (object === null || told.includes(object)) continue;
      told.push(object);
      events.dispatchEvent({ type: 'contact', object, contact: contacts[i]!, sensor: false });
    }
    const sensors = this.#toldSensors;
    for (let i = sensors.length - 1; i >= 0; i--) {
      const object = sensors[i]!;
      if (this.#sensors.includes(object)) continue;
      sensors.splice(i, 1);
      events.dispatchEvent({ type: 'separate', object, sensor: true });
    }
    for (let i = 0; i < this.#sensors.length; i++) {
      const object = this.#sensors[i]!;
      if (sensors.includes(object)) continue;
      sensors.push(object);
      events.dispatchEvent({ type: 'contact', object, contact: null, sensor: true });
    }
  }

  #touches(object: Object3D): boolean {
    for (let i = 0; i < this.contacts.length; i++) {
      if (this.contacts[i]!.object === object) return true;
    }
    return false;
  }
}

/** Does the capsule's axis come within its radius of the sensor's box? */
function isInside(sensor: Object3D, state: CharacterState): boolean {
  const { geometry } = sensor as Mesh;
  if (geometry === undefined) return false;
  if (geometry.boundingBox === null) geometry.computeBoundingBox();
  box.copy(geometry.boundingBox!);
  inverse.copy(sensor.matrixWorld).invert();
  const { radius, height, up, foot } = state;
  const length = height - 2 * radius;
  const pieces = Math.max(1, Math.ceil(length / radius));
  for (let i = 0; i <= pieces; i++) {
    place.copy(foot).addScaledVector(up, radius + (length * i) / pieces);
    near.copy(place).applyMatrix4(inverse).clamp(box.min, box.max).applyMatrix4(sensor.matrixWorld);
    if (near.distanceToSquared(place) <= radius * radius) return true;
  }
  return false;
}

const box = /* @__PURE__ */ new Box3();
const inverse = /* @__PURE__ */ new Matrix4();
const place = /* @__PURE__ */ new Vector3();
const near = /* @__PURE__ */ new Vector3();

function isEdge({ normal, surfaceUp }: ContactSet, i: number, limits: SlideLimits): boolean {
  const up = normal[3 * i + 1]!;
  return up > 0 && surfaceUp[i]! >= limits.slope && surfaceUp[i]! - up > EDGE;
}
