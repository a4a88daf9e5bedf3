// The floor: plaza, lawns, the terrain and the pit, one sheet cut along common lines so that it has no crack.

import { Shape, normalize } from '../Shape.mjs';
import { fbm, noise, smootherstep } from '../noise.mjs';

/** Inner faces of the outer walls, metres from the middle. */
export const HALF = 30;

/** [x0, z0, x1, z1] of each region. */
export const TERRAIN = [6, 17, 28, 29];
export const PIT = [-2, 14, 2, 18];
export const PIT_RIM = [-2.5, 13.5, 2.5, 18.5];
const LAWNS = [
  [7, -29, 29, -14],
  [-29, -29, -7, -16],
  [5, 16, 29, 30],
  [-29, 15, -12, 29],
  [-8, 20, -4, 29],
];
/** The inlaid star around the start. */
export const ROSETTE = [-4, 0, 4, 8];
/** The pit's walls end here and its black floor lies here: well below the height of a respawn. */
export const PIT_DEPTH = 12;

const inside = ([x0, z0, x1, z1], x, z) => x > x0 && x < x1 && z > z0 && z < z1;

/** Height of the terrain at (x, z), metres, nowhere steeper than 40°; 0 with its slope and curvature along its edge. */
export function terrainHeight(x, z) {
  const [x0, z0, x1, z1] = TERRAIN;
  const toEdge = Math.min(x - x0, x1 - x, z - z0, z1 - z);
  if (toEdge <= 0) return 0;
  // The product of four ramps, not the least distance, so that no crease runs along the diagonals.
  const blend =
    smootherstep(0, 5, x - x0) *
    smootherstep(0, 5, x1 - x) *
    smootherstep(0, 4.5, z - z0) *
    smootherstep(0, 4.5, z1 - z);
  const hills = 1.9 * fbm(x / 6.5, z / 6.5, { seed: 7, octaves: 2 });
  const bumps = 0.14 * noise(x / 1.8, z / 1.8, 9);
  return blend * (hills + bumps);
}

function terrainNormal(x, z) {
  const step = 1e-3;
  return normalize([
    terrainHeight(x - step, z) - terrainHeight(x + step, z),
    2 * step,
    terrainHeight(x, z - step) - terrainHeight(x, z + step),
  ]);
}

/** A slow change of light and colour over the floor, so that the eye does not count the texture's repeats. */
export function patina(x, z) {
  const light =
    0.86 + 0.14 * smootherstep(0.25, 0.75, fbm(x / 9, z / 9, { seed: 300, octaves: 3 }));
  const warm = 0.04 * noise(x / 14, z / 14, 310);
  return [light, light * (1 - warm / 2), light * (1 - warm)];
}

/**
 * The start's z. No line runs through it: the corners of a floor in the camera's own plane have no place in the picture,
 * and a software GPU then draws the floor before one's feet in one colour.
 */
const START_Z = 4;

/** Lines of the grid: every 2 m, every 1 m over lawns' and pit's edges, every 0.5 m over the terrain. */
function lines(from, to, fineFrom, fineTo, extra) {
  const all = new Set([from, to, ...extra]);
  for (let i = -HALF; i <= HALF; i += 2) all.add(i);
  for (let i = fineFrom; i <= fineTo; i += 0.5) all.add(i);
  return [...all].sort((a, b) => a - b);
}

export function ground() {
  const floor = new Shape('ground');
  const terrain = new Shape('terrain');
  const pit = new Shape('pit');
  const edge = HALF + 0.3;
  const regions = [...LAWNS, PIT, PIT_RIM];
  const xs = lines(
    -edge,
    edge,
    TERRAIN[0],
    TERRAIN[2],
    regions.flatMap(([a, , b]) => [a, b]),
  );
  const zs = lines(
    -edge,
    edge,
    TERRAIN[1],
    TERRAIN[3],
    regions.flatMap(([, a, , b]) => [a, b]),
  ).filter((z) => z !== START_Z);

  for (let i = 1; i < xs.length; i++)
    for (let j = 1; j < zs.length; j++) {
      const [x0, x1, z0, z1] = [xs[i - 1], xs[i], zs[j - 1], zs[j]];
      const [x, z] = [(x0 + x1) / 2, (z0 + z1) / 2];
      if (inside(PIT, x, z)) continue;
      const corners = [
        [x0, z1],
        [x1, z1],
        [x1, z0],
        [x0, z0],
      ];
      if (inside(TERRAIN, x, z)) {
        // Two triangles a cell, for its corners need not be planar.
        const points = corners.map(([a, b]) => [a, terrainHeight(a, b), b]);
        for (const pick of [
          [0, 1, 2],
          [0, 2, 3],
        ])
          terrain.polygon(
            'grass',
            pick.map((k) => points[k]),
            {
              normals: pick.map((k) => terrainNormal(...corners[k])),
              uvs: pick.map((k) => corners[k].map((value) => value / 2)),
              tints: pick.map((k) => patina(...corners[k])),
            },
          );
        continue;
      }
      const points = corners.map(([a, b]) => [a, 0, b]);
      const tints = corners.map((corner) => patina(...corner));
      if (inside(ROSETTE, x, z)) {
        const uvs = corners.map(([a, b]) => [(a - ROSETTE[0]) / 8, (b - ROSETTE[1]) / 8]);
        floor.polygon('rosette', points, { tints, uvs });
        continue;
      }
      if (inside(PIT_RIM, x, z)) pit.polygon('ochre', points);
      else
        floor.polygon(
          LAWNS.some((lawn) => inside(lawn, x, z)) ? 'floor-grass' : 'floor-paving',
          points,
          { tints },
        );
    }

  // The shaft is seen from inside: its walls are cut where the floor is, and darken with depth.
  const [x0, z0, x1, z1] = PIT;
  const rim = (list, a, b) => list.filter((value) => value >= a && value <= b);
  const wall = (a, b, along) =>
    pit.polygon('shaft', [[...a], [...b], [b[0], 0, b[2]], [a[0], 0, a[2]]], {
      uvs: [
        [along[0] / 4, 1],
        [along[1] / 4, 1],
        [along[1] / 4, 0],
        [along[0] / 4, 0],
      ],
    });
  const cells = (list, add) => list.slice(1).forEach((value, i) => add(list[i], value));
  const deep = -PIT_DEPTH;
  cells(rim(xs, x0, x1), (a, b) => wall([a, deep, z0], [b, deep, z0], [a, b]));
  cells(rim(xs, x0, x1), (a, b) => wall([b, deep, z1], [a, deep, z1], [-b, -a]));
  cells(rim(zs, z0, z1), (a, b) => wall([x0, deep, b], [x0, deep, a], [-b, -a]));
  cells(rim(zs, z0, z1), (a, b) => wall([x1, deep, a], [x1, deep, b], [a, b]));
  pit.polygon(
    'shaft',
    [
      [x0, deep, z1],
      [x1, deep, z1],
      [x1, deep, z0],
      [x0, deep, z0],
    ],
    {
      uvs: Array(4).fill([0.5, 0.99]),
    },
  );
  return [floor, terrain, pit];
}
