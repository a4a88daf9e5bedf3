// A round tower: a stair winds around its pillar up to a platform with a view.

import { Shape } from '../Shape.mjs';

/** Steps, each so high and of so many degrees; 20 of them are a turn. */
const STEPS = 46;
const RISE = 0.19;
const TURN = (2 * Math.PI) / 20;
/** The pillar, the stair, the wall around it, metres. */
const [PILLAR, STAIR, WALL] = [0.9, 3.1, 3.6];
const TOP = STEPS * RISE;
const DOOR = 3;

const at = (radius, angle) => [radius * Math.sin(angle), radius * Math.cos(angle)];

/** A piece of a ring from one angle to another, standing from `low` to `high`. */
function piece(shape, materials, inner, outer, from, to, low, high) {
  const corners = [at(inner, from), at(outer, from), at(outer, to), at(inner, to)];
  const face = (y) => corners.map(([x, z]) => [x, y, z]);
  const [bottom, top] = [face(low), face(high)];
  shape.polygon(materials, top);
  shape.polygon(materials, [...bottom].reverse());
  for (let i = 0; i < 4; i++) {
    const k = (i + 1) % 4;
    shape.polygon(materials, [bottom[i], bottom[k], top[k], top[i]]);
  }
}

export function tower() {
  const ground = new Shape('ground');
  ground.box({ top: 'floor', side: 'stone' }, [-14, -0.5, -14], [14, 0, 14]);
  const stair = new Shape('stair');
  for (let i = 0; i < STEPS; i++) {
    const material = { top: 'nosing', side: i % 2 ? 'terracotta' : 'ochre' };
    const high = (i + 1) * RISE;
    piece(
      stair,
      material,
      PILLAR - 0.1,
      STAIR,
      i * TURN,
      (i + 1) * TURN,
      Math.max(-0.02, high - 0.5),
      high,
    );
  }
  const pillar = new Shape('pillar');
  pillar.lathe(
    'slab',
    [
      [PILLAR, -0.02],
      [PILLAR, TOP],
    ],
    20,
  );
  const wall = new Shape('wall');
  for (let i = 0; i < 20; i++) {
    const [from, to] = [i * TURN, (i + 1) * TURN];
    // The door is where the stair begins; a slit of a window every fifth piece.
    const door = i === 19 || i === 0;
    if (door) piece(wall, 'slab', WALL - 0.4, WALL, from, to, DOOR, TOP - 2.4);
    else if (i % 5 === 2) {
      piece(wall, 'slab', WALL - 0.4, WALL, from, to, -0.02, 2.2);
      piece(wall, 'slab', WALL - 0.4, WALL, from, to, 3.4, TOP - 2.4);
    } else piece(wall, 'slab', WALL - 0.4, WALL, from, to, -0.02, TOP - 2.4);
  }
  const platform = new Shape('platform');
  // Around, but for the turn that the stair comes up in.
  const last = STEPS % 20;
  for (let i = 0; i < 20; i++) {
    const from = (last + i) * TURN;
    if (i < 13)
      piece(
        platform,
        { top: 'floor', side: 'stone' },
        PILLAR - 0.1,
        STAIR + 1.2,
        from,
        from + TURN,
        TOP - 0.25,
        TOP,
      );
    const railing = i < 13 ? STAIR + 1.2 : STAIR + 0.12;
    piece(
      platform,
      'blue',
      railing - 0.12,
      railing,
      from,
      from + TURN,
      i < 13 ? TOP - 0.25 : TOP - 2.4,
      TOP + 1,
    );
  }
  platform.lathe(
    'blue',
    [
      [0.12, TOP],
      [0.12, TOP + 3.2],
    ],
    10,
  );
  platform.lathe(
    'terracotta',
    [
      [2.4, TOP + 2.6],
      [0, TOP + 4],
    ],
    12,
    { facets: true },
  );
  return { shapes: [ground, stair, pillar, wall, platform], spawn: [0.6, 0, 9] };
}
