/** Triangles with one box around them. */
export const RUN = 64;
/** Boxes are 32-bit floats: so much wider, relative to where they are. */
const ROUNDING = 1e-6;

/** A geometry's vertices and indices as plain arrays; places are `array[stride * vertex + offset + axis] * factor`. */
export interface Vertices {
  readonly array: ArrayLike<number>;
  readonly stride: number;
  readonly offset: number;
  readonly factor: number;
  readonly index: ArrayLike<number> | null;
  readonly triangles: number;
}

/** A bound as a box keeps it: no 32-bit float nearest to it leaves out what is at `value`. @param sign -1 for a least one */
export function widened(value: number, sign: number): number {
  return value + sign * ROUNDING * Math.abs(value);
}
