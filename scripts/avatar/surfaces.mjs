// The geometry kit: smooth surfaces of two parameters, cut into triangles, with the normals of the surface itself.

const STEP = 1e-4;

const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/**
 * @param at (u, v) in 0…1 to [x, y, z]; seen from outside, u grows to the right and v upward
 * @param closed whether u = 1 is u = 0 again
 * @returns { positions, normals, indices } flat arrays
 */
export function surface(at, columns, rows, closed = true) {
  const positions = [];
  const normals = [];
  const indices = [];
  const across = closed ? columns : columns + 1;
  for (let j = 0; j <= rows; j++) {
    for (let i = 0; i < across; i++) {
      positions.push(...at(i / columns, j / rows));
      normals.push(...normalAt(at, i / columns, j / rows));
    }
  }
  const point = (i) => positions.slice(3 * i, 3 * i + 3);
  const triangle = (...corners) => {
    const [a, b, c] = corners.map(point);
    const flat = cross(
      b.map((value, k) => value - a[k]),
      c.map((value, k) => value - a[k]),
    );
    // At a pole two corners are one.
    if (Math.hypot(...flat) > 1e-9) indices.push(...corners);
  };
  for (let j = 0; j < rows; j++) {
    for (let i = 0; i < columns; i++) {
      const next = (i + 1) % across;
      const [a, b, c, d] = [i, next, across + next, across + i].map((k) => j * across + k);
      triangle(a, b, c);
      triangle(a, c, d);
    }
  }
  return { positions, normals, indices };
}

function normalAt(at, u, v) {
  // A pole has no direction along u: the normal a little beside it, the same for every u.
  const inside = Math.min(1 - 2 * STEP, Math.max(2 * STEP, v));
  const difference = (a, b) => b.map((value, k) => value - a[k]);
  const along = difference(at(u, inside - STEP), at(u, inside + STEP));
  const around = difference(at(u - STEP, inside), at(u + STEP, inside));
  const normal = cross(around, along);
  const length = Math.hypot(...normal);
  return normal.map((value) => value / length);
}

/** A ball of those half sizes; `power` 2 is an ellipsoid, 5 almost a box with round edges. */
export function blob([x, y, z], [rx, ry, rz], power = 2, columns = 16, rows = 10) {
  return surface(
    (u, v) => {
      const tilt = Math.PI * (v - 0.5);
      const turn = 2 * Math.PI * u;
      const way = [
        Math.cos(tilt) * Math.sin(turn),
        Math.sin(tilt),
        Math.cos(tilt) * Math.cos(turn),
      ];
      const scale = bulge(way, power);
      return [x + rx * way[0] * scale, y + ry * way[1] * scale, z + rz * way[2] * scale];
    },
    columns,
    rows,
  );
}

/** How far the unit ball of that power reaches along a direction. */
export function bulge(way, power) {
  return way.reduce((sum, value) => sum + Math.abs(value) ** power, 0) ** (-1 / power);
}

/**
 * Turns a profile about the upright through `middle`: [height, radius along X, radius along Z] from below to above, with
 * a smooth curve through them.
 */
export function turned([x, y, z], profile, columns = 14, finer = 2) {
  const rings = profile.map(([height, rx, rz = rx]) => [height, rx, rz]);
  return surface(
    (u, v) => {
      const [height, rx, rz] = spline(rings, v);
      const turn = 2 * Math.PI * u;
      return [
        x + Math.max(0, rx) * Math.sin(turn),
        y + height,
        z + Math.max(0, rz) * Math.cos(turn),
      ];
    },
    columns,
    finer * (profile.length - 1),
  );
}

/** A point of the Catmull-Rom curve through points that are alike far apart in `t`, 0…1. */
function spline(points, t) {
  const last = points.length - 1;
  const i = Math.min(last - 1, Math.max(0, Math.floor(t * last)));
  const f = t * last - i;
  const [a, b, c, d] = [-1, 0, 1, 2].map((k) => points[Math.min(last, Math.max(0, i + k))]);
  return b.map(
    (_, k) =>
      0.5 *
      (2 * b[k] +
        (c[k] - a[k]) * f +
        (2 * a[k] - 5 * b[k] + 4 * c[k] - d[k]) * f ** 2 +
        (3 * (b[k] - c[k]) + d[k] - a[k]) * f ** 3),
  );
}

/** A ring in the XZ plane, `thick` and `high` in half sizes of its cross section. */
export function ring([x, y, z], [rx, rz], thick, high = thick, columns = 20, rows = 8) {
  return surface(
    (u, v) => {
      const turn = 2 * Math.PI * u;
      const out = Math.cos(2 * Math.PI * v) * thick;
      return [
        x + (rx + out) * Math.sin(turn),
        y + Math.sin(2 * Math.PI * v) * high,
        z + (rz + out) * Math.cos(turn),
      ];
    },
    columns,
    rows,
  );
}

/** The same part, moved by a function of a point; normals turn with it, so it may only turn and move. */
export function moved({ positions, normals, indices }, turn, [x, y, z]) {
  const each = (list, shift) =>
    list.flatMap((_, i) =>
      i % 3 === 0 ? turn(list.slice(i, i + 3)).map((value, k) => value + shift[k]) : [],
    );
  return { positions: each(positions, [x, y, z]), normals: each(normals, [0, 0, 0]), indices };
}

/** Turns a point about X, then Y, then Z, radians. */
export const turning =
  (ax, ay = 0, az = 0) =>
  ([x, y, z]) => {
    [y, z] = [y * Math.cos(ax) - z * Math.sin(ax), y * Math.sin(ax) + z * Math.cos(ax)];
    [z, x] = [z * Math.cos(ay) - x * Math.sin(ay), z * Math.sin(ay) + x * Math.cos(ay)];
    return [x * Math.cos(az) - y * Math.sin(az), x * Math.sin(az) + y * Math.cos(az), z];
  };

/** The mirror image in the plane x = 0. */
export function mirrored({ positions, normals, indices }) {
  const flip = (list) => list.map((value, i) => (i % 3 === 0 ? -value : value));
  const turnedOver = indices.map((_, i) => indices[i - (i % 3) + ((3 - (i % 3)) % 3)]);
  return { positions: flip(positions), normals: flip(normals), indices: turnedOver };
}
