import { Vector3 } from 'three';
import type { FieldMemory } from '../field/FieldMemory.js';
import { isInView, place } from '../field/isInView.js';

/** Distance of the places that are looked at along the way, metres: what is as thick is not passed through. */
const STEP = 0.08;
/** Halvings in search of where the view ends: to 3 mm. */
const HALVINGS = 5;
/** The ball may begin in a niche: it is looked at in full from here on, metres. */
const FULL = 0.3;
/** Part of the ball's radius that is looked at: its rim may touch what it leans on. */
const RIM = 0.85;

/**
 * How much of a ball's way the fields have looked through: its middle and four places of its rim. What lies in the shadow
 * of something may be a wall. Allocates nothing.
 *
 * @param from world space @param direction unit vector
 * @param length of the way, metres
 * @param radius metres
 * @returns metres, 0 to `length`
 */
export function wayInView(
  memory: FieldMemory,
  from: Vector3,
  direction: Vector3,
  length: number,
  radius: number,
): number {
  // Level and steep across the way: as the picture's sides lie.
  aside.set(direction.z, 0, -direction.x);
  if (aside.lengthSq() < 1e-6) aside.set(1, 0, 0);
  aside.normalize();
  above.crossVectors(direction, aside);
  let good = 0;
  if (!isBallInView(memory, middle.copy(from), 0)) return 0;
  while (good < length) {
    let bad = Math.min(length, good + STEP);
    if (isBallInView(memory, at(from, direction, bad), rimAt(bad, radius))) {
      good = bad;
      continue;
    }
    for (let i = 0; i < HALVINGS; i++) {
      const half = 0.5 * (good + bad);
      if (isBallInView(memory, at(from, direction, half), rimAt(half, radius))) good = half;
      else bad = half;
    }
    return good;
  }
  return length;
}

const at = (from: Vector3, direction: Vector3, way: number) =>
  middle.copy(from).addScaledVector(direction, way);

const rimAt = (way: number, radius: number) => RIM * radius * Math.min(1, way / FULL);

function isBallInView(memory: FieldMemory, ball: Vector3, rim: number): boolean {
  if (!isInViewAt(memory, ball, aside, 0)) return false;
  return (
    rim === 0 ||
    (isInViewAt(memory, ball, aside, rim) &&
      isInViewAt(memory, ball, aside, -rim) &&
      isInViewAt(memory, ball, above, rim) &&
      isInViewAt(memory, ball, above, -rim))
  );
}

function isInViewAt(memory: FieldMemory, ball: Vector3, axis: Vector3, off: number): boolean {
  place[0] = ball.x + off * axis.x;
  place[1] = ball.y + off * axis.y;
  place[2] = ball.z + off * axis.z;
  return isInView(memory);
}

const aside = /* @__PURE__ */ new Vector3();
const above = /* @__PURE__ */ new Vector3();
const middle = /* @__PURE__ */ new Vector3();
