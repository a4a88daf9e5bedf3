import type { Object3D } from 'three';
import { TEXEL_FORMATS, type TexelFormat } from '../cube/encoding.js';
import { clipPlanes } from '../cube/faceMatrices.js';
import { DEFAULTS } from '../defaults.js';
import type { TransparentPolicy } from './isSolid.js';

/** Options of `CubeCollider`. Lengths in metres. */
export interface CubeColliderOptions {
  /**
   * What is read back: 'surface', the distance, normal and facing of every texel (`field`), or 'axis', the paper's six
   * maxima (`maxima`). Default 'surface'.
   */
  output?: 'surface' | 'axis';
  /** Texels per face edge, an integer from 4 to 256. Default 32. */
  resolution?: number;
  /**
   * Surfaces are drawn this many times finer along each edge, and the GPU keeps the nearest texel of each block with all
   * it holds, its own direction included. What is at least 2·`far` / (`resolution`·`supersample`) wide is seen wherever
   * it is within reach. Costs GPU time, not reading. Default 4; 1 in the paper's mode.
   */
  supersample?: 1 | 2 | 4;
  /** Nearest distance drawn along a face's axis. Default 0.01 of the reach; surfaces nearer are not seen. */
  near?: number;
  /**
   * Reach: how far from the centre it sees. Left out, it begins at 1.8 and a character may set it to what its body and
   * speed need; in the paper's mode it is `rMax`.
   */
  far?: number;
  /**
   * 'async' copies a cubemap once the GPU has nothing queued, so reading never stalls the page; 'sync' waits for it in
   * `update`. Default 'async' for surfaces, 'sync' for the paper's mode.
   */
  readback?: 'async' | 'sync';
  /**
   * 'both': the back of a triangle is solid too and known as a back. 'drawn': triangles are culled as their material
   * culls them, and nothing is known of insides. Default 'both'.
   */
  sides?: 'both' | 'drawn';
  /**
   * What transparent materials without an alpha test are, and those that write no depth: 'ignore', no obstacles, or
   * 'solid'. Sprites, points and lines are never solid. `userData.collider` set to true makes a single mesh solid
   * whatever it wears, and though it is not visible; set to false, no obstacle with all below it. Default 'ignore'.
   */
  transparent?: TransparentPolicy;
  /** Called for each mesh within reach; returning false makes it no obstacle. Default: none. */
  filter?: (object: Object3D) => boolean;
  /** Paper's mode: the deepest penetration told apart ends here. Default half of `rMax`. */
  rMin?: number;
  /** Paper's mode: radius of the sphere. Default 0.35. */
  rMax?: number;
  /** How surface texels are stored; 'auto' takes the best the context can draw. Default 'auto'. */
  format?: TexelFormat | 'auto';
  /**
   * Asynchronous reading: how far the collider may move from its newest field before `update` waits for the next.
   * Default a quarter of the reach.
   */
  slack?: number;
  /**
   * Asynchronous reading: how old the newest field may be, seconds, before `update` waits for the next. Default 0.5.
   */
  maxAge?: number;
}

/** The options with every default in place, checked. */
export interface CubeColliderSettings {
  readonly output: 'surface' | 'axis';
  readonly resolution: number;
  readonly supersample: 1 | 2 | 4;
  readonly near: number;
  readonly far: number;
  /** The user left the reach to whoever drives the collider. */
  readonly autoFar: boolean;
  readonly readback: 'async' | 'sync';
  readonly sides: 'both' | 'drawn';
  readonly transparent: TransparentPolicy;
  readonly filter: ((object: Object3D) => boolean) | null;
  readonly rMin: number;
  readonly rMax: number;
  readonly format: TexelFormat | 'auto';
  /** Metres; null for `slackRatio` of the reach. */
  readonly slack: number | null;
  readonly slackRatio: number;
  readonly maxAge: number;
  /** Cubemaps that are drawn and read together at most: those of a `CubeColliderGroup`. */
  readonly cubemaps: number;
}

const KNOWN: Record<keyof CubeColliderOptions, true> = {
  output: true,
  resolution: true,
  supersample: true,
  near: true,
  far: true,
  readback: true,
  sides: true,
  transparent: true,
  filter: true,
  rMin: true,
  rMax: true,
  format: true,
  slack: true,
  maxAge: true,
};

