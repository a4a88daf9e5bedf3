// The pictures: tileable, 2 m by 2 m each, painted with a little light and shade so that joints and planks stand out.

import sharp from 'sharp';
import { paintGuide } from './guide.mjs';
import { fbm, hash, noise } from './noise.mjs';
import { MATERIALS } from './palette.mjs';
import { paintSigns } from './signs.mjs';

const SIZE = 512;
const clamp = (value, low = 0, high = 1) => Math.min(high, Math.max(low, value));
const mix = (a, b, t) => a + (b - a) * t;
const blend = (a, b, t) => a.map((value, k) => mix(value, b[k], t));
const scale = (color, by) => color.map((value) => value * by);

/** Fine grain, in a few levels only. */
const grain = (x, y, seed, levels = 3) =>
  (Math.floor(hash(x, y, seed) * levels) / (levels - 1) - 0.5) * 2;

/** `paint(u, v, x, y)` gives a grey or an [r, g, b], 0 to 255, for u, v in 0 to 1. */
function picture(size, paint) {
  const channels = Array.isArray(paint(0, 0, 0, 0)) ? 3 : 1;
  const pixels = new Uint8Array(size * size * channels);
  for (let y = 0; y < size; y++)
    for (let x = 0; x < size; x++) {
      const value = paint((x + 0.5) / size, (y + 0.5) / size, x, y);
      const at = (y * size + x) * channels;
      if (channels === 1) pixels[at] = clamp(Math.round(value), 0, 255);
      else for (let k = 0; k < 3; k++) pixels[at + k] = clamp(Math.round(value[k]), 0, 255);
    }
  return { size, channels, pixels };
}

/** Light at a block's edges: 1 inside, bright along the top and left bevel, dark below and right, darkest in the joint. */
function bevel(left, top, right, bottom, joint, width) {
  const near = Math.min(left, top, right, bottom);
  if (near < joint) return 0.62;
  if (Math.min(left, top) < joint + width && Math.min(left, top) <= Math.min(right, bottom))
    return 1.07;
  if (Math.min(right, bottom) < joint + width) return 0.87;
  return 1;
}

const paving = () =>
  picture(SIZE, (u, v, x, y) => {
    const [column, row] = [Math.floor(u * 2), Math.floor(v * 2)];
    const [a, b] = [u * 2 - column, v * 2 - row];
    const tone = 0.9 + 0.09 * hash(column, row, 11);
    const cloud = fbm(u * 6, v * 6, { seed: 20, octaves: 3, period: 6 }) - 0.5;
    const pit = noise(u * 128, v * 128, 31, 128) > 0.93 ? 0.93 : 1;
    const edge = bevel(a, b, 1 - a, 1 - b, 0.008, 0.012);
    return 246 * tone * edge * pit * (1 + 0.13 * cloud) + 1.5 * grain(x, y, 41);
  });

const plaster = () =>
  picture(SIZE, (u, v, x, y) => {
    const cloud = fbm(u * 4, v * 4, { seed: 50, octaves: 4, period: 4 }) - 0.5;
    const trowel = fbm(u * 8, v * 24, { seed: 60, octaves: 2, period: 8 }) - 0.5;
    const line = Math.min(Math.abs(((u * 2 + 0.5) % 1) - 0.5), Math.abs(((v * 2 + 0.5) % 1) - 0.5));
    const faint = line < 0.005 ? 0.9 : line < 0.01 ? 0.96 : 1;
    return 238 * faint * (1 + 0.1 * cloud + 0.04 * trowel) + 1.5 * grain(x, y, 71);
  });

