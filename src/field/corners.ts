import { FACE_VECTORS } from '../cube/faces.js';
import { CREASE, type Extents, meeting } from './extents.js';
import { CORNERS, MOST_CORNERS } from './layout.js';
import { SIDES } from './neighbours.js';
import type { Texels } from './Texels.js';

/** A polygon being cut, and what is left of it. */
let polygon = new Float32Array(2 * (MOST_CORNERS + 1));
let cut = new Float32Array(2 * (MOST_CORNERS + 1));

/**
 * Where the rays through the corners of what the texel reaches meet its plane, cut at the creases with all eight
 * neighbours, in tangent coordinates. Written into `data`, behind the surfel's planes at `o`.
 *
 * @param table `neighbours(texels.resolution)`
 * @param midst whether all eight lie in its plane
 * @param piece takes how far from its point the farthest lies, metres, at `p`
 */
export function setCorners(
  data: Float32Array,
  o: number,
  texels: Texels,
  texel: number,
  table: Int32Array,
  { reach, link }: Extents,
  midst: boolean,
  piece: Float32Array,
  p: number,
): void {
  const n = texels.resolution;
  const face = FACE_VECTORS[Math.floor(texel / (n * n))]!;
  const x = texel % n;
  const y = Math.floor(texel / n) % n;
  const s = SIDES * texel;
  const px = data[o]!;
  const py = data[o + 1]!;
  const pz = data[o + 2]!;
  const nx = data[o + 3]!;
  const ny = data[o + 4]!;
  const nz = data[o + 5]!;
  const tx = data[o + 6]!;
  const ty = data[o + 7]!;
  const tz = data[o + 8]!;
  const bx = data[o + 9]!;
  const by = data[o + 10]!;
  const bz = data[o + 11]!;
  const offset = nx * px + ny * py + nz * pz;
  const alongOwn = tx * px + ty * py + tz * pz;
  const acrossOwn = bx * px + by * py + bz * pz;
  // The ray through a corner is forward + a·right + b·up: each product with it is made of three, found once.
  const fx = face[0]!;
  const fy = face[1]!;
  const fz = face[2]!;
  const rx = face[3]!;
  const ry = face[4]!;
  const rz = face[5]!;
  const ux = face[6]!;
  const uy = face[7]!;
  const uz = face[8]!;
  const nf = nx * fx + ny * fy + nz * fz;
  const nr = nx * rx + ny * ry + nz * rz;
  const nu = nx * ux + ny * uy + nz * uz;
  const tf = tx * fx + ty * fy + tz * fz;
  const tr = tx * rx + ty * ry + tz * rz;
  const tu = tx * ux + ty * uy + tz * uz;
  const bf = bx * fx + by * fy + bz * fz;
  const br = bx * rx + by * ry + bz * rz;
  const bu = bx * ux + by * uy + bz * uz;
  const step = 2 / n;
  const middleX = (x + 0.5) * step - 1;
  const middleY = (y + 0.5) * step - 1;
  const right = middleX + step * reach[s]!;
  const left = middleX - step * reach[s + 1]!;
  const top = middleY + step * reach[s + 2]!;
  const bottom = middleY - step * reach[s + 3]!;
  for (let c = 0; c < 4; c++) {
    // Counter-clockwise: (+x, +y), (-x, +y), (-x, -y), (+x, -y).
    const a = c === 0 || c === 3 ? right : left;
    const b = c < 2 ? top : bottom;
    const depth = offset / (nf + a * nr + b * nu);
    let along = depth * (tf + a * tr + b * tu) - alongOwn;
    let across = depth * (bf + a * br + b * bu) - acrossOwn;
    // Edge-on, a ray may miss the plane or meet it far away: no extent is better than a wild one.
    if (!(depth > 0 && along * along + across * across < 1)) along = across = 0;
    polygon[2 * c] = along;
    polygon[2 * c + 1] = across;
  }
  const corners = midst ? 4 : cutAtCreases(data, o, texels, texel, table, link);
  let extent = 0;
  for (let c = 0; c < corners; c++) {
    const along = polygon[2 * c]!;
    const across = polygon[2 * c + 1]!;
    data[o + CORNERS + 1 + 2 * c] = along;
    data[o + CORNERS + 2 + 2 * c] = across;
    extent = Math.max(extent, along * along + across * across);
  }
  data[o + CORNERS] = corners;
  piece[p] = Math.sqrt(extent);
}

