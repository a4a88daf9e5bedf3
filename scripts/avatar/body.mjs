// The robot's parts: each a surface with a colour, a material and the joints that carry it.

import { ANKLE, HIP_WIDTH, SHIN, TOE, at } from './skeleton.mjs';
import { blob, bulge, mirrored, moved, ring, surface, turned, turning } from './surfaces.mjs';

const CREAM = '#f4efe6';
const DARK = '#2c343b';
const ORANGE = '#e0653a';
const RUST = '#b84c28';
const GLASS = '#10171d';
const GLOW = '#7fe8dc';

const HEAD = { middle: [0, 1.45, 0], radii: [0.25, 0.215, 0.225], power: 2.7 };

/** Wholly on one joint. */
const on = (joint) => () => [[joint, 1]];

/** From one joint to the next along an axis, over `half` metres either side of each border. */
function along(axis, borders, joints, half) {
  return (point) => {
    const passed = borders.map((border) => smooth((point[axis] - border) / (2 * half) + 0.5));
    return joints
      .map((joint, i) => [joint, (passed[i - 1] ?? 1) - (passed[i] ?? 0)])
      .filter(([, weight]) => weight > 0.002);
  };
}

function smooth(t) {
  const x = Math.min(1, Math.max(0, t));
  return x * x * (3 - 2 * x);
}

/** Every part: { positions, normals, indices, color, material, weights(point) }. */
export function body() {
  return [...head(), ...trunk(), ...pack(), ...sides(arm()), ...sides(leg())];
}

const part = (color, weights, shape, material = 'shell') => ({
  ...shape,
  color,
  weights,
  material,
});

/** Left parts, and right ones as their mirror image. */
function sides(parts) {
  const other = parts.map(({ weights, ...rest }) => ({
    ...rest,
    ...mirrored(rest),
    weights: ([x, y, z]) =>
      weights([-x, y, z]).map(([joint, weight]) => [joint.replace(/L$/, 'R'), weight]),
  }));
  return [...parts, ...other];
}

function head() {
  const carried = on('head');
  const { middle, radii, power } = HEAD;
  const upright = on('antenna');
  const [, root, behind] = at('antenna');
  const ear = (shape) => moved(shape, turning(0, 0, -Math.PI / 2), [radii[0] - 0.012, 1.445, 0]);
  const cap = [
    [0, 0.092],
    [0.03, 0.092],
    [0.044, 0.082],
    [0.046, 0.066],
    [0.034, 0.056],
    [0.034, 0],
  ];
  const ears = [
    part(ORANGE, carried, ear(turned([0, 0, 0], cap, 10, 1))),
    part(
      DARK,
      carried,
      ear(
        turned(
          [0, 0.03, 0],
          [
            [0, 0.056],
            [0.016, 0.05],
            [0.02, 0],
          ],
          10,
          1,
        ),
      ),
    ),
  ];
  return [
    part(CREAM, carried, blob(middle, radii, power, 18, 10)),
    part(DARK, carried, patch(0.8, 0.56, 0.006, 10, 5)),
    part(GLASS, carried, patch(0.74, 0.5, 0.012, 10, 8), 'glass'),
    ...sides([...ears, part(GLOW, on('eyes'), eye(), 'glow')]),
    part(
      DARK,
      upright,
      turned(
        [0, root - 0.012, behind],
        [
          [0, 0.03],
          [0.02, 0.026],
          [0.028, 0.01],
          [0.09, 0.008],
        ],
        6,
        1,
      ),
    ),
    part(ORANGE, upright, blob([0, root + 0.092, behind], [0.032, 0.032, 0.032], 2, 8, 5)),
    part(
      DARK,
      along(1, [1.22], ['chest', 'head'], 0.03),
      turned(
        [0, 0, 0],
        [
          [1.16, 0.07],
          [1.22, 0.075],
          [1.27, 0.08],
        ],
        10,
        1,
      ),
    ),
  ];
}

