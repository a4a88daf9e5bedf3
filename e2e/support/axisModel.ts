/**
 * What the paper's six maxima must be, from bare triangles in float64: a ray through the middle of every texel against
 * every triangle. Shares no code with the package; runs in a page or in Node.
 */

/** Six faces, +X -X +Y -Y +Z -Z, N² texels each, row by row; reds of 0..1, not quantised. */
export interface AxisModel {
  resolution: number;
  /** Red along each texel's middle. */
  red: Float64Array;
  /** Lowest and highest red of the middle and four rays `snap` away, or `red` itself if snap is 0. */
  low: Float64Array;
  high: Float64Array;
  /** Highest `red` per face. */
  max: number[];
}

/** [forward, right, up] per face: the paper's matrices (3)-(8), written out by hand. */
export const AXES = [
  [1, 0, 0, 0, 0, 1, 0, 1, 0],
  [-1, 0, 0, 0, 0, -1, 0, 1, 0],
  [0, 1, 0, 1, 0, 0, 0, 0, 1],
  [0, -1, 0, 1, 0, 0, 0, 0, -1],
  [0, 0, 1, -1, 0, 0, 0, 1, 0],
  [0, 0, -1, 1, 0, 0, 0, 1, 0],
] as const;

/**
 * @param triangles nine numbers a triangle, world space, metres
 * @param center the sphere's middle
 * @param resolution N, texels per face edge
 * @param snap how far, in texels, a rasteriser may displace a vertex each way: half a step of its sub-texel grid (1/512
 *   on most GPUs; SwiftShader's 4 sub-pixel bits make it 1/32). 0 leaves `low` and `high` equal to `red`.
 */
export function modelMaxima(
  triangles: Float64Array,
  center: { x: number; y: number; z: number },
  rMin: number,
  rMax: number,
  resolution: number,
  snap = 0,
): AxisModel {
  const near = relevant(triangles, center, rMax);
  const count = 6 * resolution * resolution;
  const red = new Float64Array(count);
  const low = snap > 0 ? new Float64Array(count) : red;
  const high = snap > 0 ? new Float64Array(count) : red;
  const max = [0, 0, 0, 0, 0, 0];
  const zNear = Math.min(rMin / Math.sqrt(3), 0.01 * rMax);
  for (let i = 0; i < count; i++) {
    const face = Math.floor(i / (resolution * resolution));
    const x = i % resolution;
    const y = Math.floor(i / resolution) % resolution;
    const at = (dx: number, dy: number) => {
      const u = (2 * (x + 0.5 + dx)) / resolution - 1;
      const v = (2 * (y + 0.5 + dy)) / resolution - 1;
      const depth = cast(near, AXES[face]!, u, v, zNear);
      const distance = depth * Math.sqrt(1 + u * u + v * v);
      return Math.min(1, Math.max(0, 1 - (distance - rMin) / (rMax - rMin)));
    };
    red[i] = at(0, 0);
    max[face] = Math.max(max[face]!, red[i]!);
    if (snap === 0) continue;
    const corners = [at(-snap, -snap), at(snap, -snap), at(-snap, snap), at(snap, snap)];
    low[i] = Math.min(red[i]!, ...corners);
    high[i] = Math.max(red[i]!, ...corners);
  }
  return { resolution, red, low, high, max };
}

/** What the GPU read back: per face the red of 0..1, and the winner's column and row. */
export interface AxisReading {
  red: ArrayLike<number>;
  texel: ArrayLike<number>;
}

export interface AxisJudgement {
  /** No face failed, the snapping of vertices allowed for. */
  ok: boolean;
  /** Faces that fail the plain comparison with the rays through the texels' middles. */
  plainFailures: number;
  /** Faces that fail although `low` and `high` allow for snapped vertices. */
  failures: number;
  /** Faces compared that saw anything. */
  seen: number;
  /** Largest |red - expected| over the faces, and its face. */
  worst: number;
  worstFace: number;
}

/** One step of the 8-bit red, and as much again as float32 may lose. */
const STEP = 1 / 255 + 1e-5;

/**
 * Plainly: the red is the model's highest to a step, and the winning texel's red is as high to a step. Allowing for
 * snapped vertices: the red lies between the highest `low` and the highest `high` to a step, and the winner's `high`
 * reaches it.
 */
