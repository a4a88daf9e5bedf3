import { FACES } from '../cube/faces.js';
import { blocksOf } from './blocks.js';
import { SIDES } from './neighbours.js';
import { GOES_ON, MIXED, PIECE } from './pieces.js';

/** A block lies in one plane for sure if its texels' normals are closer than this, and none lies farther off, metres. */
export const SAME_NORMAL = 0.999999;
export const SAME_PLANE = 2e-5;

/** Which blocks of a field lie in one plane, how far, and which in the midst of it. World axes, from the field's centre. */
export class FlatBlocks {
  /** Of each block: how far the plane lies from the centre that it is in, and 1 if all its texels have surfels. */
  readonly offset: Float64Array;
  readonly whole: Uint8Array;

  /**
   * @param block as `Surfels.block`: the middle and the plane of each
   * @param ofTexel as `Surfels.ofTexel`
   */
  constructor(
    readonly resolution: number,
    readonly block: Float32Array,
    readonly ofTexel: Int32Array,
  ) {
    const { count } = blocksOf(resolution);
    this.offset = new Float64Array(count);
    this.whole = new Uint8Array(count);
  }

  /**
   * How far from its middle anything of a block can lie that is in one plane: where the rays around what it saw meet that.
   *
   * @param more how far beyond the texels' borders those pass, in texels
   * @returns metres; Infinity where they do not
   */
  extent(b: number, more: number): number {
    const { block, ofTexel, resolution: n } = this;
    const { texels, first } = blocksOf(n);
    const offset = this.offset[b]!;
    const o = PIECE * b;
    let x0 = n;
    let x1 = 0;
    let y0 = n;
    let y1 = 0;
    const end = first[b + 1]!;
    for (let a = first[b]!; a < end; a++) {
      const texel = texels[a]!;
      if (ofTexel[texel]! < 0) continue;
      const x = texel % n;
      const y = Math.floor(texel / n) % n;
      x0 = Math.min(x0, x);
      x1 = Math.max(x1, x);
      y0 = Math.min(y0, y);
      y1 = Math.max(y1, y);
    }
    const { forward: f, right: r, up: u } = FACES[Math.floor(texels[end - 1]! / (n * n))]!;
    const step = 2 / n;
    const left = step * (x0 - more) - 1;
    const right = step * (x1 + 1 + more) - 1;
    const bottom = step * (y0 - more) - 1;
    const top = step * (y1 + 1 + more) - 1;
    let farthest = 0;
    for (let c = 0; c < 4; c++) {
      const across = (c & 1) === 0 ? left : right;
      const up = c < 2 ? bottom : top;
      const rx = f[0] + across * r[0] + up * u[0];
      const ry = f[1] + across * r[1] + up * u[1];
      const rz = f[2] + across * r[2] + up * u[2];
      const depth = offset / (block[o + 4]! * rx + block[o + 5]! * ry + block[o + 6]! * rz);
      if (!(depth > 0 && depth < Infinity)) return Infinity;
      const x = depth * rx - block[o]!;
      const y = depth * ry - block[o + 1]!;
      const z = depth * rz - block[o + 2]!;
      const squared = x * x + y * y + z * z;
      if (squared > farthest) farthest = squared;
    }
    return Math.sqrt(farthest);
  }

  /** Which blocks lie in the midst of a plane: floors and walls are told apart without a closer look. */
  findMidsts(): void {
    const { count, beside, diagonal } = blocksOf(this.resolution);
    const { block } = this;
    for (let b = 0; b < count; b++) {
      if (block[PIECE * b + 7] === MIXED || this.whole[b] === 0) continue;
      let around = 0;
      while (around < SIDES && this.#isOnePlane(b, beside[SIDES * b + around]!)) around++;
      if (around < SIDES) continue;
      for (let i = 4 * b; i < 4 * b + 4 && around === SIDES; i++) {
        if (diagonal[i]! >= 0 && !this.#isOnePlane(b, diagonal[i]!)) around = 0;
      }
      if (around < SIDES) continue;
      block[PIECE * b + 7] = GOES_ON;
      // Its pieces end at its own border.
      const extent = this.extent(b, 0) * (1 + 1e-6);
      if (extent < block[PIECE * b + 3]!) block[PIECE * b + 3] = extent;
    }
  }

  /** Does another block lie in the plane of this one, whole? */
  #isOnePlane(b: number, other: number): boolean {
    const { block } = this;
    if (other < 0 || this.whole[other] === 0) return false;
    const o = PIECE * b;
    const p = PIECE * other;
    if (block[p + 7] === MIXED) return false;
    const alike =
      block[o + 4]! * block[p + 4]! + block[o + 5]! * block[p + 5]! + block[o + 6]! * block[p + 6]!;
    return alike > SAME_NORMAL && Math.abs(this.offset[b]! - this.offset[other]!) < SAME_PLANE;
  }
}

/**
 * How far beyond its own border a texel's piece goes at most, in texels along each axis of its face: to the neighbour's
 * far border, which beyond the edge of the face lies a little farther.
 */
export function beyond(resolution: number): number {
  return resolution / Math.max(1, resolution - 2);
}
