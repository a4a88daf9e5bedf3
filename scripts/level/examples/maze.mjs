// Hedges around a small square, and one way out; nothing says where the start is.

import { Shape } from '../Shape.mjs';
import { hash } from '../noise.mjs';

/** Cells along an edge, their width, and a hedge's thickness and height, metres. */
const CELLS = 9;
const CELL = 2.6;
const [THICK, HIGH] = [0.5, 2.4];
const HALF = (CELLS * CELL) / 2;
const SIDES = [
  [0, -1],
  [1, 0],
  [0, 1],
  [-1, 0],
];

export function maze() {
  const open = carve();
  const hedges = new Shape('hedges');
  // Each hedge once: east and south of a cell, and the outer ones.
  for (let row = -1; row < CELLS; row++)
    for (let column = -1; column < CELLS; column++) {
      if (row >= 0 && !open.has(`${column},${row},1`)) wall(hedges, column + 1, row, true);
      if (column >= 0 && !open.has(`${column},${row},2`)) wall(hedges, column, row + 1, false);
    }
  const ground = new Shape('ground');
  ground.box(
    { top: 'floor', side: 'stone' },
    [-HALF - 6, -0.5, -HALF - 6],
    [HALF + 6, 0, HALF + 6],
  );
  const posts = new Shape('posts');
  for (const x of [-1, 1]) {
    posts.place(x * (CELL / 2), 0, HALF);
    posts.box('terracotta', [-0.35, -0.02, -0.35], [0.35, 3, 0.35]);
    posts.box('nosing', [-0.42, 3, -0.42], [0.42, 3.16, 0.42]);
  }
  posts.place(0, 0, 0).lathe(
    'nosing',
    [
      [0.9, -0.02],
      [0.9, 0.35],
      [0.3, 0.4],
      [0.22, 1.5],
      [0.5, 1.6],
      [0.5, 1.72],
    ],
    16,
  );
  return { shapes: [ground, hedges, posts] };
}

/** A hedge along the west (`upright`) or north side of a cell. */
function wall(shape, column, row, upright) {
  const [x, z] = [column * CELL - HALF, row * CELL - HALF];
  const half = THICK / 2;
  const [w, d] = upright ? [half, CELL + half] : [CELL + half, half];
  shape.place(x, 0, z);
  const from = upright ? [-half, -half] : [-half, -half];
  shape.box({ top: 'hedge-top', side: 'hedge' }, [from[0], -0.02, from[1]], [w, HIGH, d]);
}

/** Digs from the middle; the nine cells there, and the way out to the south, are open. */
function carve() {
  const open = new Set();
  const seen = new Set();
  const middle = (CELLS - 1) / 2;
  const pass = (column, row, side) => {
    const [dx, dz] = SIDES[side];
    open.add(`${column},${row},${side}`);
    open.add(`${column + dx},${row + dz},${(side + 2) % 4}`);
  };
  const inside = (column, row) => column >= 0 && row >= 0 && column < CELLS && row < CELLS;
  const path = [[middle, middle]];
  seen.add(`${middle},${middle}`);
  for (let n = 0; path.length > 0; n++) {
    const [column, row] = path.at(-1);
    const ways = [0, 1, 2, 3].filter((side) => {
      const [x, z] = [column + SIDES[side][0], row + SIDES[side][1]];
      return inside(x, z) && !seen.has(`${x},${z}`);
    });
    if (ways.length === 0) {
      path.pop();
      continue;
    }
    const side = ways[Math.floor(hash(n, column, row) * ways.length)];
    pass(column, row, side);
    const next = [column + SIDES[side][0], row + SIDES[side][1]];
    seen.add(next.join());
    path.push(next);
  }
  for (let row = middle - 1; row <= middle + 1; row++)
    for (let column = middle - 1; column <= middle + 1; column++) {
      if (column < middle + 1) pass(column, row, 1);
      if (row < middle + 1) pass(column, row, 2);
    }
  open.add(`${middle},${CELLS - 1},2`);
  return open;
}
