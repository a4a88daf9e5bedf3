/**
 * What tells most surfels, and whole blocks of them, apart from what a question is about, without a closer look:
 * `PIECE` numbers each, closely packed. A point x, y, z; how far anything of it lies from there at most; the normal x,
 * y, z of its plane; and its kind.
 */
export const PIECE = 8;
/** Of many planes: a block. */
export const MIXED = 0;
/** In one plane, which ends there. */
export const ENDS = 1;
/** In one plane, which goes on all around: where it is nearest only beyond its own border, a neighbour is nearer. */
export const GOES_ON = 2;

/** Where pieces go that no longer hold, metres. */
export const AWAY = 1e6;
/** A block's surfels lie in one plane if their normals are closer than this (0.8°) and none is farther off, metres. */
const SAME_NORMAL = 0.9999;
const SAME_PLANE = 1e-4;
/** How far beyond its border a place must lie to be some neighbour's for sure, as a part of its size. */
const ASIDE = 0.2;

/**
 * An upright segment that questions are about: x, z, its lower and upper end's y, and how far from it anything is of
 * interest; body's frame, metres, relative to `Surfels.origin`. Set it before. (Numbers handed over as arguments would be
 * wrapped in objects, thousands a step.)
 */
export const axis = /* @__PURE__ */ new Float64Array(5);

/** Does nothing of a piece come nearer to `axis` than wanted, that no neighbour of it does? */
export function isOutOfReach(piece: Float32Array, p: number): boolean {
  const dx = piece[p]! - axis[0]!;
  const dz = piece[p + 2]! - axis[1]!;
  const y = piece[p + 1]!;
  const low = axis[2]!;
  const high = axis[3]!;
  const dy = y < low ? low - y : y > high ? high - y : 0;
  const extent = piece[p + 3]!;
  const reached = axis[4]!;
  const within = reached + extent;
  const squared = dx * dx + dy * dy + dz * dz;
  if (squared >= within * within) return true;
  const kind = piece[p + 7]!;
  if (kind === MIXED) return false;
  // The plane is never farther than what lies in it.
  const level = -dx * piece[p + 4]! - dz * piece[p + 6]!;
  const up = piece[p + 5]!;
  const atLow = level + up * (low - y);
  const atHigh = level + up * (high - y);
  if (atLow >= reached ? atHigh >= reached : atLow <= -reached && atHigh <= -reached) return true;
  if (kind === ENDS) return false;
  const height = level + up * dy;
  const border = (1 + ASIDE) * extent;
  return squared - height * height > border * border;
}

/** Finds a ball around the balls of `from` to (less) `to`, of any planes. */
function boundBalls(
  balls: Float32Array,
  from: number,
  to: number,
  target: Float32Array,
  t: number,
): void {
  let x = 0;
  let y = 0;
  let z = 0;
  let n = 0;
  for (let p = PIECE * from; p < PIECE * to; p += PIECE) {
    if (balls[p] === AWAY) continue;
    x += balls[p]!;
    y += balls[p + 1]!;
    z += balls[p + 2]!;
    n++;
  }
  x = n > 0 ? x / n : AWAY;
  y /= Math.max(1, n);
  z /= Math.max(1, n);
  let extent = 0;
  for (let p = PIECE * from; p < PIECE * to; p += PIECE) {
    if (balls[p] === AWAY) continue;
    const dx = balls[p]! - x;
    const dy = balls[p + 1]! - y;
    const dz = balls[p + 2]! - z;
    extent = Math.max(extent, Math.sqrt(dx * dx + dy * dy + dz * dz) + balls[p + 3]!);
  }
  const o = PIECE * t;
  target[o] = x;
  target[o + 1] = y;
  target[o + 2] = z;
  // Rounded, it must still hold all.
  target[o + 3] = extent * (1 + 1e-6);
}

/** Finds what tells block `b`, made of pieces `from` to (less) `to`, apart. */
export function boundBlock(
  piece: Float32Array,
  from: number,
  to: number,
  block: Float32Array,
  b: number,
): void {
  boundBalls(piece, from, to, block, b);
  const o = PIECE * b;
  let kind = GOES_ON;
  const nx = piece[PIECE * from + 4]!;
  const ny = piece[PIECE * from + 5]!;
  const nz = piece[PIECE * from + 6]!;
  for (let p = PIECE * from; p < PIECE * to; p += PIECE) {
    if (piece[p] === AWAY) continue;
    const dx = piece[p]! - block[o]!;
    const dy = piece[p + 1]! - block[o + 1]!;
    const dz = piece[p + 2]! - block[o + 2]!;
    const alike = nx * piece[p + 4]! + ny * piece[p + 5]! + nz * piece[p + 6]!;
    const off = Math.abs(nx * dx + ny * dy + nz * dz);
    if (piece[p + 7] !== GOES_ON || alike < SAME_NORMAL || off > SAME_PLANE) kind = MIXED;
  }
  block[o + 4] = nx;
  block[o + 5] = ny;
  block[o + 6] = nz;
  block[o + 7] = kind;
}
