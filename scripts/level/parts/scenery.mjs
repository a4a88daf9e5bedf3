// What is there to look at: the outer walls, the tower, trees, benches, and the hills beyond. All of it is solid too.

import { SUNK, Shape } from '../Shape.mjs';
import { arcade } from '../pieces.mjs';
import { fbm, hash } from '../noise.mjs';
import { clockUv } from '../signs.mjs';
import { HALF, patina } from './ground.mjs';

const WALL_HEIGHT = 4;

export function outerWalls() {
  const shape = new Shape('outer-walls');
  for (let quarters = 0; quarters < 4; quarters++) {
    // Each side in the frame of the northern one. North and south own the corners.
    shape.place(0, 0, 0, quarters);
    const owns = quarters % 2 === 0;
    const end = owns ? HALF + 1 : HALF;
    shape.box('plaster', [-end, SUNK, -HALF - 1], [end, WALL_HEIGHT, -HALF]);
    const plinth = owns ? HALF : HALF - 0.14;
    shape.box('stone', [-plinth, SUNK, -HALF - 0.02], [plinth, 0.7, -HALF + 0.14]);
    const coping = owns ? HALF + 1.12 : HALF - 0.12;
    shape.box(
      'tile',
      [-coping, WALL_HEIGHT - 0.01, -HALF - 1.12],
      [coping, WALL_HEIGHT + 0.16, -HALF + 0.12],
    );
    for (let x = -24; x <= 24; x += 6) {
      shape.box('stone', [x - 0.4, 0.69, -HALF - 0.02], [x + 0.4, 3.4, -HALF + 0.12]);
      shape.box('nosing', [x - 0.5, 3.39, -HALF - 0.02], [x + 0.5, 3.6, -HALF + 0.2]);
    }
    shape.place(quarters < 2 ? HALF : -HALF, 0, quarters % 3 ? HALF : -HALF);
    shape.lathe(
      'stone',
      [
        [2.3, SUNK],
        [2.2, 0.7],
        [2, 0.75],
        [2, 5.4],
      ],
      8,
      { facets: true, phase: 1 / 16 },
    );
    shape.lathe(
      'nosing',
      [
        [2.05, 5.2],
        [2.3, 5.45],
        [2.3, 5.7],
      ],
      8,
      { facets: true, phase: 1 / 16 },
    );
    shape.lathe(
      'tile',
      [
        [2.5, 5.69],
        [0, 8],
      ],
      8,
      { facets: true, phase: 1 / 16 },
    );
  }
  return shape;
}

/** The landmark: a clock tower behind the stage. */
export function tower() {
  const shape = new Shape('tower');
  const [x, z] = [0, -22];
  shape.place(x, 0, z);
  shape.box('stone', [-2.7, SUNK, -2.7], [2.7, 1.2, 2.7]);
  shape.box('nosing', [-2.8, 1.19, -2.8], [2.8, 1.4, 2.8]);
  shape.box({ top: 'slab', side: 'plaster' }, [-2.3, 1.39, -2.3], [2.3, 11, 2.3]);
  for (let quarters = 0; quarters < 4; quarters++) {
    shape.place(x, 0, z, quarters);
    // Corners, narrow windows, and the openings of the belfry.
    shape.box('stone', [1.7, 1.39, 1.7], [2.4, 15, 2.4]);
    for (const y of [3, 5.6]) {
      shape.box('nosing', [-0.55, y - 0.15, 2.28], [0.55, y + 1.75, 2.36]);
      shape.box('dark', [-0.38, y, 2.3], [0.38, y + 1.6, 2.38]);
    }
    shape.place(...turned(x, z, 0, 2.1, quarters));
    arcade(shape, 'plaster', 'nosing', {
      piers: [
        [-1.75, -1.1],
        [1.1, 1.75],
      ],
      bottom: 10.99,
      spring: 12.9,
      top: 14.9,
      depth: 0.36,
    });
    shape.place(x, 0, z, quarters);
    if (quarters % 2 === 0) clock(shape);
  }
  shape.place(x, 0, z);
  shape.box('nosing', [-2.55, 10.7, -2.55], [2.55, 11.05, 2.55]);
  shape.box('nosing', [-2.6, 14.85, -2.6], [2.6, 15.2, 2.6]);
  shape.lathe(
    'tile',
    [
      [3.9, 15.19],
      [0, 19.6],
    ],
    4,
    { facets: true, phase: 1 / 8 },
  );
  shape.lathe(
    'ochre',
    [
      [0.05, 19.3],
      [0.05, 19.9],
      [0.2, 20.1],
      [0, 20.35],
    ],
    12,
    { smooth: true },
  );
  shape.lathe(
    'ochre',
    [
      [0.75, 12.3],
      [0.6, 12.5],
      [0.45, 13.2],
      [0.25, 13.5],
      [0, 13.55],
    ],
    20,
    { smooth: true },
  );
  shape.box('wood', [-1.95, 13.5, -0.1], [1.95, 13.7, 0.1]);
  return shape;
}

/** The frame of something at (dx, dz) of a body at (x, z) turned by quarters. */
function turned(x, z, dx, dz, quarters) {
  const [a, b] = [
    [dx, dz],
    [dz, -dx],
    [-dx, -dz],
    [-dz, dx],
  ][quarters];
  return [x + a, 0, z + b, quarters];
}

