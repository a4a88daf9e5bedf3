// Painting by code: filled boxes, soft strokes, and text in the signs' font.

import { GLYPHS, advance } from './glyphs.mjs';

/** Levels of a stroke's soft edge: few compress far better than many and look the same. */
const SOFT = 4;

const segmentDistance = (x, y, [ax, ay], [bx, by]) => {
  const [dx, dy] = [bx - ax, by - ay];
  const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - ax - dx * t, y - ay - dy * t);
};

/** A square picture of `size` pixels in one [r, g, b], 0 to 255, y down; `picture` is what came of it. */
export function canvas(size, background) {
  const pixels = new Uint8Array(size * size * 3);
  const put = (x, y, color, cover) => {
    const at = (y * size + x) * 3;
    for (let k = 0; k < 3; k++)
      pixels[at + k] = Math.round(pixels[at + k] + (color[k] - pixels[at + k]) * cover);
  };
  const fill = (x0, y0, w, h, color) => {
    for (let y = Math.round(y0); y < Math.round(y0 + h); y++)
      for (let x = Math.round(x0); x < Math.round(x0 + w); x++) put(x, y, color, 1);
  };
  /** Lines through points, `weight` to either side. */
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
            if (cover > 0) put(x, y, color, Math.round(cover * SOFT) / SOFT);
          }
      }
  };
  /** Text about (cx, cy), or with its left edge at `cx`; capitals `height` high, no wider than `width`. */
  const write = (text, cx, cy, { height, width, weight, color, left = false }) => {
    const units = [...text].reduce((sum, c) => sum + advance(c), -2);
    const scale = Math.min(height / 6, width / units);
    let x = left ? cx : cx - (units * scale) / 2;
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
  fill(0, 0, size, size, background);
  return { fill, stroke, write, picture: { size, channels: 3, pixels } };
}