const stone = () =>
  picture(SIZE, (u, v, x, y) => {
    const row = Math.floor(v * 8);
    const across = u * 4 + (row % 2) / 2;
    const column = Math.floor(across) % 4;
    const [a, b] = [(across % 1) * 0.5, (v * 8 - row) * 0.25];
    const wobble = 0.004 * (noise(u * 64, v * 64, 81, 64) - 0.5);
    const edge = bevel(a + wobble, b + wobble, 0.5 - a, 0.25 - b, 0.007, 0.01);
    const tone = 0.84 + 0.16 * hash(column, row, 90);
    const cloud = fbm(u * 16, v * 16, { seed: 100, octaves: 3, period: 16 }) - 0.5;
    return 240 * tone * edge * (1 + 0.18 * cloud) + 2 * grain(x, y, 111);
  });

const wood = () =>
  picture(SIZE, (u, v) => {
    const plank = Math.floor(u * 10);
    const a = u * 10 - plank;
    const end = (v + 0.37 * plank) % 1;
    const joint =
      a < 0.03 || a > 0.97 || end < 0.004 ? 0.45 : a < 0.08 ? 1.08 : a > 0.92 ? 0.85 : 1;
    const fibre = fbm(u * 80, v * 4, { seed: 120 + plank, octaves: 2 }) - 0.5;
    const seamless = Math.sin(v * 2 * Math.PI) * 0.5;
    const rings = Math.sin((a * 3 + seamless + hash(plank, 0, 130) * 6) * 6) * 0.05;
    const color = blend([176, 124, 78], [206, 158, 106], hash(plank, 1, 131));
    return scale(color, joint * (1 + rings + 0.22 * fibre * Math.sin(v * Math.PI)));
  });

const grass = () =>
  picture(SIZE, (u, v) => {
    const cloud = fbm(u * 8, v * 8, { seed: 140, octaves: 4, period: 8 });
    const blades = noise(u * 170, v * 64, 150, 170, 64);
    const color = blend(
      [104, 124, 62],
      [150, 160, 86],
      Math.round(24 * clamp(cloud * 1.5 - 0.25)) / 24,
    );
    const light = 0.88 + (0.24 * Math.round(blades * 6)) / 6;
    return scale(color, light);
  });

const leaf = () =>
  picture(256, (u, v) => {
    const clump = fbm(u * 16, v * 16, { seed: 170, octaves: 3, period: 16 });
    const shade = Math.round(clamp(clump * 1.7 - 0.35) * 10) / 10;
    return blend([52, 76, 44], [112, 138, 76], shade);
  });

const metal = () =>
  picture(256, (u, v, _, y) => {
    const brushed = noise(u * 4, v * 256, 180, 4) - 0.5;
    return 232 * (1 + 0.14 * brushed) + grain(0, y, 190);
  });

/** Roof tiles: rows of rounded ends, 0.25 m by 0.25 m. */
const tile = () =>
  picture(SIZE, (u, v) => {
    const row = Math.floor(v * 8);
    const across = u * 8 + (row % 2) / 2;
    const column = Math.floor(across) % 8;
    const [a, b] = [across % 1, v * 8 - row];
    const lip = 0.72 + 0.22 * Math.sqrt(Math.max(0, 1 - (2 * a - 1) ** 2));
    const own = b < lip;
    const tone = 0.82 + 0.22 * hash(own ? column : column + 3, own ? row : row + 1, 200);
    const round = 0.8 + 0.25 * Math.sin(a * Math.PI);
    const light = own ? round * (b > lip - 0.07 ? 1.12 : 0.86 + 0.16 * b) : 0.5;
    return scale([204, 112, 74], tone * light);
  });

/** The pit's walls, for its whole depth (v: 0 at the rim, 1 at the bottom): stone that sinks into the dark. */
const shaft = () =>
  picture(256, (u, v) => {
    const row = Math.floor(v * 24);
    const across = u * 8 + (row % 2) / 2;
    const [a, b] = [across % 1, v * 24 - row];
    const joint = a < 0.04 || b < 0.08 ? 0.7 : 1;
    const tone = 0.85 + 0.15 * hash(Math.floor(across) % 8, row, 210);
    return scale([196, 170, 138], joint * tone * Math.max(0, 1 - v * 1.25) ** 1.6);
  });

