// The signs: one picture that holds every plate.

import { GLYPHS, advance, ring } from './glyphs.mjs';

/** The cells of the picture, in repeats of its width: plates are twice as wide as high. */
const ATLAS = 1024;
const CELL = [256, 128];
const COLUMNS = ATLAS / CELL[0];

/** [caption, text, colour family] of every sign, by name. */
export const SIGNS = {
  stage: ['STEPS', '0.06', 'sage'],
  'steps-0.10': ['STEPS', '0.10', 'teal'],
  'steps-0.20': ['STEPS', '0.20', 'teal'],
  'steps-0.30': ['STEPS', '0.30', 'teal'],
  'steps-0.40': ['STEPS', '0.40', 'teal'],
  'steps-0.50': ['STEPS', '0.50', 'teal'],
  'ramp-15': ['RAMP', '15°', 'terracotta'],
  'ramp-30': ['RAMP', '30°', 'terracotta'],
  'ramp-45': ['RAMP', '45°', 'terracotta'],
  'ramp-60': ['RAMP', '60°', 'terracotta'],
  'kerb-0.05': ['KERB', '0.05', 'ochre'],
  'kerb-0.08': ['KERB', '0.08', 'ochre'],
  'kerb-0.12': ['KERB', '0.12', 'ochre'],
  doorway: ['DOORWAY', '1.0×2.1', 'plum'],
  corridor: ['CORRIDOR', '0.90', 'plum'],
  'low-ceiling': ['CEILING', '1.50', 'plum'],
  'spiral-stair': ['SPIRAL', '0.075', 'blue'],
  'pole-10mm': ['POLE', '10 mm', 'ochre'],
  ledge: ['LEDGE', '1.00', 'terracotta'],
  pit: ['PIT', '12 m', 'dark'],
  columns: ['COLUMNS', '0.60', 'blue'],
  arch: ['ARCH', '2.60', 'blue'],
  terrain: ['TERRAIN', '22×12', 'sage'],
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

const segmentDistance = (x, y, [ax, ay], [bx, by]) => {
  const [dx, dy] = [bx - ax, by - ay];
  const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - ax - dx * t, y - ay - dy * t);
};

/** Paints the signs' picture; `colors` gives each family's [r, g, b], 0 to 255. */
export function paintSigns(colors) {
  const rgb = new Uint8Array(ATLAS * ATLAS * 3);
  const put = (x, y, color, cover) => {
    const at = (y * ATLAS + x) * 3;
    for (let k = 0; k < 3; k++)
      rgb[at + k] = Math.round(rgb[at + k] + (color[k] - rgb[at + k]) * cover);
  };
  const [paper, ink, white] = [
    [246, 236, 214],
    [52, 46, 42],
    [255, 250, 240],
  ];
  const fill = (x0, y0, w, h, color) => {
    for (let y = y0; y < y0 + h; y++) for (let x = x0; x < x0 + w; x++) put(x, y, color, 1);
  };
  const stroke = (lines, weight, color) => {
    for (const line of lines)
      for (let i = 1; i < line.length; i++) {
        const [a, b] = [line[i - 1], line[i]];
        const pad = weight + 1;
        for (let y = Math.floor(Math.min(a[1], b[1]) - pad); y <= Math.max(a[1], b[1]) + pad; y++)
          for (
            let x = Math.floor(Math.min(a[0], b[0]) - pad);
            x <= Math.max(a[0], b[0]) + pad;
            x++
          ) {
            const cover = Math.min(1, weight + 0.5 - segmentDistance(x + 0.5, y + 0.5, a, b));
            if (cover > 0) put(x, y, color, cover);
          }
      }
  };
  /** Text centred on (cx, cy), capitals `height` high, no wider than `width`. */
  const write = (text, cx, cy, height, width, weight, color) => {
    const units = [...text].reduce((sum, c) => sum + advance(c), -2);
    const scale = Math.min(height / 6, width / units);
    let x = cx - (units * scale) / 2;
    for (const c of text) {
      if (!GLYPHS[c]) throw new Error(`the sign font has no "${c}"`);
      stroke(
        GLYPHS[c].map((line) => line.map(([gx, gy]) => [x + gx * scale, cy + (gy - 3) * scale])),
        weight,
        color,
      );
      x += advance(c) * scale;
    }
  };

  fill(0, 0, ATLAS, ATLAS, paper);
  names.forEach((name, i) => {
    const [caption, text, family] = SIGNS[name];
    const x = (i % COLUMNS) * CELL[0];
    const y = Math.floor(i / COLUMNS) * CELL[1];
    fill(x, y, CELL[0], CELL[1], colors[family]);
    fill(x + 6, y + 42, CELL[0] - 12, CELL[1] - 48, paper);
    write(caption, x + CELL[0] / 2, y + 22, 21, 220, 2.2, white);
    write(text, x + CELL[0] / 2, y + 82, 50, 214, 5.2, ink);
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
  return { size: ATLAS, channels: 3, pixels: rgb };
}