/** A rounded rectangle of the head's front, `out` metres before it, whose rim goes into the head. */
function patch(wide, high, out, columns, rows) {
  const { middle, radii, power } = HEAD;
  return surface(
    (u, v) => {
      const [s, t] = [2 * u - 1, 2 * v - 1];
      // A square to a square with round corners.
      const corner = 1 - 0.16 * s * s * t * t;
      const turn = wide * s * corner;
      const tilt = high * t * corner + 0.02;
      const way = [
        Math.sin(turn) * Math.cos(tilt),
        Math.sin(tilt),
        Math.cos(turn) * Math.cos(tilt),
      ];
      const rim = Math.max(Math.abs(s), Math.abs(t));
      const scale = bulge(way, power) * (1 + (out - 0.03 * smooth((rim - 0.86) / 0.14)) / 0.22);
      return way.map((value, k) => middle[k] + radii[k] * value * scale);
    },
    columns,
    rows,
    false,
  );
}

/** The left eye, a pill on the glass. */
function eye() {
  const flat = blob([0, 0, 0], [0.026, 0.048, 0.012], 2.4, 8, 5);
  return moved(flat, turning(0, 0.26), [0.082, 1.452, 0.236]);
}

function trunk() {
  const chest = on('chest');
  const bend = along(1, [0.885, 0.955], ['hips', 'spine', 'chest'], 0.035);
  const shell = [
    [0.915, 0.1, 0.08],
    [0.925, 0.14, 0.108],
    [0.96, 0.17, 0.133],
    [1.03, 0.197, 0.153],
    [1.1, 0.203, 0.155],
    [1.16, 0.185, 0.143],
    [1.205, 0.14, 0.112],
    [1.225, 0.07, 0.06],
  ];
  const bellows = [0.82, 0.87, 0.895, 0.92, 0.97].map((y, i) => [
    y,
    i % 2 === 0 ? 0.118 : 0.132,
    i % 2 === 0 ? 0.098 : 0.11,
  ]);
  const face = (shape, point) => moved(shape, turning(Math.PI / 2 - 0.06), point);
  const disc = (radius, thick) => [
    [0, radius],
    [thick * 0.7, radius],
    [thick, radius * 0.85],
    [thick, 0],
  ];
  return [
    part(CREAM, on('hips'), blob([0, 0.815, 0], [0.172, 0.088, 0.132], 2.6, 12, 6)),
    part(DARK, bend, turned([0, 0, 0], bellows, 12, 1)),
    part(CREAM, chest, turned([0, 0, 0], shell, 14, 1)),
    part(ORANGE, chest, ring([0, 1.215, 0.005], [0.115, 0.108], 0.048, 0.044, 12, 6)),
    part(ORANGE, chest, moved(flap(), turning(-0.16, 0.5, 0.16), [0.072, 1.2, 0.142])),
    part(DARK, chest, face(turned([0, 0, 0], disc(0.042, 0.02), 8, 1), [-0.075, 1.07, 0.135])),
    part(
      GLOW,
      chest,
      face(turned([0, 0, 0], disc(0.028, 0.028), 8, 1), [-0.075, 1.07, 0.135]),
      'glow',
    ),
  ];
}

/** The loose end of the scarf, hanging from its knot at the origin. */
function flap() {
  return turned(
    [0, 0, 0],
    [
      [-0.15, 0, 0],
      [-0.148, 0.036, 0.01],
      [-0.11, 0.042, 0.015],
      [-0.05, 0.036, 0.018],
      [0, 0.03, 0.022],
      [0.02, 0, 0],
    ],
    6,
    1,
  );
}

function pack() {
  const chest = on('chest');
  const strap = moved(
    ring([0, 0, 0], [0.138, 0.15], 0.013, 0.02, 9, 3),
    turning(0, 0, Math.PI / 2),
    [0.108, 1.07, 0.004],
  );
  const roll = turned(
    [0, 0, 0],
    [
      [-0.165, 0],
      [-0.16, 0.036],
      [-0.145, 0.05],
      [0, 0.052],
      [0.145, 0.05],
      [0.16, 0.036],
      [0.165, 0],
    ],
    8,
    1,
  );
  return [
    part(ORANGE, chest, blob([0, 1.085, -0.2], [0.135, 0.135, 0.085], 4.5, 12, 6)),
    part(RUST, chest, blob([0, 1.045, -0.272], [0.095, 0.062, 0.034], 4, 8, 5)),
    part(DARK, chest, moved(roll, turning(0, 0, Math.PI / 2), [0, 0.915, -0.2])),
    ...sides([part(DARK, chest, strap)]),
  ];
}

