import { texelIndex } from '../cube/atlas.js';
import { neighbours, SIDES } from '../field/neighbours.js';
import type { SurfaceField } from '../field/SurfaceField.js';

/** Two texels saw one surface if its plane, gone on from one, meets the other's ray as near as this, part of the distance. */
const SAME = 0.12;

const quadsOf = new Map<number, Uint32Array>();

/**
 * Texels whose middles are the corners of a quad, 4 each, all around the cube and across the seams of its faces: a closed
 * surface. At the cube's eight corners three faces meet, and the fourth corner is the third once more. Made once a
 * resolution and shared.
 *
 * @param resolution texels per face edge
 */
export function cubeQuads(resolution: number): Uint32Array {
  let quads = quadsOf.get(resolution);
  if (quads === undefined) quadsOf.set(resolution, (quads = makeQuads(resolution)));
  return quads;
}

function makeQuads(n: number): Uint32Array {
  const table = neighbours(n);
  const beyond = (texel: number, side: number) => table[SIDES * texel + side]!;
  const quads: number[] = [];
  for (let face = 0; face < 6; face++) {
    const at = (x: number, y: number) => texelIndex(face, x, y, n);
    for (let y = 0; y < n - 1; y++) {
      for (let x = 0; x < n - 1; x++) {
        quads.push(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
      }
    }
    // Across the seams, each from one of its two faces.
    for (let side = 0; side < SIDES; side++) {
      for (let i = 0; i < n - 1; i++) {
        const edge = side % 2 === 0 ? n - 1 : 0;
        const one = side < 2 ? at(edge, i) : at(i, edge);
        const next = side < 2 ? at(edge, i + 1) : at(i + 1, edge);
        if (one < beyond(one, side)) {
          quads.push(one, next, beyond(next, side), beyond(one, side));
        }
      }
    }
    for (const x of [0, n - 1]) {
      for (const y of [0, n - 1]) {
        const corner = at(x, y);
        const aside = beyond(corner, x === 0 ? 1 : 0);
        const up = beyond(corner, y === 0 ? 3 : 2);
        if (corner < aside && corner < up) quads.push(corner, aside, up, up);
      }
    }
  }
  return Uint32Array.from(quads);
}

/** What `freeBorder` found. */
export interface FreeBorder {
  /** Texels, 3 a triangle, of which the first `triangleEnd` count. Room for 6 a quad. */
  readonly triangles: Uint32Array;
  triangleEnd: number;
  /** Texels, 2 a line, of which the first `lineEnd` count. Room for 4 a quad. */
  readonly lines: Uint32Array;
  lineEnd: number;
}

/**
 * Finds where the space that a field saw to be free ends without a surface: at the end of its reach, and where one thing
 * hides what is behind it. Beyond that border nothing is known. Allocates nothing.
 */
export function freeBorder(field: SurfaceField, target: FreeBorder): void {
  const quads = cubeQuads(field.resolution);
  const { triangles, lines } = target;
  let t = 0;
  let l = 0;
  for (let q = 0; q < quads.length; q += 4) {
    const a = quads[q]!;
    const b = quads[q + 1]!;
    const c = quads[q + 2]!;
    const d = quads[q + 3]!;
    if (
      isOneSurface(field, a, b) &&
      isOneSurface(field, b, c) &&
      (c === d || isOneSurface(field, c, d)) &&
      isOneSurface(field, d, a)
    ) {
      continue;
    }
    triangles[t++] = a;
    triangles[t++] = b;
    triangles[t++] = c;
    lines[l++] = a;
    lines[l++] = b;
    if (c === d) continue;
    triangles[t++] = a;
    triangles[t++] = c;
    triangles[t++] = d;
    lines[l++] = a;
    lines[l++] = d;
  }
  target.triangleEnd = t;
  target.lineEnd = l;
}

/** Did two neighbouring texels see the same surface, or two that meet between them? */
function isOneSurface(field: SurfaceField, a: number, b: number): boolean {
  return goesOn(field, a, b) || goesOn(field, b, a);
}

/** Does what `b` saw lie, along its ray, about where the plane that `a` saw is? */
function goesOn({ direction, distance, normal }: SurfaceField, a: number, b: number): boolean {
  const i = 3 * a;
  const j = 3 * b;
  const nx = normal[i]!;
  const ny = normal[i + 1]!;
  const nz = normal[i + 2]!;
  const own = nx * direction[i]! + ny * direction[i + 1]! + nz * direction[i + 2]!;
  const other = nx * direction[j]! + ny * direction[j + 1]! + nz * direction[j + 2]!;
  const one = distance[a]!;
  const two = distance[b]!;
  if (other >= 0 || !(one < Infinity) || !(two < Infinity)) return false;
  return Math.abs((one * own) / other - two) < SAME * Math.min(one, two);
}