/** Cuts `polygon` along the planes of all neighbours with which there is a crease. @returns its corners */
function cutAtCreases(
  data: Float32Array,
  o: number,
  texels: Texels,
  texel: number,
  table: Int32Array,
  link: Uint8Array,
): number {
  const { normal, resolution: n } = texels;
  const x = texel % n;
  const y = Math.floor(texel / n) % n;
  const s = SIDES * texel;
  let corners = 4;
  for (let side = 0; side < SIDES; side++) {
    if (link[s + side] !== CREASE) continue;
    corners = cutAt(data, texels, table[s + side]!, o, corners);
  }
  for (let dy = -1; dy <= 1; dy += 2) {
    if (y + dy < 0 || y + dy >= n) continue;
    for (let dx = -1; dx <= 1; dx += 2) {
      if (x + dx < 0 || x + dx >= n) continue;
      const j = texel + dy * n + dx;
      const k = 3 * j;
      // Alike, there is nothing to cut.
      const same =
        normal[k]! * normal[3 * texel]! +
        normal[k + 1]! * normal[3 * texel + 1]! +
        normal[k + 2]! * normal[3 * texel + 2]!;
      if (same > 0.9999 || meeting(texels, texel, j) !== CREASE) continue;
      corners = cutAt(data, texels, j, o, corners);
    }
  }
  return corners;
}

/** Cuts `polygon`, in the plane of the surfel at `o`, along the plane of texel `j`. */
function cutAt(data: Float32Array, texels: Texels, j: number, o: number, corners: number): number {
  if (corners === MOST_CORNERS) return corners;
  const { direction, distance, normal } = texels;
  const k = 3 * j;
  const mx = normal[k]!;
  const my = normal[k + 1]!;
  const mz = normal[k + 2]!;
  const d = distance[j]!;
  const offset = d * (mx * direction[k]! + my * direction[k + 1]! + mz * direction[k + 2]!);
  let own = mx * data[o]! + my * data[o + 1]! + mz * data[o + 2]! - offset;
  let along = mx * data[o + 6]! + my * data[o + 7]! + mz * data[o + 8]!;
  let across = mx * data[o + 9]! + my * data[o + 10]! + mz * data[o + 11]!;
  // What lies toward the neighbour goes: where its ray would meet this plane. (The own point may lie on the crease.)
  const nx = data[o + 3]!;
  const ny = data[o + 4]!;
  const nz = data[o + 5]!;
  const rx = direction[k]!;
  const ry = direction[k + 1]!;
  const rz = direction[k + 2]!;
  const height = nx * data[o]! + ny * data[o + 1]! + nz * data[o + 2]!;
  const depth = height / (nx * rx + ny * ry + nz * rz);
  if (depth * (mx * rx + my * ry + mz * rz) > offset) {
    own = -own;
    along = -along;
    across = -across;
  }
  let n = 0;
  let ax = polygon[2 * corners - 2]!;
  let ay = polygon[2 * corners - 1]!;
  let a = own + along * ax + across * ay;
  for (let c = 0; c < corners; c++) {
    const bx = polygon[2 * c]!;
    const by = polygon[2 * c + 1]!;
    const b = own + along * bx + across * by;
    if (a >= 0 !== b >= 0) {
      const t = a / (a - b);
      cut[2 * n] = ax + t * (bx - ax);
      cut[2 * n + 1] = ay + t * (by - ay);
      n++;
    }
    if (b >= 0 && n < MOST_CORNERS) {
      cut[2 * n] = bx;
      cut[2 * n + 1] = by;
      n++;
    }
    ax = bx;
    ay = by;
    a = b;
  }
  if (n === 0) return corners;
  const rest = polygon;
  polygon = cut;
  cut = rest;
  return n;
}
