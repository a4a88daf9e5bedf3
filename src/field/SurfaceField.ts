import { Matrix4, type Object3D, Vector3 } from 'three';
import { texelDirections } from '../cube/texelDirections.js';

/** One texel's answer to `SurfaceField.from`: a distance, the surface's normal there, and which side was seen. */
export interface SurfaceSample {
  /** Metres from the centre; Infinity or anything beyond `far` is a miss. */
  distance: number;
  /** Unit normal toward the centre, world axes. */
  normal: readonly [number, number, number];
  /** False where the back of a triangle faces the centre. */
  front?: boolean;
  /** What it belongs to. */
  object?: Object3D;
  /** Which instance of it, if it has several. */
  instance?: number;
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
  /**
   * Unit vector toward what each texel saw, world axes: x, y, z. It passes through the texel's middle, and is shared
   * between fields of one resolution; but where the collider draws finer (`supersample`) it passes through the middle of
   * the finer texel that was kept, anywhere in the texel. `directionTexel` finds the texel of any direction either way.
   */
  readonly direction: Float32Array;
  /** Distance from the centre to the surface seen, metres; Infinity where nothing lies within `far`. */
  readonly distance: Float32Array;
  /** Unit geometric normal, turned toward the centre, world axes: x, y, z; zero where nothing was seen. */
  readonly normal: Float32Array;
  /** 1 where a front faces the centre, as all of what shows both sides does; 0 where a back does or nothing was seen. */
  readonly front: Uint8Array;
  /** What each texel saw: 1 + its place in `objects`, or 0 where nothing was seen or it is not known whose it was. */
  readonly object: Uint16Array;
  /** Which instance of it each texel saw; 0 where it has but one. */
  readonly instance: Uint32Array;
  /** The objects that were drawn; `object` counts them from 1. */
  readonly objects: Object3D[] = [];
  /** World matrix of each of `objects` when it was drawn. */
  readonly matrices: Matrix4[] = [];
  /** For each of `objects`, whether only its world matrix can change what is seen of it: no skin, morph or such. */
  readonly rigid: boolean[] = [];

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
    this.object = new Uint16Array(this.count);
    this.instance = new Uint32Array(this.count);
  }

  /** Forgets `objects`, as before a new draw. The texels still hold their old numbers. */
  clearObjects(): void {
    this.objects.length = this.rigid.length = 0;
  }

  /**
   * Enters an object and the world matrix it is drawn with.
   *
   * @returns its number in `object`
   */
  addObject(object: Object3D, rigid = true): number {
    const place = this.objects.push(object) - 1;
    (this.matrices[place] ??= new Matrix4()).copy(object.matrixWorld);
    this.rigid[place] = rigid;
    return place + 1;
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
    this.time = performance.now();
    this.serial = ++samples;
    this.clearObjects();
    const direction: [number, number, number] = [0, 0, 0];
    for (let texel = 0; texel < this.count; texel++) {
      for (let i = 0; i < 3; i++) direction[i] = this.direction[3 * texel + i]!;
      const seen = sampler(center, direction);
      const hit = seen !== null && seen.distance <= this.far;
      this.distance[texel] = hit ? seen.distance : Infinity;
      this.front[texel] = hit && seen.front !== false ? 1 : 0;
      this.object[texel] = hit && seen.object !== undefined ? this.#numberOf(seen.object) : 0;
      this.instance[texel] = (hit && seen.instance) || 0;
      for (let i = 0; i < 3; i++) this.normal[3 * texel + i] = hit ? seen.normal[i]! : 0;
    }
    return this;
  }

  #numberOf(object: Object3D): number {
    return this.objects.indexOf(object) + 1 || this.addObject(object);
  }

  /** A new field of an analytic function; see `sample`. */
  static from(
    sampler: SurfaceSampler,
    { resolution, far, center }: { resolution: number; far: number; center: Vector3 },
  ): SurfaceField {
    return new SurfaceField(resolution, far).sample(sampler, center);
  }
}

/** Fields filled by `sample` so far: each has its own number. */
let samples = 0;
