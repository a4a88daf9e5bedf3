import { SUNK } from '../Shape.mjs';
import { BLANK_UV, signUvs } from '../signs.mjs';

/** A plate of 0.7 × 0.35 m on a post at (x, z), read by someone who looks toward -Z turned left by `quarters` × 90°. */
export function sign(shape, name, x, z, quarters = 0, floor = 0) {
  shape.place(x, floor, z, quarters);
  shape.box('metal', [-0.025, SUNK, -0.045], [0.025, 1.3, -0.015]);
  const [left, right, low, high, front, back] = [-0.35, 0.35, 1.05, 1.4, 0.01, -0.02];
  const plain = { uvs: Array(4).fill(BLANK_UV) };
  const side = (...points) => shape.polygon('sign', points, plain);
  shape.polygon(
    'sign',
    [
      [left, low, front],
      [right, low, front],
      [right, high, front],
      [left, high, front],
    ],
    { uvs: signUvs(name) },
  );
  side([right, low, back], [left, low, back], [left, high, back], [right, high, back]);
  side([right, low, front], [right, low, back], [right, high, back], [right, high, front]);
  side([left, low, back], [left, low, front], [left, high, front], [left, high, back]);
  side([left, high, front], [right, high, front], [right, high, back], [left, high, back]);
  side([left, low, back], [right, low, back], [right, low, front], [left, low, front]);
  shape.place();
}
