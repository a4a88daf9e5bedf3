// What a walk is tested on: the stage and its gentle steps, the five flights, the ramps, the kerbs, ledge and pole.

import { SUNK, Shape } from '../Shape.mjs';
import { arcade, flight } from '../pieces.mjs';
import { map, urn } from './guide.mjs';
import { sign } from './sign.mjs';

/** Height of the stage, metres. */
const STAGE = 0.48;

/** The gentle steps straight ahead of the spawn, the stage they lead to and the wall behind it. */
export function stage(signs) {
  const steps = new Shape('steps-0.06').place(0, 0, -5);
  flight(
    steps,
    { tread: 'slab', riser: 'sage', nosing: 'nosing', side: 'stone' },
    { width: 10, rise: 0.06, run: 0.35, count: 8, platform: 6.06 },
  );
  sign(signs, 'stage', -5.5, -4.9);

  const wall = new Shape('stage-wall').place(0, 0, -13.6);
  const piers = [
    [-5.5, -4.6],
    [-2.2, -1.2],
    [1.2, 2.2],
    [4.6, 5.5],
  ];
  arcade(wall, 'stone', 'nosing', { piers, spring: 2, top: 4.1, depth: 0.2, segments: 22 });
  wall.place();
  for (const side of [-1, 1]) {
    const [from, to] = side < 0 ? [-5.48, -1.7] : [1.7, 5.48];
    wall.place().box('teal', [from, SUNK, -14.1], [to, 4.09, -13.7]);
    urn(wall.place(side * 3.4, 0, -13.2), STAGE);
  }
  // The map's front is where the niches' backs are.
  wall.place().box('teal', [-1.7, SUNK, -14.1], [1.7, 4.09, -13.72]);
  map(wall.place(0, 0, -13.7), 0.7);
  wall.place();
  wall.box('nosing', [-5.65, 4.08, -14.2], [5.65, 4.3, -13.42]);
  wall.box('terracotta', [-5.45, 4.29, -14.05], [5.45, 4.42, -13.57]);
  for (const side of [-1, 1]) {
    wall.place(side * 5.5, 0, -13.8);
    wall.box('stone', [-0.4, SUNK, -0.5], [0.4, 4.7, 0.5]);
    wall.box('nosing', [-0.5, 4.69, -0.6], [0.5, 4.85, 0.6]);
    wall.place(side * 5.5, 4.84, -13.8).lathe(
      'terracotta',
      [
        [0.2, 0],
        [0.33, 0.1],
        [0.41, 0.27],
        [0.4, 0.44],
        [0.3, 0.62],
        [0.15, 0.71],
        [0, 0.74],
      ],
      22,
      { smooth: true },
    );
  }
  return [steps, wall];
}

/** Rise and number of steps of each flight, from west to east. */
const FLIGHTS = [
  [0.1, 4],
  [0.2, 4],
  [0.3, 3],
  [0.4, 3],
  [0.5, 3],
];

export function flights(signs) {
  return FLIGHTS.map(([rise, count], i) => {
    const x = 9.5 + 3.4 * i;
    const name = `steps-${rise.toFixed(2)}`;
    const shape = new Shape(name).place(x, 0, -8);
    flight(
      shape,
      { tread: 'slab', riser: 'teal', nosing: 'nosing', side: 'stone' },
      { width: 2.6, rise, run: 0.5, count, platform: 2.2 },
    );
    sign(signs, name, x - 1.7, -7.9);
    return shape;
  });
}

/** The deck that the four ramps lead up to, metres. */
export const RAMP_HEIGHT = 1.5;
const RAMP_TOP_X = 21;

export function ramps(signs) {
  const deck = new Shape('ramp-deck');
  const middle = (i) => 4 + 3.4 * i;
  const ends = [0, 1, 2, 3].flatMap((i) => [middle(i) - 1.2, middle(i) + 1.2]);
  deck.box({ top: 'slab', side: 'stone' }, [RAMP_TOP_X, SUNK, 2.3], [23.5, RAMP_HEIGHT, 15.9], {
    z: ends,
  });
  const shapes = [15, 30, 45, 60].map((degrees, i) => {
    const z = middle(i);
    const length = RAMP_HEIGHT / Math.tan((degrees * Math.PI) / 180);
    const name = `ramp-${degrees}`;
    const shape = new Shape(name);
    const toe = RAMP_TOP_X - length;
    shape.prism(
      { top: 'terracotta', side: 'stone' },
      [
        [RAMP_TOP_X, RAMP_HEIGHT],
        [toe, 0],
        [toe, SUNK],
        [RAMP_TOP_X, SUNK],
      ],
      z - 1.2,
      z + 1.2,
    );
    sign(signs, name, toe + 0.1, z + 1.7, -1);
    return shape;
  });
  return [deck, ...shapes];
}

/** Kerbs across the way east of the spawn, that one walks over (or not) toward the 15° ramp. */
export function kerbs(signs) {
  return [0.05, 0.08, 0.12].map((height, i) => {
    const x = 5 + 3 * i;
    const name = `kerb-${height.toFixed(2)}`;
    const shape = new Shape(name);
    shape.box({ top: 'slab', side: 'ochre' }, [x, SUNK, 2.4], [x + 1, height, 5.6], {});
    sign(signs, name, x, 1.9, -1);
    return shape;
  });
}

/** A long gentle slope up to a drop of one metre. */
export function ledge(signs) {
  const shape = new Shape('ledge');
  const [edge, brink] = [18.7, 19];
  const slope = [
    [edge, 1],
    [17, 1],
    [11, 0],
    [11, SUNK],
    [edge, SUNK],
  ];
  shape.prism({ top: 'slab', side: 'stone' }, slope, -3.2, -0.8);
  const end = [
    [brink, 1],
    [edge, 1],
    [edge, SUNK],
    [brink, SUNK],
  ];
  shape.prism('terracotta', end, -3.2, -0.8);
  sign(signs, 'ledge', 11, -0.4, -1);
  return shape;
}

/** A pole of 10 mm with a pennant out of reach. */
export function pole(signs) {
  const shape = new Shape('pole-10mm').place(4, 0, 0);
  shape.lathe(
    'metal',
    [
      [0.005, SUNK],
      [0.005, 3.2],
    ],
    8,
  );
  shape.lathe(
    'ochre',
    [
      [0, 3.18],
      [0.03, 3.21],
      [0, 3.24],
    ],
    8,
    { smooth: true },
  );
  shape.prism(
    'terracotta',
    [
      [0.004, 3.15],
      [0.004, 2.75],
      [0.62, 2.95],
    ],
    -0.006,
    0.006,
  );
  sign(signs, 'pole-10mm', 5, 0);
  return shape;
}
