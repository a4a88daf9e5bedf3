// The high way: a spiral stair round a column, a bridge on arches, a balcony, and their railings.

import { SUNK, Shape } from '../Shape.mjs';
import { arcade, railing } from '../pieces.mjs';
import { sign } from './sign.mjs';

/** The column's middle, the height to climb, and the radii of column and treads, metres. */
const CENTRE = [-10, -12.75];
const HEIGHT = 3;
const [INNER, OUTER] = [0.9, 2.6];
const TREADS = 40;
const RISE = HEIGHT / TREADS;

/** A point about the column's axis; `step` counts treads from the first riser, fractions allowed. */
function at(radius, y, step) {
  const angle = Math.PI / 2 + (step / TREADS) * 2 * Math.PI;
  return [radius * Math.cos(angle), y, radius * Math.sin(angle)];
}

/** One turn of treads: in under the landing heading west, out on to the bridge heading west. */
export function spiralStair(signs) {
  const shape = new Shape('spiral-stair').place(CENTRE[0], 0, CENTRE[1]);
  /** The smooth underside. */
  const soffit = (step) => Math.max(SUNK, RISE * step - 0.18);
  const around = (radius, step, y) => [(step / TREADS) * Math.PI * radius, -y / 2];

  for (let i = 0; i < TREADS; i++) {
    const top = RISE * (i + 1);
    const below = i === 0 ? SUNK : RISE * i;
    shape.polygon('blue', [
      at(OUTER, below, i),
      at(INNER, below, i),
      at(INNER, top, i),
      at(OUTER, top, i),
    ]);
    for (const [a, b] of [
      [i, i + 0.5],
      [i + 0.5, i + 1],
    ]) {
      shape.polygon('slab', [
        at(OUTER, top, a),
        at(INNER, top, a),
        at(INNER, top, b),
        at(OUTER, top, b),
      ]);
      shape.polygon('stone', [
        at(OUTER, soffit(b), b),
        at(INNER, soffit(b), b),
        at(INNER, soffit(a), a),
        at(OUTER, soffit(a), a),
      ]);
      // The corner of the tread before lies on the side's front edge.
      const corner = a === i && i > 0 ? [[a, below]] : [];
      const rest = [[b, soffit(b)], [a, soffit(a)], ...corner, [a, top]];
      for (const [radius, away] of [
        [OUTER, 1],
        [INNER, -1],
      ]) {
        const outline = [[b, top], ...(away > 0 ? rest : [...rest].reverse())];
        shape.polygon(
          'plaster',
          outline.map(([s, y]) => at(radius, y, s)),
          {
            normals: outline.map(([s]) => at(away, 0, s)),
            uvs: outline.map(([s, y]) => around(radius, -s * away, y)),
          },
        );
      }
    }
  }
  const low = soffit(TREADS);
  shape.polygon('stone', [
    at(INNER, low, TREADS),
    at(OUTER, low, TREADS),
    at(OUTER, HEIGHT, TREADS),
    at(INNER, HEIGHT, TREADS),
  ]);

  const column = INNER + 0.02;
  shape.lathe(
    'stone',
    [
      [column, SUNK],
      [column, SUNK + 0.42],
      [column, 2.5],
      [column, 5.2],
    ],
    32,
  );
  shape.lathe(
    'nosing',
    [
      [column + 0.02, 5.1],
      [column + 0.2, 5.35],
      [column + 0.2, 5.5],
    ],
    32,
  );
  shape.lathe(
    'tile',
    [
      [column + 0.35, 5.49],
      [column * 0.5, 6.5],
      [0, 7.4],
    ],
    24,
    { smooth: true },
  );
  sign(signs, 'spiral-stair', CENTRE[0] + 1.6, CENTRE[1] + 3.1);
  return shape;
}

/** South and north edges of the deck. */
const [NORTH, SOUTH] = [CENTRE[1] + INNER, CENTRE[1] + OUTER];
const MIDDLE = (NORTH + SOUTH) / 2;
/** Where the bridge meets the balcony, and the balcony's other edges. */
const WEST = -22;
const BALCONY = { x0: -27.5, z0: -14, z1: -8 };
const DROP = [-25.5, -24];

