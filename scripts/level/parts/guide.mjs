// What leads a stranger through the level: signposts, the map on the stage, and a footbridge over the pit.

import { SUNK, Shape } from '../Shape.mjs';
import { MAP_UVS, PLAIN_UV, faceUvs } from '../guide.mjs';
import { plate } from './sign.mjs';

/** [front, back, x, z, quarter turns]: the front is read by who looks toward -Z, turned left. */
const POSTS = [
  ['start-north', 'start-south', 1.75, -2.2, 0],
  ['pit-south', 'pit-north', -2.4, 12.2, 2],
  ['east-south', 'east-north', 15.2, 15.4, 2],
  ['west-north', 'west-south', -17, -4.6, 0],
];

/** Boards of 1.6 × 1.2 m at the forks, printed on both sides. */
export function signposts(signs) {
  for (const [front, back, x, z, quarters] of POSTS) {
    signs.place(x, 0, z, quarters);
    for (const side of [-0.6, 0.6])
      signs.box('metal', [side - 0.03, SUNK, -0.02], [side + 0.03, 0.9, 0.02]);
    plate(signs, 'guide', [-0.8, 0.89, -0.03], [0.8, 2.09, 0.03], {
      front: faceUvs(front),
      back: faceUvs(back),
      blank: PLAIN_UV,
    });
  }
  signs.place();
}

/** The level's map, 1.5 × 2.15 m, its front on z = 0, its lower edge at `floor`, in a frame that lies a little deeper. */
export function map(shape, floor) {
  shape.box('wood', [-0.8, floor - 0.05, -0.035], [0.8, floor + 2.2, -0.012]);
  plate(shape, 'guide', [-0.75, floor, -0.03], [0.75, floor + 2.15, 0], {
    front: MAP_UVS,
    blank: PLAIN_UV,
  });
}

/** An urn with a ball of leaves on a pedestal, `floor` high. */
export function urn(shape, floor) {
  shape.box('stone', [-0.27, floor - 0.02, -0.27], [0.27, floor + 0.44, 0.27]);
  shape.box('nosing', [-0.32, floor + 0.43, -0.32], [0.32, floor + 0.51, 0.32]);
  const lift = ([radius, y]) => [radius, floor + 0.5 + y];
  shape.lathe(
    'terracotta',
    [
      [0.17, 0],
      [0.12, 0.08],
      [0.27, 0.34],
      [0.28, 0.46],
      [0.22, 0.56],
      [0.3, 0.63],
    ].map(lift),
    16,
    { smooth: true },
  );
  shape.lathe(
    'leaf',
    Array.from({ length: 8 }, (_, i) => {
      const turn = (i / 7 - 0.5) * Math.PI;
      return lift([i % 7 ? 0.42 * Math.cos(turn) : 0, 0.98 + 0.42 * Math.sin(turn)]);
    }),
    14,
    { smooth: true },
  );
}

/** A way of planks over the pit between two handrails: who walks straight on to the hall stays dry. */
export function footbridge([, z0, , z1]) {
  const shape = new Shape('footbridge');
  const [wide, out] = [0.8, 0.7];
  shape.box('wood', [-wide, -0.06, z0], [wide, 0.06, z1], { grain: 0 });
  for (const side of [-1, 1]) {
    const [a, b] = [side * out - 0.04, side * out + 0.04];
    for (let i = 0; i < 4; i++) {
      const z = z0 + 0.3 + ((z1 - z0 - 0.6) * i) / 3;
      shape.box('wood', [a, 0.05, z - 0.04], [b, 0.97, z + 0.04]);
    }
    shape.box('wood', [a - 0.01, 0.96, z0 + 0.2], [b + 0.01, 1.03, z1 - 0.2]);
    shape.box('wood', [a + 0.02, 0.5, z0 + 0.27], [b - 0.02, 0.57, z1 - 0.27]);
  }
  return shape;
}
