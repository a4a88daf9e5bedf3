import { SUNK } from '../Shape.mjs';
import { BLANK_UV, signUvs } from '../signs.mjs';

/** A flat box printed on its front, its back too if that has UVs; `blank`: the UV of a plain patch for the rest. */
export function plate(shape, material, [x0, y0, z0], [x1, y1, z1], { front, back, blank }) {
  const plain = Array(4).fill(blank);
  const face = (uvs, ...points) => shape.polygon(material, points, { uvs });
  face(front, [x0, y0, z1], [x1, y0, z1], [x1, y1, z1], [x0, y1, z1]);
  face(back ?? plain, [x1, y0, z0], [x0, y0, z0], [x0, y1, z0], [x1, y1, z0]);
  face(plain, [x1, y0, z1], [x1, y0, z0], [x1, y1, z0], [x1, y1, z1]);
  face(plain, [x0, y0, z0], [x0, y0, z1], [x0, y1, z1], [x0, y1, z0]);
  face(plain, [x0, y1, z1], [x1, y1, z1], [x1, y1, z0], [x0, y1, z0]);
  face(plain, [x0, y0, z0], [x1, y0, z0], [x1, y0, z1], [x0, y0, z1]);
}

/**
 * A plate of 1.0 × 0.5 m on a post at (x, z), printed on both sides; its front is read by someone who looks toward -Z
 * turned left by `quarters` × 90°.
 */
export function sign(shape, name, x, z, quarters = 0, floor = 0) {
  shape.place(x, floor, z, quarters);
  shape.box('metal', [-0.03, SUNK, -0.02], [0.03, 1, 0.02]);
  const uvs = signUvs(name);
  plate(shape, 'sign', [-0.5, 0.99, -0.025], [0.5, 1.49, 0.025], {
    front: uvs,
    back: uvs,
    blank: BLANK_UV,
  });
  shape.place();
}
