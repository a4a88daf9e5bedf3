import type { Mesh, Object3D } from 'three';
import type { Warnings } from '../Warnings.js';

/** Told of already, by whichever collider: a crowd's, or the camera's, see the same scene. */
const obstacles = /* @__PURE__ */ new WeakSet<Object3D>();
const sensors = /* @__PURE__ */ new WeakSet<Object3D>();

/** Says once of each of the user's objects why it does not do what it seems to be there for. */
export class ObjectWarnings {
  readonly #warnings: Warnings;

  constructor(warnings: Warnings) {
    this.#warnings = warnings;
  }

  /** Of a mesh that cannot be drawn. */
  obstacle(mesh: Mesh, fault: string): void {
    if (!isNew(mesh, obstacles)) return;
    this.#warnings.once(`${nameOf(mesh)} ${fault}; it is no obstacle.`, `obstacle ${mesh.uuid}`);
  }

  /** Of a sensor without a geometry of its own: nobody is ever in it. One that only holds sensors is all right. */
  sensor(object: Object3D): void {
    if (!isNew(object, sensors) || holdsSensor(object)) return;
    const what = `the sensor ${nameOf(object)} has no geometry, so nobody is ever in it`;
    this.#warnings.once(`${what}; set userData.sensor = true on a mesh.`, `sensor ${object.uuid}`);
  }
}

function isNew(object: Object3D, known: WeakSet<Object3D>): boolean {
  if (known.has(object)) return false;
  known.add(object);
  return true;
}

function nameOf({ type, name, uuid }: Object3D): string {
  return `${type} ${name === '' ? uuid : `"${name}"`}`;
}

function holdsSensor(object: Object3D): boolean {
  return object.children.some(
    (child) =>
      (child.userData.sensor === true && !!(child as Mesh).geometry?.attributes?.position) ||
      holdsSensor(child),
  );
}
