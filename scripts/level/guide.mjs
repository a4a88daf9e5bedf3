// The picture that leads through the level: its map, and the faces of the signposts.

import { canvas } from './canvas.mjs';
import { ring } from './glyphs.mjs';

const SIZE = 1024;
/** The map is in the upper left corner, the faces lie to its right and below this square. */
const MAP = 768;
const MAP_WIDTH = 536;
const FACE = [256, 192];
/** What the map shows: so many metres from north to south, from this north-west corner on. */
const SPAN = 89.4;
const CORNER = [-31.2, -31];

/** Arrows: ahead is 0, right is 0.25 turns; `back` is a turn back. */
const [AHEAD, RIGHT, LEFT, HALF_RIGHT, HALF_LEFT, BACK] = [0, 0.25, -0.25, 0.125, -0.125, 'back'];

/** [arrow, word] of each line, by face: who reads `start-north` looks north, at the start. */
// prettier-ignore
const FACES = {
  'start-north': [[BACK, 'HALL'], [RIGHT, 'STEPS'], [LEFT, 'BRIDGE']],
  'start-south': [[AHEAD, 'HALL'], [LEFT, 'RAMPS'], [RIGHT, 'DOOR']],
  'pit-south': [[AHEAD, 'HALL'], [LEFT, 'TERRAIN'], [RIGHT, 'ARCH']],
  'pit-north': [[AHEAD, 'MAP'], [HALF_RIGHT, 'STEPS'], [HALF_LEFT, 'BRIDGE']],
  'east-south': [[HALF_RIGHT, 'HALL'], [AHEAD, 'TERRAIN'], [RIGHT, 'ARCH']],
  'east-north': [[HALF_RIGHT, 'RAMPS'], [AHEAD, 'STEPS'], [HALF_LEFT, 'MAP']],
  'west-south': [[HALF_LEFT, 'HALL'], [AHEAD, 'CORRIDOR'], [HALF_RIGHT, 'COLUMNS']],
  'west-north': [[HALF_RIGHT, 'BRIDGE'], [HALF_LEFT, 'LIFT'], [RIGHT, 'MAP']],
};
const names = Object.keys(FACES);

/** A face's place in the picture: five right of the map, three below it. */
const faceAt = (i) => (i < 5 ? [MAP, i * FACE[1]] : [(i - 5) * FACE[0], MAP]);

/** The UVs of a rectangle of the picture, from its lower left corner counter-clockwise. */
const corners = (x, y, w, h) =>
  [
    [x, y + h],
    [x + w, y + h],
    [x + w, y],
    [x, y],
  ].map((corner) => corner.map((value) => value / SIZE));

export const MAP_UVS = corners(0, 0, MAP_WIDTH, MAP);
export const PLAIN_UV = [(MAP + 100) / SIZE, (SIZE - 20) / SIZE];
export function faceUvs(name) {
  const i = names.indexOf(name);
  if (i < 0) throw new Error(`no face of a signpost is named ${name}`);
  return corners(...faceAt(i), ...FACE);
}

const [PAPER, INK, WHITE, GREEN, SAND] = [
  [246, 236, 214],
  [52, 46, 42],
  [255, 250, 240],
  [176, 190, 128],
  [226, 211, 180],
];
/** The way through everything, [x, z]: out to the east, up to the hall, back through the west. */
// prettier-ignore
const WAY = [[0, 4], [6, -5], [20, -6], [23.5, -6], [15, -2], [15, 4], [16, 14], [14, 22], [1, 16.5], [1, 27], [1, 44],
  [-1, 44], [-1, 19], [-10, 15], [-26, 12], [-26, 4], [-8, 4], [-7, -8], [-13, -9.5], [-22, -11], [-24, -5], [-10, 0], [0, 4]];
/** [label, x, z] on the map. */
// prettier-ignore
const LABELS = [['TOWER', 0, -27.5], ['STEPS', 16.5, -12.5], ['LEDGE', 14, 0.4], ['KERBS', 9, 7], ['RAMPS', 23, 15.4],
  ['TERRAIN', 18, 23], ['PIT', 5.5, 12.5], ['ARCH', -15, 18.5], ['COLUMNS', -20.5, 8.2], ['DOOR', -9, 0.4], ['BRIDGE', -18, -15.8],
  ['LIFT', -25, -4.4], ['HALL', -22, 44]];
/** [label, x, z] in the hall. */
// prettier-ignore
const INSIDE = [['GROVE', -7.4, 36.2], ['FLOOR', 7.4, 36.2], ['FENCE', -6.4, 41.9], ['CREATURE', -6.8, 47.4], ['WAVES', 8, 45],
  ['RUBBLE', 7.2, 52.2], ['WALL', 0, 53]];

/** Paints it; `colors` gives each family's [r, g, b], 0 to 255. */
export function paintGuide(colors) {
  const paint = canvas(SIZE, PAPER);
  names.forEach((name, i) => paintFace(paint, FACES[name], ...faceAt(i), colors));
  paintMap(paint, colors);
  return paint.picture;
}

