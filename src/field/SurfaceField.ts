import { Vector3 } from 'three';
import { texelDirections } from '../cube/texelDirections.js';

/** One texel's answer to `SurfaceField.from`: a distance, the surface's normal there, and which side was seen. */
export interface SurfaceSample {
  /** Metres from the centre; Infinity or anything beyond `far` is a miss. */
  distance: number;
  /** Unit normal toward the centre, world axes. */
  normal: readonly [number, number, number];
  /** False where the back of a triangle faces the centre. */
  front?: boolean;
}

/** Asked once a texel: what lies along `direction` (unit, world axes) from `center` (world, metres)? */
export type SurfaceSampler = (
  center: Vector3,
  direction: readonly [number, number, number],
) => SurfaceSample | null;

/**
 * One cubemap read back and decoded: where it was drawn, when, and what each texel saw.
 *
 * Everything is relative to `center` along world axes, so 32-bit numbers keep their precision however far from the
 * origin the centre (kept in doubles) lies. Texels are numbered by `texelIndex`: face by face (+X, -X, +Y, -Y, +Z, -Z),
 * row by row.
 */
export class SurfaceField {
  /** Where it was drawn, world space, metres. */
  readonly center = new Vector3();
  /** When it was drawn: `performance.now()` milliseconds. */
  time = 0;
  /** Number of the draw among its collider's. */
  serial = 0;
  /** Number of texels: 6 · resolution². */
  readonly count: number;
  /** Unit vector through each texel, world axes: x, y, z. Shared between fields of one resolution. */
  readonly direction: Float32Array;
  /** Distance from the centre to the surface seen, metres; Infinity where nothing lies within `far`. */
  readonly distance: Float32Array;
  /** Unit geometric normal, turned toward the centre, world axes: x, y, z; zero where nothing was seen. */
  readonly normal: Float32Array;
  /** 1 where a triangle's front faces the centre, 0 where its back does or nothing was seen. */
  readonly front: Uint8Array;

  constructor(
    /** Texels per face edge. */
    readonly resolution: number,
    /** How far it sees, metres. */
    public far: number,
    direction: Float32Array = texelDirections(resolution),
  ) {
    this.count = 6 * resolution * resolution;
    this.direction = direction;
    this.distance = new Float32Array(this.count).fill(Infinity);
    this.normal = new Float32Array(3 * this.count);
    this.front = new Uint8Array(this.count);
  }

  /**
   * The world position of the surface a texel saw.
   *
   * @param texel a number below `count`
   * @returns `target`; infinite where nothing was seen
   */
  point(texel: number, target: Vector3): Vector3 {
    const distance = this.distance[texel]!;
    return target.set(
      this.center.x + this.direction[3 * texel]! * distance,
      this.center.y + this.direction[3 * texel + 1]! * distance,
      this.center.z + this.direction[3 * texel + 2]! * distance,
    );
  }

  /**
   * Fills this field from an analytic function: scenes for tests, with no GPU.
   *
   * @returns this
   */
  sample(sampler: SurfaceSampler, center: Vector3): this {
    this.center.copy(center);
    const direction: [number, number, number] = [0, 0, 0];
    for (let texel = 0; texel < this.count; texel++) {
      for (let i = 0; i < 3; i++) direction[i] = this.direction[3 * texel + i]!;
      const seen = sampler(center, direction);
      const hit = seen !== null && seen.distance <= this.far;
      this.distance[texel] = hit ? seen.distance : Infinity;
      this.front[texel] = hit && seen.front !== false ? 1 : 0;
      for (let i = 0; i < 3; i++) this.normal[3 * texel + i] = hit ? seen.normal[i]! : 0;
    }
    return this;
  }

  /** A new field of an analytic function; see `sample`. */
  static from(
    sampler: SurfaceSampler,
    { resolution, far, center }: { resolution: number; far: number; center: Vector3 },
  ): SurfaceField {
    return new SurfaceField(resolution, far).sample(sampler, center);
  }
}