/**
 * Fills in the defaults and checks what the user gave.
 *
 * @throws RangeError or TypeError, naming the option and what it may be
 */
export function resolveOptions(options: CubeColliderOptions): CubeColliderSettings {
  const d = DEFAULTS.collider;
  for (const name of Object.keys(options)) {
    if (name in KNOWN) continue;
    throw new TypeError(
      `CubeCollider: there is no option "${name}"; there are ${Object.keys(KNOWN).join(', ')}.`,
    );
  }
  const output = oneOf('output', options.output ?? d.output, ['surface', 'axis']);
  const axis = output === 'axis';

  const rMax = positive('rMax', options.rMax ?? d.rMax);
  const rMin = positive('rMin', options.rMin ?? d.rMinRatio * rMax);
  if (rMax <= rMin) fail('"rMax" must be greater than "rMin"', `${rMin}, ${rMax}`);

  const clip = clipPlanes(rMin, rMax);
  const far = positive('far', options.far ?? (axis ? clip.far : d.far));
  const near = positive('near', options.near ?? (axis ? clip.near : d.nearRatio * far));
  checkFar(far, near, axis ? rMax : 0);
  if (axis && near > rMin / Math.sqrt(3)) {
    fail('"near" must be at most "rMin"/√3 in the paper\'s mode, or corners are lost', `${near}`);
  }

  const resolution = options.resolution ?? d.resolution;
  if (!Number.isInteger(resolution) || resolution < 4 || resolution > 256) {
    fail('"resolution" must be an integer from 4 to 256', resolution);
  }
  const supersample = oneOf(
    'supersample',
    options.supersample ?? (axis ? 1 : d.supersample),
    [1, 2, 4],
  );
  if (axis && supersample !== 1) {
    fail(
      '"supersample" must be 1 in the paper\'s mode: its search is over all texels',
      supersample,
    );
  }
  const { filter = null } = options;
  if (filter !== null && typeof filter !== 'function') {
    throw new TypeError('CubeCollider: "filter" must be a function (object) => boolean.');
  }
  return {
    output,
    resolution,
    supersample,
    near,
    far,
    autoFar: !axis && options.far === undefined,
    readback: oneOf('readback', options.readback ?? (axis ? 'sync' : d.readback), [
      'async',
      'sync',
    ]),
    sides: oneOf('sides', options.sides ?? d.sides, ['both', 'drawn']),
    transparent: oneOf('transparent', options.transparent ?? d.transparent, ['ignore', 'solid']),
    filter,
    rMin,
    rMax,
    format: oneOf('format', options.format ?? d.format, ['auto', ...TEXEL_FORMATS]),
    slack: options.slack === undefined ? null : positive('slack', options.slack),
    slackRatio: d.slackRatio,
    maxAge: positive('maxAge', options.maxAge ?? d.maxAge),
    cubemaps: 1,
  };
}

/**
 * Checks a reach, metres.
 *
 * @param least the paper's sphere, 0 for surfaces
 * @returns `far`
 * @throws RangeError where it is not finite, not beyond `near`, or within the paper's sphere
 */
export function checkFar(far: number, near: number, least: number): number {
  positive('far', far);
  if (far <= near) fail('"far" must be greater than "near"', `${near}, ${far}`);
  if (far < least) fail('"far" must be at least "rMax" in the paper\'s mode', `${far}`);
  return far;
}

function fail(what: string, got: unknown): never {
  throw new RangeError(`CubeCollider: ${what} (got ${String(got)}).`);
}

function positive(name: string, value: number): number {
  if (!Number.isFinite(value) || value <= 0)
    fail(`"${name}" must be a number greater than 0`, value);
  return value;
}

function oneOf<T extends string | number>(name: string, value: T, allowed: readonly T[]): T {
  if (!allowed.includes(value)) {
    fail(
      `"${name}" must be ${allowed.map((each) => (typeof each === 'string' ? `'${each}'` : each)).join(' or ')}`,
      value,
    );
  }
  return value;
}
