import type { Vector3 } from 'three';
import { FACES } from '../cube/faces.js';
import { EDGE } from './blocks.js';
import { SIDES } from './neighbours.js';
import type { Texels } from './Texels.js';

/** Planes whose texels agree on each other's distance to this part of it are one plane. */
const COPLANAR = 1e-3;
/** Cosine between normals below which they are two planes all the same: both rays fell beside the edge between them. */
const ALIKE = 0.9;
/** Farthest that a surfel is stretched to a crease, metres: at a slant, unrelated planes meet by chance. */
const LONGEST_STRETCH = 0.15;
/** Farthest that a surfel goes toward a silhouette, metres. */
const LONGEST_GUESS = 0.015;
/** Part of the way to a texel that sees past it. Less than half: of several fields the farthest guess counts. */
const GUESS = 0.3;
/** A surface whose normal rises this much is one to stand on: the rest is not guessed, or steps would grow taller. */
const STANDING = 0.5;
/** A texel this much farther than its neighbour, as a part, lies behind it: the neighbour's edge is seen. */
const BEHIND = 1.001;

/** How the surfaces of two texels go together. */
export const APART = 0;
export const COPLANAR_LINK = 1;
export const CREASE = 2;

/** Where the surfels of a field end. */
export interface Extents {
  /**
   * For each side of each texel how far its surfel goes from the texel's middle that way, in texels; up to the
   * neighbour's ray, or its middle, where both meet in a crease, which then cuts it.
   */
  readonly reach: Float32Array;
  /** For each side how the surface goes on there: `APART`, `COPLANAR_LINK` or `CREASE`. */
  readonly link: Uint8Array;
}

/**
 * How far a texel's piece of surface is sure to go toward each neighbour: half-way where both lie in one plane, to
 * the crease where their two planes meet between their rays; at a silhouette of what one stands on a little, but no farther
 * than 15 mm; and not at all behind what hides it.
 *
 * Curved ground comes out smooth: the tangent planes of two near points of it meet about half-way.
 *
 * @param i the texel; of a block all that come before it are known already
 * @param table `neighbours(texels.resolution)`
 * @param up the character's, unit vector, world axes
 */
export function findExtents(
  texels: Texels,
  i: number,
  table: Int32Array,
  up: Vector3,
  target: Extents,
): void {
  const { distance, direction, normal, resolution } = texels;
  const { reach, link } = target;
  const di = distance[i]!;
  const s = SIDES * i;
  const k = 3 * i;
  const rx = direction[k]!;
  const ry = direction[k + 1]!;
  const rz = direction[k + 2]!;
  const column = i % resolution;
  const row = Math.floor(i / resolution) % resolution;
  for (let side = 0; side < SIDES; side++) {
    const j = table[s + side]!;
    // Two of a block meet each other alike.
    const before = (side === 1 && column % EDGE > 0) || (side === 3 && row % EDGE > 0);
    const meets =
      before && distance[j]! < Infinity ? link[SIDES * j + side - 1]! : meeting(texels, i, j);
    link[s + side] = meets;
    if (meets === COPLANAR_LINK) {
      reach[s + side] = 0.5;
      continue;
    }
    if (meets === CREASE) {
      // Drawn finer, the neighbour's ray may lie beyond its middle, and the crease with it.
      reach[s + side] = Math.max(1, outward(texels, j, i, side));
      continue;
    }
    const rise = up.x * normal[k]! + up.y * normal[k + 1]! + up.z * normal[k + 2]!;
    const seen = rise > STANDING && distance[j]! > di * BEHIND;
    const slant = rx * normal[k]! + ry * normal[k + 1]! + rz * normal[k + 2]!;
    reach[s + side] = outward(texels, i, i, side) + (seen ? guess(di, slant, resolution) : 0);
  }
}

/** How far toward `side` the ray of texel `j` passes the middle of texel `i`, on the face of that, in texels. */
function outward({ direction, resolution }: Texels, j: number, i: number, side: number): number {
  const { forward: f, right: r, up: u } = FACES[Math.floor(i / (resolution * resolution))]!;
  const x = direction[3 * j]!;
  const y = direction[3 * j + 1]!;
  const z = direction[3 * j + 2]!;
  const axis = side < 2 ? r : u;
  const at = (x * axis[0] + y * axis[1] + z * axis[2]) / (x * f[0] + y * f[1] + z * f[2]);
  const own = side < 2 ? i % resolution : Math.floor(i / resolution) % resolution;
  const off = 0.5 * resolution * (at + 1) - 0.5 - own;
  return side % 2 === 0 ? off : -off;
}

/** How the surfaces of texels `i` and `j`, side by side, go together. */
export function meeting(texels: Texels, i: number, j: number): number {
  const { distance, direction, normal } = texels;
  const di = distance[i]!;
  const dj = distance[j]!;
  if (dj === Infinity) return APART;
  const k = 3 * i;
  const m = 3 * j;
  const nx = normal[k]!;
  const ny = normal[k + 1]!;
  const nz = normal[k + 2]!;
  const rx = direction[k]!;
  const ry = direction[k + 1]!;
  const rz = direction[k + 2]!;
  const mx = normal[m]!;
  const my = normal[m + 1]!;
  const mz = normal[m + 2]!;
  const qx = direction[m]!;
  const qy = direction[m + 1]!;
  const qz = direction[m + 2]!;
  const ni = nx * rx + ny * ry + nz * rz;
  const nj = mx * qx + my * qy + mz * qz;
  const inj = nx * qx + ny * qy + nz * qz; // plane i along ray j
  const jni = mx * rx + my * ry + mz * rz; // plane j along ray i
  const oi = di * ni;
  const oj = dj * nj;
  if (
    Math.abs(oi - dj * inj) < COPLANAR * dj * Math.abs(inj) &&
    Math.abs(oj - di * jni) < COPLANAR * di * Math.abs(jni) &&
    nx * mx + ny * my + nz * mz > ALIKE
  ) {
    return COPLANAR_LINK;
  }
  // Along r(t) from ray i to ray j, plane i lies at oi / (n·r), plane j at oj / (m·r); they are equal at the crease.
  const atI = oi * jni - oj * ni;
  const atJ = oi * nj - oj * inj;
  const t = atI / (atI - atJ);
  if (!(t > 0 && t < 1)) return APART;
  const depth = oi / ((1 - t) * ni + t * inj);
  const cx = depth * ((1 - t) * rx + t * qx);
  const cy = depth * ((1 - t) * ry + t * qy);
  const cz = depth * ((1 - t) * rz + t * qz);
  const here = squared(cx - di * rx, cy - di * ry, cz - di * rz);
  const there = squared(cx - dj * qx, cy - dj * qy, cz - dj * qz);
  return depth > 0 && Math.max(here, there) < LONGEST_STRETCH * LONGEST_STRETCH ? CREASE : APART;
}

/**
 * Somewhere between the rays of a texel and of one that sees past it, the surface ends.
 *
 * @param slant cosine between ray and normal, negative
 * @returns the part of the way to the next texel that it is taken to go
 */
function guess(distance: number, slant: number, resolution: number): number {
  // How long a texel is on the surface, seen at a slant.
  const texel = (2 * distance) / (resolution * Math.max(0.05, -slant));
  return Math.min(GUESS, LONGEST_GUESS / texel);
}

function squared(x: number, y: number, z: number): number {
  return x * x + y * y + z * z;
}
