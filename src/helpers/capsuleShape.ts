import {
  type BufferAttribute,
  BufferGeometry,
  Float32BufferAttribute,
  LatheGeometry,
  Vector2,
} from 'three';

/** Points around a ring, and along a quarter of one. */
const AROUND = 48;
const QUARTER = AROUND / 4;
/** Angles of the lines that run from foot to crown. */
const MERIDIANS = [0, 1, 2, 3];

/** A geometry in the shape of a capsule that may become another one: no new buffers for that. */
export interface CapsuleShape {
  readonly geometry: BufferGeometry;
  /** Takes the shape of a capsule of that radius from `low` to `high`, along Y, metres. */
  fit(radius: number, low: number, high: number): void;
}

/** @param points of two half balls of radius 1 around the origin @param upper whether a point is the upper one's */
function stretchable(
  geometry: BufferGeometry,
  points: Float32Array,
  upper: (point: number) => boolean,
): CapsuleShape {
  const position = geometry.getAttribute('position') as BufferAttribute;
  return {
    geometry,
    fit(radius, low, high) {
      for (let i = 0; i < position.count; i++) {
        const middle = upper(i) ? high - radius : low + radius;
        position.setXYZ(
          i,
          radius * points[3 * i]!,
          middle + radius * points[3 * i + 1]!,
          radius * points[3 * i + 2]!,
        );
      }
      position.needsUpdate = true;
    },
  };
}

/** As lines: a ring where each half ball begins, and four lines from foot to crown. */
export function capsuleLines(): CapsuleShape {
  const points: number[] = [];
  const isUpper: boolean[] = [];
  const add = (x: number, y: number, z: number, upper: boolean) => {
    points.push(x, y, z);
    isUpper.push(upper);
  };
  for (const upper of [false, true]) {
    for (let i = 0; i < AROUND; i++) {
      for (const end of [i, i + 1]) {
        const angle = (2 * Math.PI * end) / AROUND;
        add(Math.cos(angle), 0, Math.sin(angle), upper);
      }
    }
  }
  for (const meridian of MERIDIANS) {
    // Between the axes: straight ahead is left free for who looks out of it.
    const around = ((meridian + 0.5) * Math.PI) / 2;
    const along = (angle: number, upper: boolean) =>
      add(
        Math.cos(angle) * Math.cos(around),
        Math.sin(angle),
        Math.cos(angle) * Math.sin(around),
        upper,
      );
    for (let i = -QUARTER; i < QUARTER; i++) {
      along((i * Math.PI) / (2 * QUARTER), i >= 0);
      along(((i + 1) * Math.PI) / (2 * QUARTER), i >= 0);
    }
    along(0, false);
    along(0, true);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(points, 3));
  return stretchable(geometry, Float32Array.from(points), (i) => isUpper[i]!);
}

/** As a skin. */
export function capsuleHull(): CapsuleShape {
  const profile: Vector2[] = [];
  for (const start of [-QUARTER, 0]) {
    for (let i = start; i <= start + QUARTER; i++) {
      const angle = (i * Math.PI) / (2 * QUARTER);
      profile.push(new Vector2(Math.max(0, Math.cos(angle)), Math.sin(angle)));
    }
  }
  const geometry = new LatheGeometry(profile, AROUND);
  const points = Float32Array.from(geometry.getAttribute('position').array);
  return stretchable(geometry, points, (i) => i % profile.length > QUARTER);
}