function paintFace({ fill, stroke, write }, lines, x, y, colors) {
  const step = FACE[1] / lines.length;
  fill(x, y, ...FACE, INK);
  lines.forEach(([turn, word], i) => {
    const hall = word === 'HALL';
    fill(x + 5, y + i * step + 3, FACE[0] - 10, step - 6, hall ? colors.terracotta : PAPER);
    const middle = y + (i + 0.5) * step;
    stroke(arrow(turn, x + 38, middle), 4.4, INK);
    write(word, x + 78, middle, { height: 34, width: 158, weight: 4, color: INK, left: true });
  });
}

/** The lines of an arrow about (x, y). */
function arrow(turn, x, y) {
  if (turn === BACK)
    return [
      [[x + 13, y + 20], ...ring(x, y - 6, 13, 13, 0.25, -0.25), [x - 13, y + 18]],
      [
        [x - 24, y + 7],
        [x - 13, y + 19],
        [x - 2, y + 7],
      ],
    ];
  const [c, s] = [Math.cos(turn * 2 * Math.PI), Math.sin(turn * 2 * Math.PI)];
  const at = ([a, b]) => [x + a * c - b * s, y + a * s + b * c];
  return [
    [
      [0, 20],
      [0, -20],
    ].map(at),
    [
      [-13, -6],
      [0, -20],
      [13, -6],
    ].map(at),
  ];
}

function paintMap({ fill, stroke, write }, colors) {
  const scale = MAP / SPAN;
  const at = ([x, z]) => [(x - CORNER[0]) * scale, (z - CORNER[1]) * scale];
  const area = (color, x0, z0, x1, z1) => {
    const [left, top] = at([x0, z0]);
    fill(left, top, (x1 - x0) * scale, (z1 - z0) * scale, color);
  };
  const disc = (color, x, z, radius) =>
    stroke([[at([x, z]), at([x, z + 0.01])]], radius * scale, color);
  area(INK, -30.6, -30.6, 30.6, 30.6);
  area(SAND, -30, -30, 30, 30);
  for (const lawn of [
    [7, -29, 29, -14],
    [-29, -29, -7, -16],
    [5, 17, 29, 29],
    [-29, 15, -12, 29],
  ])
    area(GREEN, ...lawn);
  area(INK, -13.6, 30, 13.6, 58.6);
  area(WHITE, -13, 30.6, 13, 58);
  area(SAND, -1.7, 21, 1.7, 31);

  disc(colors.teal, 0, 4, 3.9);
  disc(SAND, 0, 4, 3.2);
  area(colors.sage, -5, -13.5, 5, -5);
  area(INK, -5.5, -14.4, 5.5, -13.5);
  area(colors.plaster, -2.7, -24.7, 2.7, -19.3);
  for (let i = 0; i < 5; i++) area(colors.teal, 8.2 + 3.4 * i, -11, 10.8 + 3.4 * i, -8);
  for (let i = 0; i < 4; i++) area(colors.terracotta, 17 + i, 2.8 + 3.4 * i, 23, 5.2 + 3.4 * i);
  area(colors.terracotta, 11, -3.2, 19, -0.8);
  for (let i = 0; i < 3; i++) area(colors.ochre, 5 + 3 * i, 2.4, 6 + 3 * i, 5.6);
  area(colors.ochre, -2.5, 13.5, 2.5, 18.5);
  area(INK, -2, 14, 2, 18);
  area(colors.ochre, -0.8, 13.5, 0.8, 18.5);
  area(colors.blue, -12.2, 14.5, -7.8, 15.6);
  area(colors.blue, -28.5, 1.8, -22.8, 6.2);
  area(colors.plum, -21, 2, -18, 6);
  area(colors.plum, -15, 3, -10, 5);
  area(colors.plum, -7.5, 0.6, -6.8, 7.4);
  area(colors.blue, -22, -12, -10, -10.2);
  area(colors.blue, -27.5, -14, -22, -8);
  disc(colors.blue, -10, -12.7, 2.6);
  area(colors.sage, -12.3, 32.2, -2.5, 40.2);
  area(colors.plum, 3.4, 32.8, 11.4, 39.2);
  area(colors.blue, 3.8, 41, 12.2, 48);
  area(colors.terracotta, 5, 49.5, 11.5, 55);
  area(colors.ochre, -4, 41, 4, 42);
  area(colors.plum, -2.5, 54.6, 2.5, 55.4);

  // The way: dashes.
  const red = [192, 74, 48];
  for (let i = 1; i < WAY.length; i++) {
    const [a, b] = [at(WAY[i - 1]), at(WAY[i])];
    const count = Math.max(1, Math.round(Math.hypot(b[0] - a[0], b[1] - a[1]) / 18));
    for (let k = 0; k < count; k++) {
      const along = (t) => [0, 1].map((n) => a[n] + ((b[n] - a[n]) * t) / count);
      stroke([[along(k + 0.2), along(k + 0.7)]], 2.4, red);
    }
  }
  const label = (text, x, z, height, weight) =>
    write(text, ...at([x, z]), { height, width: 200, weight, color: INK });
  for (const [text, x, z] of LABELS) label(text, x, z, ...(text === 'HALL' ? [40, 5] : [23, 2.8]));
  for (const [text, x, z] of INSIDE) label(text, x, z, 14, 1.8);
  disc(red, 0, -12, 1.3);
  label('HERE', 0, -8.4, 23, 2.8);
  label('NORTH IS UP', -22.4, 56, 15, 1.8);
}