function arm() {
  const [x, shoulder] = at('upperArmL');
  const [, elbow] = at('lowerArmL');
  const [, wrist] = at('handL');
  const upper = on('upperArmL');
  const lower = on('lowerArmL');
  const hand = on('handL');
  return [
    part(ORANGE, upper, blob([x, shoulder, 0], [0.074, 0.074, 0.074], 2, 8, 5)),
    part(
      DARK,
      along(1, [elbow], ['lowerArmL', 'upperArmL'], 0.05),
      turned(
        [x, 0, 0],
        [wrist, elbow - 0.06, elbow - 0.02, elbow + 0.02, elbow + 0.06, shoulder].map((y) => [
          y,
          0.041,
        ]),
        8,
        1,
      ),
    ),
    part(
      CREAM,
      upper,
      turned(
        [x, 0, 0],
        [
          [elbow + 0.05, 0.042],
          [elbow + 0.056, 0.052],
          [elbow + 0.12, 0.055],
          [shoulder, 0.056],
        ],
        10,
        1,
      ),
    ),
    part(
      CREAM,
      lower,
      turned(
        [x, 0, 0],
        [
          [wrist - 0.004, 0.04],
          [wrist - 0.002, 0.062],
          [wrist + 0.012, 0.067],
          [wrist + 0.09, 0.06],
          [elbow - 0.06, 0.052],
          [elbow - 0.05, 0.042],
        ],
        10,
        1,
      ),
    ),
    part(DARK, hand, blob([x, wrist - 0.058, 0.004], [0.044, 0.07, 0.056], 2.5, 8, 5)),
    part(
      DARK,
      hand,
      moved(blob([0, 0, 0], [0.02, 0.042, 0.022], 2.2, 5, 4), turning(-0.5, 0, -0.25), [
        x - 0.022,
        wrist - 0.04,
        0.05,
      ]),
    ),
  ];
}

function leg() {
  const [x, hip] = at('upperLegL');
  const knee = ANKLE + SHIN;
  const limb = along(1, [ANKLE + 0.03, knee], ['footL', 'lowerLegL', 'upperLegL'], 0.055);
  const lower = on('lowerLegL');
  const foot = along(2, [TOE.ahead], ['footL', 'toesL'], 0.025);
  const flat = (shape, floor) => ({
    ...shape,
    positions: shape.positions.map((value, i) => (i % 3 === 1 ? Math.max(floor, value) : value)),
  });
  return [
    // Nothing inside the shin: its edges would shine through, a speck here and there, on some GPUs.
    part(
      DARK,
      limb,
      turned(
        [x, 0, 0],
        [
          [ANKLE - 0.02, 0.05],
          [ANKLE + 0.1, 0.052],
        ],
        8,
        1,
      ),
    ),
    part(
      DARK,
      limb,
      turned(
        [x, 0, 0],
        [
          [knee - 0.12, 0.056],
          [knee - 0.05, 0.06],
          [knee + 0.05, 0.063],
          [knee + 0.12, 0.066],
          [hip + 0.01, 0.076],
        ],
        8,
        1,
      ),
    ),
    part(
      CREAM,
      lower,
      turned(
        [x, 0, 0],
        [
          [ANKLE + 0.075, 0.05],
          [ANKLE + 0.08, 0.066],
          [ANKLE + 0.18, 0.076],
          [knee - 0.075, 0.072],
          [knee - 0.06, 0.056],
        ],
        10,
        1,
      ),
    ),
    part(CREAM, lower, blob([x, knee - 0.02, 0.042], [0.05, 0.062, 0.038], 2.4, 8, 4)),
    part(
      ORANGE,
      on('footL'),
      turned(
        [HIP_WIDTH, 0, 0],
        [
          [0.06, 0.07, 0.075],
          [0.11, 0.07],
          [0.15, 0.074],
          [0.162, 0.07],
          [0.16, 0.05],
        ],
        10,
        1,
      ),
    ),
    part(ORANGE, foot, flat(blob([x, 0.058, 0.055], [0.08, 0.07, 0.15], 2.6, 12, 6), 0.02)),
    part(DARK, foot, flat(blob([x, 0.02, 0.057], [0.086, 0.024, 0.158], 3.4, 12, 5), 0)),
  ];
}
