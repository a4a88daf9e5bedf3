// Bakes ambient occlusion: how much of the sky's half a point sees, by rays against every triangle.

import { hash } from './noise.mjs';

/** Occluders farther than this do not darken, metres. */
const REACH = 3;
const LEAF = 6;

/** A tree of boxes over the shapes' triangles; `blocked(origin, direction)` tells if something is within `REACH`. */
export function occluders(shapes) {
  const triangles = [];
  for (const { parts } of shapes)
    for (const { positions, indices } of parts.values())
      for (let i = 0; i < indices.length; i += 3) {
        const triangle = [];
        for (let k = 0; k < 3; k++)
          for (let axis = 0; axis < 3; axis++) triangle.push(positions[indices[i + k] * 3 + axis]);
        triangles.push(Float64Array.from(triangle));
      }

  const build = (list) => {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (const triangle of list)
      for (let i = 0; i < 9; i++) {
        low[i % 3] = Math.min(low[i % 3], triangle[i]);
        high[i % 3] = Math.max(high[i % 3], triangle[i]);
      }
    if (list.length <= LEAF) return { low, high, list };
    const sizes = high.map((value, axis) => value - low[axis]);
    const axis = sizes.indexOf(Math.max(...sizes));
    const middle = (t) => t[axis] + t[axis + 3] + t[axis + 6];
    const sorted = [...list].sort((a, b) => middle(a) - middle(b));
    const half = sorted.length >> 1;
    return { low, high, left: build(sorted.slice(0, half)), right: build(sorted.slice(half)) };
  };
  const root = build(triangles);

  /** Möller and Trumbore's test, either side. */
  const hits = (t, o, d) => {
    const [e1x, e1y, e1z] = [t[3] - t[0], t[4] - t[1], t[5] - t[2]];
    const [e2x, e2y, e2z] = [t[6] - t[0], t[7] - t[1], t[8] - t[2]];
    const px = d[1] * e2z - d[2] * e2y;
    const py = d[2] * e2x - d[0] * e2z;
    const pz = d[0] * e2y - d[1] * e2x;
    const det = e1x * px + e1y * py + e1z * pz;
    if (Math.abs(det) < 1e-12) return false;
    const [sx, sy, sz] = [o[0] - t[0], o[1] - t[1], o[2] - t[2]];
    const u = (sx * px + sy * py + sz * pz) / det;
    if (u < 0 || u > 1) return false;
    const qx = sy * e1z - sz * e1y;
    const qy = sz * e1x - sx * e1z;
    const qz = sx * e1y - sy * e1x;
    const v = (d[0] * qx + d[1] * qy + d[2] * qz) / det;
    if (v < 0 || u + v > 1) return false;
    const distance = (e2x * qx + e2y * qy + e2z * qz) / det;
    return distance > 0 && distance < REACH;
  };
  const crosses = ({ low, high }, o, inverse) => {
    let near = 0;
    let far = REACH;
    for (let axis = 0; axis < 3; axis++) {
      const a = (low[axis] - o[axis]) * inverse[axis];
      const b = (high[axis] - o[axis]) * inverse[axis];
      near = Math.max(near, Math.min(a, b));
      far = Math.min(far, Math.max(a, b));
    }
    return near <= far;
  };
  const walk = (node, o, d, inverse) =>
    crosses(node, o, inverse) &&
    (node.list
      ? node.list.some((triangle) => hits(triangle, o, d))
      : walk(node.left, o, d, inverse) || walk(node.right, o, d, inverse));
  return (origin, direction) =>
    walk(
      root,
      origin,
      direction,
      direction.map((value) => 1 / value),
    );
}

/** The free part of the half space over `normal`, 0 to 1, weighted by the cosine; `seed` turns the rays. */
function openness(blocked, origin, normal, rays, seed) {
  const helper = Math.abs(normal[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0];
  const cross = (a, b) => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
  ];
  const raw = cross(helper, normal);
  const size = Math.hypot(...raw);
  const tangent = raw.map((value) => value / size);
  const other = cross(normal, tangent);
  const spin = hash(seed, 3, 77);
  let free = 0;
  for (let i = 0; i < rays; i++) {
    // A spiral of directions, evenly spread over the disc below the half sphere.
    const radius = Math.sqrt((i + 0.5) / rays);
    const angle = (i * 0.6180339887498949 + spin) * 2 * Math.PI;
    const [a, b] = [radius * Math.cos(angle), radius * Math.sin(angle)];
    const up = Math.sqrt(1 - radius * radius);
    const direction = [0, 1, 2].map((k) => tangent[k] * a + other[k] * b + normal[k] * up + 1e-9);
    if (!blocked(origin, direction)) free++;
  }
  return free / rays;
}

/** Below this a corner counts as buried in its neighbour. */
const BURIED = 0.12;

/** Multiplies each vertex' colour. Corners are judged a little inward on their polygon, buried ones from farther in. */
export function bakeVertices(shapes, blocked, { rays = 40, strength = 0.55, skip = [] } = {}) {
  for (const shape of shapes) {
    if (skip.includes(shape.name)) continue;
    for (const { positions, normals, colors, anchors } of shape.parts.values())
      for (let i = 0; i < positions.length; i += 3) {
        const toward = [0, 1, 2].map((k) => anchors[i + k] - positions[i + k]);
        const length = Math.hypot(...toward) || 1;
        const normal = normals.slice(i, i + 3);
        const openAt = (inward) => {
          const origin = [0, 1, 2].map(
            (k) => positions[i + k] + (toward[k] * inward) / length + 0.03 * normal[k],
          );
          // What stands on the floor reaches into it.
          if (origin[1] < 0.05 && origin[1] > -0.1) origin[1] = 0.05;
          return openness(blocked, origin, normal, rays, 0);
        };
        let open = openAt(Math.min(0.12, 0.4 * length));
        if (open < BURIED) open = Math.max(open, openAt(0.5 * length), openAt(0.9 * length));
        for (let k = 0; k < 3; k++) colors[i + k] *= 1 - strength * (1 - open);
      }
  }
}

/** The floor's map: `size` × `size` values over a square of `width` metres, rows toward +Z. */
export function bakeFloor(blocked, { size, width, rays = 32 }) {
  const values = new Float32Array(size * size);
  for (let row = 0; row < size; row++)
    for (let column = 0; column < size; column++) {
      const x = ((column + 0.5) / size - 0.5) * width;
      const z = ((row + 0.5) / size - 0.5) * width;
      values[row * size + column] = openness(
        blocked,
        [x, 0.02, z],
        [0, 1, 0],
        rays,
        row * size + column,
      );
    }
  return values;
}
