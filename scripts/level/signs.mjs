// The signs: one picture that holds every plate.

import { canvas } from './canvas.mjs';
import { ring } from './glyphs.mjs';

/** The cells of the picture, in repeats of its width: plates are twice as wide as high. */
const ATLAS = 1024;
const CELL = [256, 128];
const COLUMNS = ATLAS / CELL[0];

/** [word, measure, colour family] of every sign, by name. */
export const SIGNS = {
  stage: ['STEPS', '6 cm', 'sage'],
  'steps-0.10': ['STEPS', '10 cm', 'teal'],
  'steps-0.20': ['STEPS', '20 cm', 'teal'],
  'steps-0.30': ['STEPS', '30 cm', 'teal'],
  'steps-0.40': ['STEPS', '40 cm', 'teal'],
  'steps-0.50': ['STEPS', '50 cm', 'teal'],
  'ramp-15': ['RAMP', '15°', 'terracotta'],
  'ramp-30': ['RAMP', '30°', 'terracotta'],
  'ramp-45': ['RAMP', '45°', 'terracotta'],
  'ramp-60': ['RAMP', '60°', 'terracotta'],
  'kerb-0.05': ['KERB', '5 cm', 'ochre'],
  'kerb-0.08': ['KERB', '8 cm', 'ochre'],
  'kerb-0.12': ['KERB', '12 cm', 'ochre'],
  doorway: ['DOOR', '1.0×2.1 m', 'plum'],
  corridor: ['CORRIDOR', '90 cm', 'plum'],
  'low-ceiling': ['CROUCH', '1.5 m', 'plum'],
  'spiral-stair': ['SPIRAL', 'UP 3 m', 'blue'],
  'pole-10mm': ['POLE', '10 mm', 'ochre'],
  ledge: ['LEDGE', '1 m', 'terracotta'],
  pit: ['PIT', '12 m', 'dark'],
  columns: ['COLUMNS', '60 cm', 'blue'],
  arch: ['ARCH', '2.6 m', 'blue'],
  terrain: ['TERRAIN', 'UP TO 40°', 'sage'],
};
const names = Object.keys(SIGNS);
/** Row from which the picture's lower part is free for the tower's clock, a square of two cells. */
const CLOCK = { x: 768, y: 768, size: 256 };

/** The UVs of a plate's front, from its lower left corner counter-clockwise. */
export function signUvs(name) {
  const index = names.indexOf(name);
  if (index < 0) throw new Error(`no sign is named ${name}`);
  const u = ((index % COLUMNS) * CELL[0]) / ATLAS;
  const v = (Math.floor(index / COLUMNS) * CELL[1]) / ATLAS;
  const [w, h] = [CELL[0] / ATLAS, CELL[1] / ATLAS];
  return [
    [u, v + h],
    [u + w, v + h],
    [u + w, v],
    [u, v],
  ];
}

/** The UV of a point of the clock's face, x right and y up in -1 to 1. */
export const clockUv = (x, y) => [
  (CLOCK.x + CLOCK.size * (0.5 + 0.48 * x)) / ATLAS,
  (CLOCK.y + CLOCK.size * (0.5 - 0.48 * y)) / ATLAS,
];

/** A plain patch of plate, for the sides and backs. */
export const BLANK_UV = [(CLOCK.x - 100) / ATLAS, (CLOCK.y + 200) / ATLAS];

/** Paints the signs' picture; `colors` gives each family's [r, g, b], 0 to 255. */
export function paintSigns(colors) {
  const [paper, ink, white] = [
    [246, 236, 214],
    [52, 46, 42],
    [255, 250, 240],
  ];
  const { fill, stroke, write, picture } = canvas(ATLAS, paper);
  names.forEach((name, i) => {
    const [word, measure, family] = SIGNS[name];
    const x = (i % COLUMNS) * CELL[0];
    const y = Math.floor(i / COLUMNS) * CELL[1];
    const middle = x + CELL[0] / 2;
    fill(x, y, CELL[0], CELL[1], colors[family]);
    fill(x + 6, y + 70, CELL[0] - 12, CELL[1] - 76, paper);
    const color = family === 'dark' ? white : ink;
    write(word, middle, y + 37, { height: 42, width: 222, weight: 4.6, color });
    write(measure, middle, y + 96, { height: 34, width: 222, weight: 3.6, color: ink });
  });

  const middle = [CLOCK.x + CLOCK.size / 2, CLOCK.y + CLOCK.size / 2];
  const polar = (turn, radius) => [
    middle[0] + radius * Math.sin(turn * 2 * Math.PI),
    middle[1] - radius * Math.cos(turn * 2 * Math.PI),
  ];
  stroke([ring(...middle, 116, 116, 0, 1, 72)], 7, colors.teal);
  for (let hour = 0; hour < 12; hour++)
    stroke([[polar(hour / 12, 86), polar(hour / 12, 100)]], hour % 3 ? 2.5 : 5, ink);
  stroke([[polar(0.5 + 10.17 / 12, 14), polar(10.17 / 12, 52)]], 5, ink);
  stroke([[polar(0.5 + 10 / 60, 18), polar(10 / 60, 82)]], 3.5, ink);
  return picture;
}
