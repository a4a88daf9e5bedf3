// Hills around a meadow, with firs and rocks.

import { Shape, normalize } from '../Shape.mjs';
import { fbm, hash } from '../noise.mjs';

/** Width, metres, and cells along an edge. */
const WIDTH = 112;
const CELLS = 56;

const height = (x, z) => {
  const away = Math.hypot(x, z) / (WIDTH / 2);
  const hills = fbm(x / 22 + 40, z / 22 + 40, { seed: 5, octaves: 4 }) - 0.42;
  return 16 * hills * Math.min(1, 0.25 + away) + 17 * Math.max(0, away - 0.45) ** 1.6;
};

function normal(x, z) {
  const e = 0.5;
  return normalize([
    height(x - e, z) - height(x + e, z),
    2 * e,
    height(x, z - e) - height(x, z + e),
  ]);
}

/** Meadow, higher heath, and rock where it is steep. */
function tint(x, z) {
  const [, up] = normal(x, z);
  const y = height(x, z);
  const speckle = 0.92 + 0.16 * hash(Math.round(x * 2), Math.round(z * 2), 9);
  const meadow = [0.36, 0.5, 0.22];
  const heath = [0.55, 0.52, 0.28];
  const rock = [0.55, 0.52, 0.48];
  const mix = (a, b, t) =>
    a.map((value, k) => value + (b[k] - value) * Math.min(1, Math.max(0, t)));
  const ground = mix(meadow, heath, (y - 1) / 6);
  return mix(ground, rock, (0.88 - up) / 0.1).map((value) => Math.min(1, value * speckle));
}

export function valley() {
  const terrain = new Shape('terrain');
  const point = (i, j) => [(i / CELLS - 0.5) * WIDTH, (j / CELLS - 0.5) * WIDTH];
  const add = (corners) =>
    terrain.polygon(
      'plain',
      corners.map(([x, z]) => [x, height(x, z), z]),
      {
        normals: corners.map(([x, z]) => normal(x, z)),
        tints: corners.map(([x, z]) => tint(x, z)),
      },
    );
  for (let j = 0; j < CELLS; j++)
    for (let i = 0; i < CELLS; i++) {
      const [a, b, c, d] = [point(i, j), point(i, j + 1), point(i + 1, j + 1), point(i + 1, j)];
      add([a, b, c]);
      add([a, c, d]);
    }
  const firs = new Shape('firs');
  const rocks = new Shape('rocks');
  for (let n = 0; n < 150; n++) {
    const [x, z] = [1, 2].map((k) => (hash(n, k, 77) - 0.5) * (WIDTH - 12));
    if (Math.hypot(x, z) < 7) continue;
    const y = height(x, z);
    const size = 0.7 + 0.7 * hash(n, 3, 77);
    if (normal(x, z)[1] < 0.82 || n % 6 === 0) {
      rocks.place(x, y - 0.3 * size, z);
      rocks.lathe(
        'stone',
        [
          [1.1 * size, 0],
          [1.3 * size, 0.5 * size],
          [0.6 * size, 1.3 * size],
          [0, 1.5 * size],
        ],
        6,
        { facets: true, phase: hash(n, 4) },
      );
    } else {
      firs.place(x, y - 0.1, z);
      firs.lathe(
        'trunk',
        [
          [0.2 * size, 0],
          [0.16 * size, 1.3 * size],
        ],
        6,
      );
      for (const [radius, from, to] of [
        [1.5, 1, 3.2],
        [1.15, 2.3, 4.4],
        [0.75, 3.5, 5.4],
      ])
        firs.lathe(
          'fir',
          [
            [radius * size, from * size],
            [0, to * size],
          ],
          7,
          { facets: true, phase: hash(n, 5) },
        );
    }
  }
  return { shapes: [terrain, firs, rocks] };
}
