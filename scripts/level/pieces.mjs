// Pieces that several features are made of.

import { SUNK } from './Shape.mjs';

/** The light stripe along the edge of each step, metres. */
const NOSING = 0.06;

/**
 * A flight of steps in the shape's frame: the first riser on z = 0, climbing toward -Z, `platform` metres deep behind
 * the last riser. One closed solid; the tops lie at exact multiples of `rise`.
 */
export function flight(
  shape,
  { tread, riser, nosing, side },
  { width, rise, run, count, platform },
) {
  const [left, right] = [-width / 2, width / 2];
  for (let i = 0; i < count; i++) {
    const below = i === 0 ? SUNK : rise * i;
    const top = rise * (i + 1);
    const front = 0 - run * i;
    const edge = front - NOSING;
    const back = i === count - 1 ? front - platform : front - run;
    shape.polygon(riser, [
      [left, below, front],
      [right, below, front],
      [right, top, front],
      [left, top, front],
    ]);
    shape.polygon(nosing, [
      [left, top, front],
      [right, top, front],
      [right, top, edge],
      [left, top, edge],
    ]);
    shape.polygon(tread, [
      [left, top, edge],
      [right, top, edge],
      [right, top, back],
      [left, top, back],
    ]);
    // The sides stand on the ground; they share the lower step's corner and the stripe's end, to leave no crack.
    const step = i === 0 ? [] : [below];
    shape.polygon(side, [
      [right, SUNK, back],
      [right, top, back],
      [right, top, edge],
      [right, top, front],
      ...step.map((y) => [right, y, front]),
      [right, SUNK, front],
    ]);
    shape.polygon(side, [
      [left, SUNK, back],
      [left, SUNK, front],
      ...step.map((y) => [left, y, front]),
      [left, top, front],
      [left, top, edge],
      [left, top, back],
    ]);
    shape.polygon(side, [
      [left, SUNK, front],
      [left, SUNK, back],
      [right, SUNK, back],
      [right, SUNK, front],
    ]);
  }
  const back = -run * (count - 1) - platform;
  const top = rise * count;
  shape.polygon(side, [
    [right, SUNK, back],
    [left, SUNK, back],
    [left, top, back],
    [right, top, back],
  ]);
  return shape;
}

/**
 * A wall along X with round arches between its piers, `depth` thick about z = 0. `piers`: [from, to] pairs along x;
 * `spring`: the height where the round begins; `trim`: the material inside the arches, `segments` each. One closed solid.
 */
export function arcade(
  shape,
  wall,
  trim,
  { piers, bottom = SUNK, spring, top, depth, segments = 14 },
) {
  const [back, front] = [-depth / 2, depth / 2];
  const skirt = bottom + 0.4;
  const levels = [bottom, skirt, spring, top];
  /** Both faces over the lower edge a-b up to the upper edge c-d, each an [x, y]. */
  const faces = (a, b, c, d) => {
    shape.polygon(
      wall,
      [a, b, c, d].map(([x, y]) => [x, y, front]),
    );
    shape.polygon(
      wall,
      [b, a, d, c].map(([x, y]) => [x, y, back]),
    );
  };
  /** A face across the wall's depth over the line a-b, on its right-hand side. */
  const across = (material, [ax, ay], [bx, by]) =>
    shape.polygon(material, [
      [ax, ay, front],
      [ax, ay, back],
      [bx, by, back],
      [bx, by, front],
    ]);

  piers.forEach(([a, b], i) => {
    for (let k = 1; k < levels.length; k++) {
      const [low, high] = [levels[k - 1], levels[k]];
      faces([a, low], [b, low], [b, high], [a, high]);
      const under = high <= spring;
      if (under || i === 0) across(i === 0 ? wall : trim, [a, high], [a, low]);
      if (under || i === piers.length - 1)
        across(i === piers.length - 1 ? wall : trim, [b, low], [b, high]);
    }
    across(wall, [a, bottom], [b, bottom]);
    across(wall, [b, top], [a, top]);
  });
  for (let i = 1; i < piers.length; i++) {
    const [from, to] = [piers[i - 1][1], piers[i][0]];
    const radius = (to - from) / 2;
    const arc = Array.from({ length: segments + 1 }, (_, k) => {
      if (k === 0) return [from, spring];
      if (k === segments) return [to, spring];
      const angle = Math.PI * (1 - k / segments);
      return [from + radius + radius * Math.cos(angle), spring + radius * Math.sin(angle)];
    });
    for (let k = 1; k <= segments; k++) {
      const [a, b] = [arc[k - 1], arc[k]];
      faces(a, b, [b[0], top], [a[0], top]);
      across(trim, a, b);
      across(wall, [b[0], top], [a[0], top]);
    }
  }
  return shape;
}

/** Square bars `thickness` wide, upright every `spacing` metres from `from` to `to` along x (z = 0), under a handrail. */
export function railing(shape, bar, rail, { from, to, floor, spacing = 0.2, thickness = 0.03 }) {
  const half = thickness / 2;
  const count = Math.round((to - from - thickness) / spacing);
  for (let i = 0; i <= count; i++) {
    const x = from + half + ((to - from - thickness) * i) / count;
    shape.box(bar, [x - half, floor - 0.01, -half], [x + half, floor + 0.97, half]);
  }
  shape.box(rail, [from, floor + 0.96, -0.035], [to, floor + 1, 0.035]);
  return shape;
}
