import { Quaternion, Vector3 } from 'three';

/** A pole or a rail near a centre at the origin, its axis along Y before it is turned. Metres. */
export interface ThinThing {
  readonly round: boolean;
  readonly sides: number;
  readonly width: number;
  readonly length: number;
  readonly middle: Vector3;
  readonly turn: Quaternion;
  /** From its surface to a point given relative to its middle, world axes; negative inside. */
  distance(point: Vector3): number;
}

const UP = new Vector3(0, 1, 0);
/** Sides of a round pole: it is at least cos(π/16) = 98 % as wide from every side as its width says. */
const SIDES = 16;

/** Mulberry32. */
export function seededRandom(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/**
 * A 10 mm pole whose axis passes the centre at 0.1 to 0.6 m, or a 30 mm rail at 0.2 to 1.6 m. A part of them anywhere; a
 * part upright or level; a part where they are hardest to see: along the texels' rows between two of them, along a
 * seam of the faces, and at the faces' corners.
 */
export function thinThing(
  kind: 'pole' | 'rail',
  random: () => number,
  width = kind === 'pole' ? 0.01 : 0.03,
): ThinThing {
  const pole = kind === 'pole';
  const between = (low: number, high: number) => low + (high - low) * random();
  const any = () => {
    const v = new Vector3();
    do v.set(between(-1, 1), between(-1, 1), between(-1, 1));
    while (v.length() > 1 || v.length() < 0.1);
    return v.normalize();
  };
  const axis = new Vector3();
  const toward = new Vector3();
  const manner = Math.floor(5 * random());
  const sign = () => (random() < 0.5 ? -1 : 1);
  if (manner === 0) {
    axis.copy(UP);
    toward.copy(any());
  } else if (manner === 1) {
    axis.copy(any()).setY(0).normalize();
    toward.copy(any());
  } else if (manner === 2) {
    axis.copy(any());
    toward.copy(any());
  } else {
    // Along one of the axes, in any of the three's turns: on the line between two columns of texels (128 and 32 a face
    // have those of 32 in common), which for the last is the seam.
    const column = manner === 3 ? Math.floor(33 * random()) / 16 - 1 : sign();
    axis.set(0, 1, 0);
    toward.set(sign(), 0, column);
    if (manner === 4 && random() < 0.5) {
      // In the plane of the seam, at a slant: it passes near a corner, or through it.
      toward.set(toward.x, between(-1, 1), toward.z);
      axis.add(new Vector3(toward.x, 0, toward.z).multiplyScalar(between(-1, 1))).normalize();
    }
    for (let turns = Math.floor(3 * random()); turns > 0; turns--) {
      axis.set(axis.y, axis.z, axis.x);
      toward.set(toward.y, toward.z, toward.x);
    }
  }
  // The axis' nearest point to the centre lies straight across it.
  toward.addScaledVector(axis, -toward.dot(axis)).normalize();
  const length = pole ? between(0.3, 2) : between(0.6, 3);
  const nearest = pole ? between(0.1, 0.6) : between(0.2, 1.6);
  const slide = between(-0.45, 0.45) * length;
  const turn = new Quaternion().setFromUnitVectors(UP, axis);
  turn.multiply(new Quaternion().setFromAxisAngle(UP, between(0, 2 * Math.PI)));
  const round = pole || random() < 0.5;
  const middle = toward.multiplyScalar(nearest).addScaledVector(axis, slide);
  const back = turn.clone().invert();
  return {
    round,
    sides: SIDES,
    width,
    length,
    middle,
    turn,
    distance(point) {
      const { x, y, z } = point.clone().applyQuaternion(back);
      const along = Math.abs(y) - length / 2;
      if (round) return outside(Math.sqrt(x * x + z * z) - width / 2, along, -1);
      return outside(Math.abs(x) - width / 2, along, Math.abs(z) - width / 2);
    },
  };
}

/** Distance to a product of intervals, from how far outside each a point is. */
function outside(a: number, b: number, c: number): number {
  const inside = Math.min(Math.max(a, b, c), 0);
  return inside + Math.hypot(Math.max(a, 0), Math.max(b, 0), Math.max(c, 0));
}