export function bridge() {
  const shape = new Shape('bridge');
  const deck = { top: 'wood', side: 'stone', bottom: 'stone' };
  shape.box(deck, [WEST, 2.75, NORTH], [CENTRE[0], HEIGHT, SOUTH], { grain: 2 });
  shape.place(-17.7, 0, MIDDLE);
  arcade(shape, 'stone', 'nosing', {
    piers: [
      [-4.3, -3.5],
      [-0.4, 0.4],
      [3.5, 4.3],
    ],
    spring: 0.95,
    top: 2.76,
    depth: 1.4,
  });

  const balcony = new Shape('balcony');
  const { x0, z0, z1 } = BALCONY;
  balcony.box(
    { top: 'paving', side: 'stone', bottom: 'wood' },
    [x0, 2.75, z0],
    [WEST, HEIGHT, z1],
    { z: [NORTH, SOUTH] },
  );
  for (const x of [x0 + 0.5, (x0 + WEST) / 2, WEST - 0.5])
    for (const z of [z0 + 0.5, z1 - 0.5]) {
      balcony.place(x, 0, z);
      balcony.box('stone', [-0.35, SUNK, -0.35], [0.35, 0.3, 0.35]);
      balcony.lathe(
        'nosing',
        [
          [0.26, 0.29],
          [0.24, 2.4],
          [0.34, 2.55],
        ],
        18,
      );
      balcony.box('blue', [-0.36, 2.54, -0.36], [0.36, 2.76, 0.36]);
    }
  balcony.place();
  return [shape, balcony];
}

/** Bars of 30 mm, 0.2 m apart, round everything high; a gap in the balcony's south side is the way down. */
export function railings() {
  const shape = new Shape('railing');
  const run = (x, z, quarters, from, to) =>
    railing(shape.place(x, 0, z, quarters), 'metal', 'wood', { from, to, floor: HEIGHT });
  const { x0, z0, z1 } = BALCONY;
  const inset = 0.06;
  // Where two runs meet, the one along z holds the corner: half a handrail beyond the other's line.
  const half = 0.035;
  run(0, SOUTH - inset, 0, WEST - inset + half, CENTRE[0]);
  run(0, NORTH + inset, 0, WEST - inset + half, CENTRE[0] - 0.15);
  run(0, z0 + inset, 0, x0 + inset + half, WEST - inset - half);
  run(0, z1 - inset, 0, x0 + inset + half, DROP[0]);
  run(0, z1 - inset, 0, DROP[1], WEST - inset - half);
  // Quarter turns: x runs toward -Z.
  run(x0 + inset, 0, 1, -z1 + inset - half, -z0 - inset + half);
  run(WEST - inset, 0, 1, -z1 + inset - half, -SOUTH + inset + half);
  run(WEST - inset, 0, 1, -NORTH - inset - half, -z0 - inset + half);

  // Round the stair: a bar a tread, and a handrail that winds.
  shape.place(CENTRE[0], 0, CENTRE[1]);
  const radius = OUTER - inset;
  /** A bar along the stair, from radius a to b, step s to t, height low to high (both functions of the step). */
  const curved = (material, a, b, s, t, low, high) => {
    // Wood's grain runs with the rail.
    const uv = ([x, y, z]) => [0.03 + (0.2 * (Math.hypot(x, z) - a)) / 2, y];
    const quad = (...corners) => shape.polygon(material, corners, { uvs: corners.map(uv) });
    const [p0, p1, p2, p3] = [
      at(a, low(s), s),
      at(b, low(s), s),
      at(b, high(s), s),
      at(a, high(s), s),
    ];
    const [q0, q1, q2, q3] = [
      at(a, low(t), t),
      at(b, low(t), t),
      at(b, high(t), t),
      at(a, high(t), t),
    ];
    return { quad, p: [p0, p1, p2, p3], q: [q0, q1, q2, q3] };
  };
  const sides = ({ quad, p, q }, ends) => {
    for (let k = 0; k < 4; k++) {
      const n = (k + 1) % 4;
      // Twisted faces: two triangles each.
      quad(p[k], q[n], q[k]);
      quad(p[k], p[n], q[n]);
    }
    if (ends[0]) quad(p[3], p[2], p[1], p[0]);
    if (ends[1]) quad(q[0], q[1], q[2], q[3]);
  };
  const bar = 0.015;
  for (let i = 1; i < TREADS; i++) {
    const [s, t] = [i + 0.5 - 0.0375, i + 0.5 + 0.0375];
    const floor = RISE * (i + 1);
    sides(
      curved(
        'metal',
        radius - bar,
        radius + bar,
        s,
        t,
        () => floor - 0.01,
        () => floor + 0.93,
      ),
      [true, true],
    );
  }
  const slope = (step) => RISE * step + 1;
  for (let step = 1.4; step < TREADS - 1e-6; step = next(step))
    sides(
      curved(
        'wood',
        radius - 0.035,
        radius + 0.035,
        step,
        next(step),
        (s) => slope(s) - 0.06,
        (s) => slope(s),
      ),
      [step === 1.4, next(step) === TREADS],
    );
  return shape;
}

/** The handrail's stops: at half treads, and its end. */
const next = (step) => Math.min(TREADS, Math.floor(step * 2 + 1 + 1e-6) / 2);
