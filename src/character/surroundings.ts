import { Vector3 } from 'three';
import type { AxisMaxima } from '../cube/AxisMaxima.js';
import { directionTexel } from '../cube/texelDirections.js';
import { axisMaximaAt } from '../field/axisMaxima.js';
import type { SurfaceField } from '../field/SurfaceField.js';
import { limitTravel } from '../response/limitTravel.js';
import type { CharacterCollider } from './CharacterCollider.js';

/** A texel's diagonal in the middle of a face of N texels, as a part of N and of the distance: 2·√2. */
const TEXEL_DIAGONAL = 2 * Math.SQRT2;

/** Halvings in search of the longest travel: to 1/64 of it. */
const HALVINGS = 6;

/**
 * Can the collider's newest data vouch for a sphere? Not if there are none, or if they were drawn too far away: the
 * paper's maxima vouch within rMax - rMin of their centre, a surface field for spheres wholly within its reach, there
 * where its points lie no more than half a radius apart (1.98 m of 32 texels for a radius of 0.35 m).
 *
 * @param center the sphere's middle, world space, metres
 * @param radius metres; the paper's maxima bring their own
 */
export function vouchesFor(collider: CharacterCollider, center: Vector3, radius: number): boolean {
  const { maxima, field } = collider;
  if (maxima !== null) return center.distanceTo(maxima.center) <= maxima.rMax - maxima.rMin;
  if (field === null) return false;
  const farthest = center.distanceTo(field.center) + radius;
  return farthest <= field.far && farthest * (TEXEL_DIAGONAL / field.resolution) <= radius / 2;
}

/**
 * Is `place` nearer to the field's centre than the surface seen in its direction, by at least `margin` metres? What is
 * not may lie behind something.
 */
function knownFree(field: SurfaceField, place: Vector3, margin: number): boolean {
  const x = place.x - field.center.x;
  const y = place.y - field.center.y;
  const z = place.z - field.center.z;
  const distance = Math.sqrt(x * x + y * y + z * z);
  if (distance === 0) return true;
  return distance + margin < field.distance[directionTexel(x, y, z, field.resolution)]!;
}

/**
 * What the collider's newest data say about a sphere, or null where they cannot vouch for it. The paper's maxima are
 * taken as they are (their `rMax` is the sphere's radius); a surface field is seen again from `center`.
 *
 * @param center the sphere's middle, world space, metres
 * @param scratch receives what a surface field is reduced to; its `rMin` and `rMax` are the sphere's
 */
export function surroundings(
  collider: CharacterCollider,
  center: Vector3,
  scratch: AxisMaxima,
): AxisMaxima | null {
  if (!vouchesFor(collider, center, scratch.rMax)) return null;
  return collider.maxima ?? axisMaximaAt(collider.field!, center, scratch);
}

/**
 * The part of `travel`, 0 to 1, that the data vouch for: see `limitTravel`; and a surface field's known-free space is
 * not left.
 *
 * @param seen what `surroundings` returned
 */
export function vouchedTravel(
  collider: CharacterCollider,
  seen: AxisMaxima,
  center: Vector3,
  travel: Vector3,
): number {
  const part = limitTravel(seen, center, travel);
  const { maxima, field } = collider;
  if (maxima !== null || field === null) return part;
  if (free(collider, field, seen, there.copy(center).addScaledVector(travel, part))) return part;
  // As far as it goes, not nothing: a coarse field vouches for less than a slow frame's travel.
  let low = 0;
  let high = part;
  for (let i = 0; i < HALVINGS; i++) {
    const middle = (low + high) / 2;
    if (free(collider, field, seen, there.copy(center).addScaledVector(travel, middle)))
      low = middle;
    else high = middle;
  }
  return low;
}

/** May the sphere stand at `place`, as far as the field can tell? */
function free(
  collider: CharacterCollider,
  field: SurfaceField,
  seen: AxisMaxima,
  place: Vector3,
): boolean {
  return vouchesFor(collider, place, seen.rMax) && knownFree(field, place, seen.rMin / 2);
}

/** Was the collider's newest data drawn around `center`, to a thousandth of the sphere's radius? */
export function drawnAt(collider: CharacterCollider, center: Vector3, radius: number): boolean {
  const drawn = (collider.maxima ?? collider.field)?.center;
  return drawn !== undefined && drawn.distanceTo(center) <= radius / 1000;
}

const there = /* @__PURE__ */ new Vector3();
