import { Vector3 } from 'three';
import { texelDirection } from './texelDirections.js';

/**
 * The paper's whole knowledge of a cubemap: per face the texel with the highest red, equations (17)-(22).
 *
 * Plain data, in the faces' order (+X, -X, +Y, -Y, +Z, -Z). Red is the paper's r: 1 at `rMin` from the centre, 0 at
 * `rMax` (equation (10)). Where it is 0 the face saw nothing and its direction is meaningless.
 */
export class AxisMaxima {
  /** Where the cubemap was drawn: the sphere's centre, world space, metres. */
  readonly center = new Vector3();
  /** Highest red per face, 0 to 1. */
  readonly red = new Float32Array(6);
  /** Unit vector through the winning texel per face, world axes: x, y, z. */
  readonly direction = new Float32Array(18);
  /** Number of the winning texel's column and row per face. */
  readonly texel = new Uint16Array(12);

  constructor(
    /** Distance at which red is 1: the deepest penetration told apart, metres. */
    public rMin: number,
    /** Distance at which red is 0: the sphere's radius, metres. */
    public rMax: number,
  ) {}

  /** Writes one face's winner. Allocates nothing. */
  set(face: number, red: number, x: number, y: number, resolution: number): void {
    this.red[face] = red;
    this.texel[2 * face] = x;
    this.texel[2 * face + 1] = y;
    texelDirection(face, x, y, resolution, this.direction, 3 * face);
  }

  /**
   * How far a face's nearest surface reaches into the sphere, metres: (rMax - rMin) · red. The mend of (14)-(16): the
   * paper takes red itself for a length, which hides a unit of metres in its response factors.
   */
  penetration(face: number): number {
    return (this.rMax - this.rMin) * this.red[face]!;
  }

  /** Copies `source` into this one. */
  copy(source: AxisMaxima): this {
    this.center.copy(source.center);
    this.red.set(source.red);
    this.direction.set(source.direction);
    this.texel.set(source.texel);
    this.rMin = source.rMin;
    this.rMax = source.rMax;
    return this;
  }
}
