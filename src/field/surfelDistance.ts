import { axis } from './pieces.js';
import { CORNERS, STRIDE } from './layout.js';
import type { Surfels } from './Surfels.js';

/**
 * What `surfelDistance` found: the surfel's nearest point x, y, z, relative to `Surfels.origin`; the height of the
 * segment's nearest point; their distance; and 1 if the point lies on the surfel's border, else 0.
 */
export const nearest = /* @__PURE__ */ new Float64Array(6);

/** A place relative to the surfel's own point. */
const from = /* @__PURE__ */ new Float64Array(3);

/**
 * Distance between surfel `i` and `axis`, to well below a millimetre for surfels much smaller than they are far. Writes
 * `nearest`.
 */
export function surfelDistance(surfels: Surfels, i: number): void {
  const { data } = surfels;
  const o = STRIDE * i;
  const px = data[o]!;
  const py = data[o + 1]!;
  const pz = data[o + 2]!;
  const low = axis[2]!;
  const high = axis[3]!;
  let y = py < low ? low : py > high ? high : py;
  from[0] = axis[0]! - px;
  from[1] = y - py;
  from[2] = axis[1]! - pz;
  nearestTo(data, o);
  for (let round = 0; round < 3; round++) {
    const wanted = py + nearest[1]!;
    const next = wanted < low ? low : wanted > high ? high : wanted;
    if (Math.abs(next - y) < 1e-5) break;
    y = next;
    from[1] = y - py;
    nearestTo(data, o);
  }
  nearest[0]! += px;
  nearest[1]! += py;
  nearest[2]! += pz;
  nearest[3] = y;
}

/** Nearest point of a surfel to `from`, relative to the surfel's own point; writes `nearest`. */
function nearestTo(data: Float32Array, o: number): void {
  const x = from[0]!;
  const y = from[1]!;
  const z = from[2]!;
  const tx = data[o + 6]!;
  const ty = data[o + 7]!;
  const tz = data[o + 8]!;
  const bx = data[o + 9]!;
  const by = data[o + 10]!;
  const bz = data[o + 11]!;
  const height = x * data[o + 3]! + y * data[o + 4]! + z * data[o + 5]!;
  const u = x * tx + y * ty + z * tz;
  const v = x * bx + y * by + z * bz;
  let bestU = u;
  let bestV = v;
  const corners = data[o + CORNERS]!;
  const first = o + CORNERS + 1;
  let ax = data[first + 2 * corners - 2]!;
  let ay = data[first + 2 * corners - 1]!;
  let inside = true;
  let sign = 0;
  // The nearest place on the border, should it not lie over the surfel. Corners may run either way round.
  let best = Infinity;
  for (let corner = 0; corner < corners; corner++) {
    const cx = data[first + 2 * corner]!;
    const cy = data[first + 2 * corner + 1]!;
    const ex = cx - ax;
    const ey = cy - ay;
    const wx = u - ax;
    const wy = v - ay;
    const turn = ex * wy - ey * wx;
    if (turn > 1e-12) {
      if (sign < 0) inside = false;
      sign = 1;
    } else if (turn < -1e-12) {
      if (sign > 0) inside = false;
      sign = -1;
    }
    const length = ex * ex + ey * ey;
    let t = length > 1e-14 ? (wx * ex + wy * ey) / length : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    const dx = wx - t * ex;
    const dy = wy - t * ey;
    const squared = dx * dx + dy * dy;
    if (squared < best) {
      best = squared;
      bestU = ax + t * ex;
      bestV = ay + t * ey;
    }
    ax = cx;
    ay = cy;
  }
  // A surfel without extent turns no way at all.
  const border = !inside || sign === 0;
  if (!border) {
    bestU = u;
    bestV = v;
    best = 0;
  }
  nearest[0] = bestU * tx + bestV * bx;
  nearest[1] = bestU * ty + bestV * by;
  nearest[2] = bestU * tz + bestV * bz;
  nearest[4] = Math.sqrt(height * height + best);
  nearest[5] = border ? 1 : 0;
}