/** The star laid into the plaza, 8 m by 8 m: rings and points of coloured stone, each with a thin joint. */
const rosette = () => {
  const [sand, teal, terracotta, cream] = [
    [211, 196, 169],
    [104, 158, 152],
    [196, 132, 102],
    [228, 216, 194],
  ];
  const flat = (p, q) => {
    const radius = Math.hypot(p, q);
    const turn = (Math.atan2(p, q) / (2 * Math.PI) + 1) * 8;
    // Distance across a kite from its axis, 0 on it and 1 on its edge; kites alternate long and short.
    const kite = (phase, every, tip, waist, width) => {
      const a = (((turn + phase) / every + 0.5) % 1) - 0.5;
      const along = radius * Math.cos((a * every * Math.PI) / 4);
      const across = radius * Math.sin((a * every * Math.PI) / 4);
      const half =
        along < waist ? (width * along) / waist : (width * (tip - along)) / (tip - waist);
      return along < tip && Math.abs(across) < half ? Math.sign(across) || 1 : 0;
    };
    if (radius > 3.86) return sand;
    if (radius > 3.56) return Math.floor(turn * 4) % 2 ? terracotta : cream;
    if (radius > 3.46) return teal;
    if (radius < 0.34) return cream;
    if (radius < 0.48) return terracotta;
    const long = kite(0, 2, 3.3, 0.9, 0.42);
    if (long) return long > 0 ? teal : cream;
    const short = kite(1, 2, 2.3, 0.8, 0.33);
    if (short) return short > 0 ? terracotta : cream;
    return radius > 2.55 && radius < 2.7 ? terracotta : sand;
  };
  return picture(1024, (u, v) => {
    const [p, q] = [(u - 0.5) * 8, (v - 0.5) * 8];
    // Four samples a texel, and a joint wherever they or their neighbours differ.
    const step = 0.011;
    const samples = [
      [-1, -1],
      [1, -1],
      [-1, 1],
      [1, 1],
    ].map(([a, b]) => flat(p + a * step, q + b * step));
    const mean = [0, 1, 2].map((k) => samples.reduce((sum, color) => sum + color[k], 0) / 4);
    const joint = samples.some((color) => color !== samples[0]) ? 0.72 : 1;
    const slab = Math.min(...[p, q].map((c) => Math.abs(c - Math.round(c)))) < 0.006 ? 0.8 : 1;
    return scale(mean, Math.min(joint, slab));
  });
};

/**
 * As WebP: without loss where that is smaller, as it is of plain colours with sharp edges; else nearly so, which takes a
 * tenth of the bytes of grain and cloud.
 */
async function encode({ size, channels, pixels }) {
  const image = sharp(pixels, { raw: { width: size, height: size, channels } });
  const [exact, near] = await Promise.all([
    image.clone().webp({ lossless: true, effort: 6 }).toBuffer(),
    image.clone().webp({ quality: 90, smartSubsample: true, effort: 6 }).toBuffer(),
  ]);
  return exact.length <= near.length ? exact : near;
}

/** The baked occlusion, `size` × `size` values in 0 to 1, as a picture. */
export const occlusionTexture = (values, size) =>
  encode({
    size,
    channels: 1,
    pixels: Uint8Array.from(values, (value) => Math.round(value * 255)),
  });

/** Every texture by name, as WebP files. */
export async function textures() {
  const rgb = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
  const families = Object.fromEntries(
    Object.entries(MATERIALS).map(([name, { color }]) => [name, rgb(color)]),
  );
  const painted = {
    paving,
    plaster,
    stone,
    wood,
    grass,
    leaf,
    metal,
    tile,
    shaft,
    rosette,
    sign: () => paintSigns(families),
    guide: () => paintGuide(families),
  };
  const named = Object.entries(painted).map(async ([name, paint]) => [name, await encode(paint())]);
  return Object.fromEntries(await Promise.all(named));
}
