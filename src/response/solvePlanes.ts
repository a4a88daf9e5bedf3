/** Planes taken into account at once; more than this many different ones at one place are noise. */
export const MOST_PLANES = 8;

/** Half-spaces n · d >= b that a displacement d must lie in. */
export class Planes {
  count = 0;
  /** x, y, z each. */
  readonly normal = new Float64Array(3 * MOST_PLANES);
  readonly bound = new Float64Array(MOST_PLANES);

  clear(): void {
    this.count = 0;
  }

  /** What `addNext` adds: x, y, z, bound. */
  readonly next = new Float64Array(4);

  /** Adds one; of too many the least urgent, the one with the lowest bound, is dropped. */
  add(x: number, y: number, z: number, bound: number): void {
    const { next } = this;
    next[0] = x;
    next[1] = y;
    next[2] = z;
    next[3] = bound;
    this.addNext();
  }

  /** The same, of `next`: fractions handed over as arguments are objects on the heap where a call is not inlined. */
  addNext(): void {
    const { next } = this;
    let slot = this.count;
    if (slot === MOST_PLANES) {
      slot = 0;
      for (let i = 1; i < MOST_PLANES; i++) if (this.bound[i]! < this.bound[slot]!) slot = i;
      if (this.bound[slot]! >= next[3]!) return;
    } else {
      this.count++;
    }
    this.normal[3 * slot] = next[0]!;
    this.normal[3 * slot + 1] = next[1]!;
    this.normal[3 * slot + 2] = next[2]!;
    this.bound[slot] = next[3]!;
  }
}

/** A displacement being solved. */
export interface Solution {
  x: number;
  y: number;
  z: number;
}

/** A plane counts as kept to within this, metres. */
const TOLERANCE = 1e-6;
/** Halvings in search of the least slack. */
const HALVINGS = 12;

/**
 * The displacement nearest to `d` that all planes allow: `d` itself, its foot on one plane, on the crease of two, or the
 * corner of three, whichever is allowed and nearest. So it does not depend on the planes' order, and slides along walls,
 * creases and into corners without trembling.
 *
 * Where the planes allow nothing (squeezed), all give way by the same least slack: the middle of what is too narrow.
 *
 * @param d overwritten with the solution
 * @returns the slack, metres; 0 if the planes allow it
 */
export function solvePlanes(planes: Planes, d: Solution): number {
  wanted[0] = d.x;
  wanted[1] = d.y;
  wanted[2] = d.z;
  if (solve(planes, 0)) {
    give(d);
    return 0;
  }
  let low = 0;
  let high = 0;
  for (let i = 0; i < planes.count; i++) high = Math.max(high, planes.bound[i]!);
  for (let i = 0; i < HALVINGS; i++) {
    const middle = (low + high) / 2;
    if (solve(planes, middle)) high = middle;
    else low = middle;
  }
  // With all bounds at 0 or less, standing still is allowed.
  if (solve(planes, high)) give(d);
  else d.x = d.y = d.z = 0;
  return high;
}

/** Scratch in typed arrays: numbers handed over as arguments would be wrapped in objects. */
const wanted = /* @__PURE__ */ new Float64Array(3);
/** The nearest allowed displacement so far, and how far from the wanted one it is, squared. */
const found = /* @__PURE__ */ new Float64Array(4);
/** A displacement to be considered. */
const candidate = /* @__PURE__ */ new Float64Array(3);

function give(d: Solution): void {
  d.x = found[0]!;
  d.y = found[1]!;
  d.z = found[2]!;
}

/** Fills `found` for bounds lowered by `slack`; returns whether anything is allowed. */
function solve(planes: Planes, slack: number): boolean {
  const { count, normal, bound } = planes;
  const x = wanted[0]!;
  const y = wanted[1]!;
  const z = wanted[2]!;
  found[3] = Infinity;
  candidate.set(wanted);
  consider(planes, slack);
  if (found[3] === 0) return true;
  for (let i = 0; i < count; i++) {
    const ax = normal[3 * i]!;
    const ay = normal[3 * i + 1]!;
    const az = normal[3 * i + 2]!;
    const p = bound[i]! - slack;
    const aa = ax * ax + ay * ay + az * az;
    const short = p - (ax * x + ay * y + az * z);
    if (short > 0) {
      const u = short / aa;
      candidate[0] = x + u * ax;
      candidate[1] = y + u * ay;
      candidate[2] = z + u * az;
      consider(planes, slack);
    }
    for (let j = i + 1; j < count; j++) {
      const cx = normal[3 * j]!;
      const cy = normal[3 * j + 1]!;
      const cz = normal[3 * j + 2]!;
      const ac = ax * cx + ay * cy + az * cz;
      const cc = cx * cx + cy * cy + cz * cz;
      const det = aa * cc - ac * ac;
      if (det < PARALLEL * aa * cc) continue;
      const q = bound[j]! - slack;
      const shortJ = q - (cx * x + cy * y + cz * z);
      const u = (short * cc - shortJ * ac) / det;
      const v = (shortJ * aa - short * ac) / det;
      candidate[0] = x + u * ax + v * cx;
      candidate[1] = y + u * ay + v * cy;
      candidate[2] = z + u * az + v * cz;
      consider(planes, slack);
      for (let k = j + 1; k < count; k++) {
        const ex = normal[3 * k]!;
        const ey = normal[3 * k + 1]!;
        const ez = normal[3 * k + 2]!;
        // Cramer's rule for the point on all three.
        const mx = cy * ez - cz * ey;
        const my = cz * ex - cx * ez;
        const mz = cx * ey - cy * ex;
        const volume = ax * mx + ay * my + az * mz;
        if (Math.abs(volume) < 1e-3) continue;
        const r = bound[k]! - slack;
        candidate[0] = (p * mx + q * (ey * az - ez * ay) + r * (ay * cz - az * cy)) / volume;
        candidate[1] = (p * my + q * (ez * ax - ex * az) + r * (az * cx - ax * cz)) / volume;
        candidate[2] = (p * mz + q * (ex * ay - ey * ax) + r * (ax * cy - ay * cx)) / volume;
        consider(planes, slack);
      }
    }
  }
  return found[3]! < Infinity;
}

/** Planes whose crease is no sharper than this (squared sine of the angle between them) have none. */
const PARALLEL = 1e-5;

/** Keeps `candidate` in `found` if it is nearer to the wanted one and all planes allow it. */
function consider(planes: Planes, slack: number): void {
  const px = candidate[0]!;
  const py = candidate[1]!;
  const pz = candidate[2]!;
  const dx = px - wanted[0]!;
  const dy = py - wanted[1]!;
  const dz = pz - wanted[2]!;
  const away = dx * dx + dy * dy + dz * dz;
  if (away >= found[3]!) return;
  const { count, normal, bound } = planes;
  for (let i = 0; i < count; i++) {
    const along = normal[3 * i]! * px + normal[3 * i + 1]! * py + normal[3 * i + 2]! * pz;
    if (along < bound[i]! - slack - TOLERANCE) return;
  }
  found[0] = px;
  found[1] = py;
  found[2] = pz;
  found[3] = away;
}