export function judge(gpu: AxisReading, model: AxisModel): AxisJudgement {
  const n = model.resolution;
  const result = { ok: true, plainFailures: 0, failures: 0, seen: 0, worst: 0, worstFace: 0 };
  for (let face = 0; face < 6; face++) {
    const red = gpu.red[face]!;
    const x = gpu.texel[2 * face]!;
    const y = gpu.texel[2 * face + 1]!;
    const winner = (face * n + y) * n + x;
    const inside = x >= 0 && x < n && y >= 0 && y < n;
    const max = model.max[face]!;
    if (red > 0 || max > STEP) result.seen++;
    const error = Math.abs(red - max);
    if (!(error <= result.worst)) {
      result.worst = error;
      result.worstFace = face;
    }
    if (!(inside && error <= STEP && model.red[winner]! >= max - STEP)) result.plainFailures++;
    let least = 0;
    let most = 0;
    for (let i = face * n * n; i < (face + 1) * n * n; i++) {
      least = Math.max(least, model.low[i]!);
      most = Math.max(most, model.high[i]!);
    }
    const between = red >= least - STEP && red <= most + STEP;
    if (!(inside && between && model.high[winner]! >= red - STEP)) result.failures++;
  }
  result.ok = result.failures === 0;
  return result;
}

/** Triangles whose bounding sphere comes within rMax, as corner, edge, edge relative to the centre. */
function relevant(
  triangles: Float64Array,
  center: { x: number; y: number; z: number },
  rMax: number,
): Float64Array {
  const kept: number[] = [];
  for (let i = 0; i < triangles.length; i += 9) {
    const c = [0, 1, 2].map((corner) => [
      triangles[i + 3 * corner]! - center.x,
      triangles[i + 3 * corner + 1]! - center.y,
      triangles[i + 3 * corner + 2]! - center.z,
    ]) as [number[], number[], number[]];
    const middle = [0, 1, 2].map((k) => (c[0][k]! + c[1][k]! + c[2][k]!) / 3);
    const radius = Math.max(
      ...c.map((p) => Math.hypot(p[0]! - middle[0]!, p[1]! - middle[1]!, p[2]! - middle[2]!)),
    );
    if (Math.hypot(...middle) > rMax + radius) continue;
    kept.push(...c[0], ...c[1].map((v, k) => v - c[0][k]!), ...c[2].map((v, k) => v - c[0][k]!));
  }
  return Float64Array.from(kept);
}

/**
 * Depth of the first triangle, either side, along forward + u·right + v·up from the origin; Infinity for none. Depth,
 * not distance: the direction's part along `forward` is 1. (Möller and Trumbore 1997.)
 */
function cast(
  t: Float64Array,
  [fx, fy, fz, rx, ry, rz, ux, uy, uz]: (typeof AXES)[number],
  u: number,
  v: number,
  zNear: number,
): number {
  const dx = fx + u * rx + v * ux;
  const dy = fy + u * ry + v * uy;
  const dz = fz + u * rz + v * uz;
  let nearest = Infinity;
  for (let i = 0; i < t.length; i += 9) {
    const e1x = t[i + 3]!;
    const e1y = t[i + 4]!;
    const e1z = t[i + 5]!;
    const e2x = t[i + 6]!;
    const e2y = t[i + 7]!;
    const e2z = t[i + 8]!;
    const px = dy * e2z - dz * e2y;
    const py = dz * e2x - dx * e2z;
    const pz = dx * e2y - dy * e2x;
    const det = e1x * px + e1y * py + e1z * pz;
    if (det === 0) continue;
    const sx = -t[i]!;
    const sy = -t[i + 1]!;
    const sz = -t[i + 2]!;
    const a = (sx * px + sy * py + sz * pz) / det;
    if (a < 0 || a > 1) continue;
    const qx = sy * e1z - sz * e1y;
    const qy = sz * e1x - sx * e1z;
    const qz = sx * e1y - sy * e1x;
    const b = (dx * qx + dy * qy + dz * qz) / det;
    if (b < 0 || a + b > 1) continue;
    const depth = (e2x * qx + e2y * qy + e2z * qz) / det;
    if (depth >= zNear && depth < nearest) nearest = depth;
  }
  return nearest;
}
