import { Matrix4, Object3D } from 'three';

/** Halvings in search of the point of a segment nearest to a solid: to 2⁻³⁴ of its length. */
const HALVINGS = 34;

/**
 * A convex analytic solid, in float64, that knows nothing of the package: rays to draw it by and exact distances to
 * judge by. Its place is that of `object`, turned and moved but never scaled.
 *
 * A subclass says two things in its own frame: where a ray meets the surface, and which of its points is nearest to a
 * point. It answers into `nx`, `ny`, `nz`.
 */
export abstract class Solid {
  readonly object = new Object3D();
  /** Radius of a ball around the object's origin that holds all of it, metres. */
  abstract readonly bound: number;
  /** Whether the processor cannot know its shape, as of a skin: it counts as moving always. */
  deforms = false;
  /** What draws say it is, if that is not `object`: one whose own matrix does not tell where its surface lies. */
  shown: Object3D | null = null;
  /** The last answer: outward normal of `cast`, nearest point of `nearest`; own frame. */
  nx = 0;
  ny = 0;
  nz = 0;
  /** World to own frame, as of the last `refresh`. */
  readonly inverse = new Matrix4();
  readonly #seen = new Matrix4().set(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);

  constructor(name: string) {
    this.object.name = name;
  }

  /** Moves its middle, in the frame of its parent. */
  at(x: number, y: number, z: number): this {
    this.object.position.set(x, y, z);
    return this;
  }

  /** Turns it: radians about X, then Y (yaw), in the order three has for 'YXZ' (yaw is applied last). */
  turn({ pitch = 0, yaw = 0, roll = 0 }): this {
    this.object.rotation.set(pitch, yaw, roll, 'YXZ');
    return this;
  }

  /**
   * Distance along a ray to the first surface, from outside or inside, own frame; Infinity for none. Leaves the
   * outward normal there in `nx`, `ny`, `nz`.
   *
   * @param dx @param dy @param dz unit
   */
  abstract cast(ox: number, oy: number, oz: number, dx: number, dy: number, dz: number): number;

  /** Leaves the point of the solid (the point itself, inside) nearest to a point in `nx`, `ny`, `nz`; own frame. */
  abstract nearest(x: number, y: number, z: number): void;

  /** Takes over the object's world matrix. */
  refresh(): void {
    if (this.#seen.equals(this.object.matrixWorld)) return;
    this.#seen.copy(this.object.matrixWorld);
    this.inverse.copy(this.object.matrixWorld).invert();
  }

  /**
   * Exact distance from a segment to the solid, metres, 0 where it enters; own frame.
   *
   * The distance from a convex solid is convex along the segment and its square's slope is (p - nearest(p)) · d, so the
   * slope's zero is found by halving.
   */
  distance(ax: number, ay: number, az: number, bx: number, by: number, bz: number): number {
    const dx = bx - ax;
    const dy = by - ay;
    const dz = bz - az;
    let low = 0;
    let high = 1;
    for (let i = 0; i < HALVINGS; i++) {
      const t = i === 0 ? 0 : i === 1 ? 1 : (low + high) / 2;
      const x = ax + t * dx;
      const y = ay + t * dy;
      const z = az + t * dz;
      this.nearest(x, y, z);
      const slope = (x - this.nx) * dx + (y - this.ny) * dy + (z - this.nz) * dz;
      if (i === 0 && slope >= 0) high = 0;
      else if (i === 1 && slope <= 0) low = 1;
      else if (slope < 0) low = t;
      else high = t;
      if (low >= high) break;
    }
    const t = (low + high) / 2;
    const x = ax + t * dx;
    const y = ay + t * dy;
    const z = az + t * dz;
    this.nearest(x, y, z);
    return Math.sqrt((x - this.nx) ** 2 + (y - this.ny) ** 2 + (z - this.nz) ** 2);
  }
}