/** A disc of 1.25 m radius on the tower's side, painted as a clock. */
function clock(shape) {
  const [radius, y, back, front] = [1.25, 9.1, 2.28, 2.42];
  const rim = Array.from({ length: 32 }, (_, i) => {
    const angle = (i / 32) * 2 * Math.PI;
    return [Math.cos(angle), Math.sin(angle)];
  });
  const at = ([c, s], r, depth) => [c * r, y + s * r, depth];
  shape.polygon(
    'sign',
    rim.map((p) => at(p, radius, front)),
    { uvs: rim.map((p) => clockUv(...p)) },
  );
  rim.forEach((p, i) => {
    const q = rim[(i + 1) % rim.length];
    shape.polygon('teal', [
      at(p, radius, back),
      at(q, radius, back),
      at(q, radius, front),
      at(p, radius, front),
    ]);
  });
  shape.polygon(
    'teal',
    [...rim].reverse().map((p) => at(p, radius, back)),
  );
}

/** [x, z] of the cypresses and of the round trees. */
// prettier-ignore
const CYPRESSES = [[-6.5, -17.5], [6.5, -17.5], [-6.5, -22], [6.5, -22], [-6.5, -26.5], [6.5, -26.5], [-14, -26.5], [-19, -27],
  [14, -27], [20, -26.5], [26.5, -9], [26.5, -4.5], [26.5, 0], [-27.5, 17], [-27.5, 21.5], [-27.5, 26]];
// prettier-ignore
const ROUND_TREES = [[-12.5, -20], [-18.5, -21.5], [-24.5, -21], [11.5, -20.5], [17.5, -22], [24, -19.5], [-22, 23], [-16, 26.5], [-17.5, 18.5], [-6, 25.5], [26.5, 9.5]];

export function trees() {
  const shape = new Shape('trees');
  CYPRESSES.forEach(([x, z], i) => {
    const tall = 5 + 2 * hash(i, 1, 5);
    const wide = 0.75 + 0.25 * hash(i, 2, 5);
    shape.place(x, 0, z);
    shape.lathe(
      'wood',
      [
        [0.16, SUNK],
        [0.12, 0.7],
      ],
      7,
    );
    const profile = [
      [0.1, 0.5],
      [0.75, 0.62],
      [1, 1.3],
      [0.95, 2.2],
      [0.72, 3.6],
      [0.4, 4.9],
      [0, 6],
    ];
    shape.lathe(
      'leaf',
      profile.map(([r, y]) => [r * wide, (y * tall) / 6 + 0.1]),
      10,
      { smooth: true, phase: hash(i, 3, 5) },
    );
  });
  ROUND_TREES.forEach(([x, z], i) => {
    const size = 1.5 + 0.5 * hash(i, 1, 6);
    shape.place(x, 0, z);
    shape.lathe(
      'wood',
      [
        [0.24, SUNK],
        [0.16, 0.5],
        [0.14, 2.2],
      ],
      8,
    );
    // Three balls of leaves: one in the middle, two lower at its sides.
    for (let k = 0; k < 3; k++) {
      const angle = 2 * Math.PI * (hash(i, 2, 6) + k / 2);
      const out = k === 0 ? 0 : 0.75 * size * 0.8;
      const r = size * (k === 0 ? 0.85 : 0.62);
      const y = 2 + size * (k === 0 ? 0.75 : 0.35);
      shape.place(x + out * Math.cos(angle), y, z + out * Math.sin(angle));
      const [rings, segments] = k === 0 ? [7, 16] : [6, 13];
      const profile = Array.from({ length: rings + 1 }, (_, j) => {
        const turn = (j / rings - 0.5) * Math.PI;
        return [j % rings === 0 ? 0 : r * Math.cos(turn), r * 0.85 * Math.sin(turn)];
      });
      shape.lathe('leaf', profile, segments, { smooth: true, phase: hash(i, k, 7) });
    }
  });
  return shape;
}

/** [x, z, quarter turns] of the benches, which look along their own +Z. */
const BENCHES = [
  [-3.2, 10.5, 2],
  [3.2, 10.5, 2],
  [-13.6, -6, 0],
  [7, -3, 0],
  [-17, 13.6, 2],
];

export function benches() {
  const shape = new Shape('benches');
  for (const [x, z, quarters] of BENCHES) {
    shape.place(x, 0, z, quarters);
    for (const side of [-0.7, 0.7])
      shape.box('stone', [side - 0.09, SUNK, -0.22], [side + 0.09, 0.4, 0.22]);
    for (const slat of [-0.17, 0, 0.17])
      shape.box('wood', [-0.95, 0.39, slat - 0.075], [0.95, 0.45, slat + 0.075]);
  }
  return shape;
}

/** Hills outside the walls, from the walls' feet out to where the fog hides them. */
export function surroundings() {
  const shape = new Shape('surroundings');
  const [AROUND, OUTWARD, FAR] = [72, 10, 190];
  const point = (i, k) => {
    const angle = ((i % AROUND) / AROUND) * 2 * Math.PI;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const near = (HALF + 0.5) / Math.max(Math.abs(c), Math.abs(s));
    const t = (k / OUTWARD) ** 1.6;
    const r = near + (FAR - near) * t;
    const [x, z] = [c * r, s * r];
    const rise = Math.min(1, Math.max(0, (r - 45) / 110));
    const hills = fbm(x / 60 + 9, z / 60 + 4, { seed: 15, octaves: 3 });
    return [x, -0.1 + rise * rise * (3 - 2 * rise) * (4 + 34 * hills * hills), z];
  };
  for (let i = 0; i < AROUND; i++)
    for (let k = 0; k < OUTWARD; k++) {
      const [a, b, c, d] = [point(i, k), point(i, k + 1), point(i + 1, k + 1), point(i + 1, k)];
      const uv = ([x, , z]) => [x / 8, z / 8];
      for (const corners of [
        [a, c, b],
        [a, d, c],
      ])
        shape.polygon('grass', corners, {
          uvs: corners.map(uv),
          tints: corners.map(([x, , z]) => patina(x / 3, z / 3)),
        });
    }
  return shape;
}
