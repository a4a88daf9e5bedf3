// The narrow ways west of the spawn, all in line with it: a doorway, a corridor, a low ceiling, and columns.

import { SUNK, Shape } from '../Shape.mjs';
import { arcade } from '../pieces.mjs';
import { sign } from './sign.mjs';

/** The line through all of them. */
const Z = 4;

/** A wall with a doorway of 1.0 × 2.1 m, framed in wood. */
export function doorway(signs) {
  const shape = new Shape('doorway').place(-7.15, 0, Z);
  const [half, height, frame] = [0.5, 2.1, 0.12];
  for (const side of [-1, 1]) {
    const z = (from, to) => (side > 0 ? [from, to] : [-to, -from]);
    const [a, b] = z(half + frame - 0.02, 3.5);
    shape.box({ top: 'slab', side: 'plaster' }, [-0.15, SUNK, a], [0.15, 3.0, b]);
    const [c, d] = z(half, half + frame);
    shape.box('wood', [-0.19, SUNK, c], [0.19, height + frame, d]);
    const [e, f] = z(half + frame, 3.53);
    shape.box('plum', [-0.18, SUNK, e], [0.18, 0.35, f]);
  }
  const top = half + frame - 0.02;
  shape.box(
    { top: 'slab', side: 'plaster' },
    [-0.15, height + frame - 0.02, -top],
    [0.15, 3.0, top],
  );
  shape.box('wood', [-0.188, height, -half], [0.188, height + frame - 0.002, half]);
  shape.box('tile', [-0.25, 2.99, -3.6], [0.25, 3.12, 3.6]);
  sign(signs, 'doorway', -6.7, Z - 1.3, 1);
  return shape;
}

/** Two walls 0.9 m apart, open to the sky. */
export function corridor(signs) {
  const shape = new Shape('corridor');
  for (const [from, to] of [
    [Z - 0.95, Z - 0.45],
    [Z + 0.45, Z + 0.95],
  ]) {
    shape.box({ top: 'slab', side: 'plum' }, [-15, SUNK, from], [-10, 1.2, to]);
    shape.box({ top: 'slab', side: 'plaster' }, [-15, 1.2, from], [-10, 2.6, to]);
    shape.box(
      'tile',
      [-15.1, 2.59, from < Z ? from - 0.1 : from + 0.005],
      [-9.9, 2.72, from < Z ? to - 0.005 : to + 0.1],
    );
  }
  sign(signs, 'corridor', -9.7, Z - 1.4, 1);
  return shape;
}

/** A slab 1.5 m over the floor on two low walls: crouch. */
export function lowCeiling(signs) {
  const shape = new Shape('low-ceiling');
  shape.box('plum', [-21, SUNK, Z - 1.9], [-18, 1.5, Z - 1.4]);
  shape.box('plum', [-21, SUNK, Z + 1.4], [-18, 1.5, Z + 1.9]);
  shape.box(
    { top: 'slab', side: 'plaster', bottom: 'wood' },
    [-21.15, 1.5, Z - 2.05],
    [-17.85, 1.85, Z + 2.05],
    { x: [-21, -18], z: [Z - 1.9, Z - 1.4, Z + 1.4, Z + 1.9] },
  );
  sign(signs, 'low-ceiling', -17.6, Z - 2.4, 1);
  return shape;
}

/** Two rows of columns of 0.6 m under beams of wood. */
export function columns(signs) {
  const shape = new Shape('columns');
  for (let i = 0; i < 4; i++)
    for (const side of [-1, 1]) {
      shape.place(-23.2 - 1.6 * i, 0, Z + 2 * side);
      shape.box('stone', [-0.42, SUNK, -0.42], [0.42, 0.2, 0.42]);
      shape.lathe(
        'nosing',
        [
          [0.36, 0.19],
          [0.36, 0.27],
          [0.3, 0.34],
          [0.3, 1.4],
          [0.27, 2.6],
          [0.36, 2.74],
          [0.36, 2.8],
        ],
        20,
      );
      shape.box('blue', [-0.4, 2.79, -0.4], [0.4, 2.95, 0.4]);
    }
  shape.place();
  for (const side of [-1, 1])
    shape.box('wood', [-28.7, 2.94, Z + 2 * side - 0.12], [-22.5, 3.2, Z + 2 * side + 0.12]);
  for (let i = 0; i < 9; i++) {
    const x = -22.8 - 0.7 * i;
    shape.box('wood', [x - 0.06, 3.19, Z - 2.6], [x + 0.06, 3.35, Z + 2.6]);
  }
  sign(signs, 'columns', -22.5, Z - 2.7, 1);
  return shape;
}

/** A free-standing arch, the gate of the garden. */
export function arch(signs) {
  const shape = new Shape('arch').place(-10, 0, 15);
  arcade(shape, 'stone', 'nosing', {
    piers: [
      [-2.2, -1.3],
      [1.3, 2.2],
    ],
    spring: 1.9,
    top: 3.8,
    depth: 0.9,
  });
  shape.box('nosing', [-2.35, 3.79, -0.6], [2.35, 4, 0.6]);
  shape.box('tile', [-2.2, 3.99, -0.45], [2.2, 4.15, 0.45]);
  sign(signs, 'arch', -12.9, 14.4, 2);
  return shape;
}
