import { type Matrix4, Object3D, Vector3 } from 'three';
import type { SurfaceField } from '../../../src/field/SurfaceField.js';
import type { Solid } from './Solid.js';

/** How deep a body is in what, metres; negative is the gap to the nearest. */
export interface Judgement {
  depth: number;
  solid: Solid | null;
}

/** Metres beyond the body within which `judge` looks; farther things count as this far. */
const LOOK = 0.5;

/** Solids in a frame of their own (`root`), drawn as fields and judged exactly. */
export class World {
  /** Turn it to turn the whole world; every solid's object hangs below it. */
  readonly root = new Object3D();
  readonly solids: Solid[] = [];
  /** Objects that report and do not block: meshes with `userData.sensor`. */
  readonly sensors: Object3D[] = [];

  constructor(...solids: (Solid | Solid[])[]) {
    this.add(...solids.flat());
  }

  add(...solids: Solid[]): this {
    for (const solid of solids) {
      this.solids.push(solid);
      // One may hang below another's object: a wall on a turntable.
      if (solid.object.parent === null) this.root.add(solid.object);
    }
    return this;
  }

  remove(solid: Solid): void {
    this.solids.splice(this.solids.indexOf(solid), 1);
    solid.object.removeFromParent();
  }

  addSensor(sensor: Object3D): this {
    sensor.userData.sensor = true;
    this.sensors.push(sensor);
    this.root.add(sensor);
    return this;
  }

  /** Brings world matrices up to date. */
  refresh(): void {
    this.root.updateMatrixWorld();
    for (const solid of this.solids) solid.refresh();
  }

  /** Fills a field as a cubemap drawn at `center` (world space) would be. Call `refresh` before. */
  draw(field: SurfaceField, center: Vector3): void {
    field.center.copy(center);
    field.clearObjects();
    field.distance.fill(Infinity);
    field.normal.fill(0);
    field.front.fill(0);
    field.object.fill(0);
    field.instance.fill(0);
    for (const solid of this.solids) {
      if (solid.object.visible && withinReach(solid, center, field.far)) {
        drawSolid(field, solid, field.addObject(solid.shown ?? solid.object, !solid.deforms));
      }
    }
  }

  /**
   * How deep a capsule is in the solids, exactly. Call `refresh` before.
   *
   * @param foot its lowest point, world space
   * @param up unit, world space
   */
  judge(foot: Vector3, up: Vector3, radius: number, height: number, target: Judgement): Judgement {
    a.copy(foot).addScaledVector(up, radius);
    b.copy(foot).addScaledVector(up, height - radius);
    target.depth = -LOOK;
    target.solid = null;
    for (const solid of this.solids) {
      if (!solid.object.visible) continue;
      p.copy(a).applyMatrix4(solid.inverse);
      q.copy(b).applyMatrix4(solid.inverse);
      // Nothing of it can be nearer than what is known already.
      const reach = solid.bound + height - radius - target.depth;
      if (p.lengthSq() > reach * reach) continue;
      const depth = radius - solid.distance(p.x, p.y, p.z, q.x, q.y, q.z);
      if (depth > target.depth) {
        target.depth = depth;
        target.solid = solid;
      }
    }
    return target;
  }
}

const a = new Vector3();
const b = new Vector3();
const p = new Vector3();
const q = new Vector3();

/** Whether a solid may be seen from `center` within `far`, where it is or was. */
export function withinReach(
  solid: Solid,
  center: Vector3,
  far: number,
  { elements: e }: Matrix4 = solid.object.matrixWorld,
): boolean {
  const reach = solid.bound + far;
  const x = e[12]! - center.x;
  const y = e[13]! - center.y;
  const z = e[14]! - center.z;
  return x * x + y * y + z * z <= reach * reach;
}

function drawSolid(field: SurfaceField, solid: Solid, number: number): void {
  const { direction, distance, normal, front, object, far, center } = field;
  const w = solid.object.matrixWorld.elements;
  const o = p.copy(center).applyMatrix4(solid.inverse);
  const ox = o.x;
  const oy = o.y;
  const oz = o.z;
  // Rays outside the cone around its bounding ball miss it.
  const cx = w[12]! - center.x;
  const cy = w[13]! - center.y;
  const cz = w[14]! - center.z;
  const away = Math.sqrt(cx * cx + cy * cy + cz * cz);
  const sine = solid.bound / away;
  const least = sine < 1 ? away * Math.sqrt(1 - sine * sine) - 1e-6 : -Infinity;
  for (let i = 0, k = 0; i < field.count; i++, k += 3) {
    const x = direction[k]!;
    const y = direction[k + 1]!;
    const z = direction[k + 2]!;
    if (x * cx + y * cy + z * cz < least) continue;
    const dx = w[0]! * x + w[1]! * y + w[2]! * z;
    const dy = w[4]! * x + w[5]! * y + w[6]! * z;
    const dz = w[8]! * x + w[9]! * y + w[10]! * z;
    const t = solid.cast(ox, oy, oz, dx, dy, dz);
    if (t >= distance[i]! || t > far) continue;
    distance[i] = t;
    object[i] = number;
    const { nx, ny, nz } = solid;
    const faces = nx * dx + ny * dy + nz * dz < 0;
    const sign = faces ? 1 : -1;
    front[i] = faces ? 1 : 0;
    normal[k] = sign * (w[0]! * nx + w[4]! * ny + w[8]! * nz);
    normal[k + 1] = sign * (w[1]! * nx + w[5]! * ny + w[9]! * nz);
    normal[k + 2] = sign * (w[2]! * nx + w[6]! * ny + w[10]! * nz);
  }
}
