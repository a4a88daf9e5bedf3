import { Quaternion, Vector3 } from 'three';
import { seeded } from '../../e2e/support/axisScenes.js';
import type { Capsule } from '../../src/field/Capsule.js';
import { FieldMemory } from '../../src/field/FieldMemory.js';
import { PIECE } from '../../src/field/pieces.js';
import { SurfaceField } from '../../src/field/SurfaceField.js';
import { CORNERS, STRIDE } from '../../src/field/layout.js';
import type { Surfels } from '../../src/field/Surfels.js';
import type { Judgement, World } from './world/World.js';

/** Fields of analytic worlds and what surfels say of themselves, for the tests of `src/field`. */

export const UP = /* @__PURE__ */ new Vector3(0, 1, 0);
/** World axes and body's axes are the same. */
export const UPRIGHT = /* @__PURE__ */ new Quaternion();

let serial = 0;

/** What a cubemap drawn there would see. */
export function drawn(
  world: World,
  center: Vector3,
  { resolution = 32, far = 1.8 } = {},
): SurfaceField {
  world.refresh();
  const field = new SurfaceField(resolution, far);
  world.draw(field, center);
  field.serial = ++serial;
  return field;
}

/** A memory of one field drawn there. */
export function remembered(
  world: World,
  center: Vector3,
  options: { resolution?: number; far?: number; toBody?: Quaternion } = {},
): FieldMemory {
  const memory = new FieldMemory(options.toBody ?? UPRIGHT);
  memory.take(drawn(world, center, options));
  return memory;
}

export const capsuleAt = (
  x: number,
  y: number,
  z: number,
  radius = 0.3,
  height = 1.8,
): Capsule => ({
  x,
  y,
  z,
  radius,
  height,
});

/** Seeded numbers. */
export function dice(seed: number) {
  const random = seeded(seed);
  return (low: number, high: number): number => low + (high - low) * random();
}

/** The corners of surfel `i` in the body's frame, metres; none of one without extent. */
export function cornersOf({ data, origin }: Surfels, i: number): Vector3[] {
  const o = STRIDE * i;
  const at = (k: number) => new Vector3(data[o + k], data[o + k + 1], data[o + k + 2]);
  const corners: Vector3[] = [];
  for (let c = 0; c < data[o + CORNERS]!; c++) {
    const [u, v] = [data[o + CORNERS + 1 + 2 * c]!, data[o + CORNERS + 2 + 2 * c]!];
    corners.push(at(0).addScaledVector(at(6), u).addScaledVector(at(9), v).add(origin));
  }
  return corners;
}

/** Distance of a point from a convex polygon, by plain vector algebra in doubles. */
export function polygonDistance(point: Vector3, corners: readonly Vector3[]): number {
  let best = Infinity;
  const normal = new Vector3();
  for (let c = 0; c < corners.length; c++) {
    const a = corners[c]!;
    const b = corners[(c + 1) % corners.length]!;
    normal.add(new Vector3().crossVectors(a.clone().sub(corners[0]!), b.clone().sub(corners[0]!)));
    const edge = b.clone().sub(a);
    const t = point.clone().sub(a).dot(edge) / edge.lengthSq();
    const foot = a.clone().addScaledVector(edge, Math.min(1, Math.max(0, t || 0)));
    best = Math.min(best, foot.distanceTo(point));
  }
  if (normal.lengthSq() < 1e-20) return best;
  normal.normalize();
  const inside = corners.every((a, c) => {
    const edge = corners[(c + 1) % corners.length]!.clone().sub(a);
    return edge.cross(point.clone().sub(a)).dot(normal) >= 0;
  });
  return inside ? Math.abs(point.clone().sub(corners[0]!).dot(normal)) : best;
}

/** Distance of a point (body's frame) from the nearest surfel. */
export function unionDistance(surfels: Surfels, point: Vector3): number {
  let best = Infinity;
  surfels.findAll();
  for (let i = 0; i < surfels.count; i++) {
    const o = STRIDE * i;
    const middle = new Vector3(...surfels.data.subarray(o, o + 3)).add(surfels.origin);
    if (middle.distanceTo(point) - surfels.piece[PIECE * i + 3]! > best) continue;
    best = Math.min(best, polygonDistance(point, cornersOf(surfels, i)));
  }
  return best;
}

const judgement: Judgement = { depth: 0, solid: null };

/** The exact gap between a capsule and a world, metres, at most 0.5; up is +Y. */
export function exactGap(world: World, { x, y, z, radius, height }: Capsule): number {
  return -world.judge(new Vector3(x, y, z), UP, radius, height, judgement).depth;
}
