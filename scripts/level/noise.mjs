// Seeded noise, so that the level comes out byte for byte the same on every run.

/** A hash of up to three integers to [0, 1). */
export function hash(x, y = 0, seed = 0) {
  let h = Math.imul(x, 0x27d4eb2d) ^ Math.imul(y, 0x165667b1) ^ Math.imul(seed + 1, 0x9e3779b1);
  h = Math.imul(h ^ (h >>> 15), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return ((h ^ (h >>> 16)) >>> 0) / 2 ** 32;
}

const wrap = (i, period) => (period ? ((i % period) + period) % period : i);
const fade = (t) => t * t * t * (t * (t * 6 - 15) + 10);

/** Value noise in [0, 1], smooth to the second derivative; repeats every `period` (and `periodY`) cells if given. */
export function noise(x, y, seed = 0, period = 0, periodY = period) {
  const ix = Math.floor(x);
  const iy = Math.floor(y);
  const fx = fade(x - ix);
  const fy = fade(y - iy);
  const at = (dx, dy) => hash(wrap(ix + dx, period), wrap(iy + dy, periodY), seed);
  const low = at(0, 0) + (at(1, 0) - at(0, 0)) * fx;
  const high = at(0, 1) + (at(1, 1) - at(0, 1)) * fx;
  return low + (high - low) * fy;
}

/** A sum of octaves of `noise`, in [0, 1]. */
export function fbm(x, y, { seed = 0, octaves = 4, period = 0 } = {}) {
  let sum = 0;
  let weight = 0.5;
  let total = 0;
  for (let octave = 0; octave < octaves; octave++) {
    const scale = 2 ** octave;
    sum += weight * noise(x * scale, y * scale, seed + octave, period * scale);
    total += weight;
    weight /= 2;
  }
  return sum / total;
}

/** 0 below `a`, 1 above `b`, and smooth between to the second derivative. */
export const smootherstep = (a, b, x) => fade(Math.min(1, Math.max(0, (x - a) / (b - a))));
