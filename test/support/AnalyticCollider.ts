import { AXES } from '../../e2e/support/axisModel.js';
import { Vector3, type Object3D } from 'three';
import type { CharacterCollider, Survey } from '../../src/character/CharacterCollider.js';
import { AxisMaxima } from '../../src/cube/AxisMaxima.js';
import { texelDirections } from '../../src/cube/texelDirections.js';
import { SurfaceField } from '../../src/field/SurfaceField.js';
import type { Shape } from './analytic.js';

export interface AnalyticOptions {
  output?: 'axis' | 'surface';
  readback?: 'sync' | 'async';
  /** Frames from a draw to its data, 'async' only. */
  latency?: number;
  resolution?: number;
  rMin?: number;
  rMax?: number;
  far?: number;
  /** Red of 8 bits, as the GPU has it; else exact. */
  quantised?: boolean;
}

/**
 * A collider made of analytic shapes, for Node. The reds are searched here anew, by the rule as it is written down, with
 * rays derived here too; the winners' directions are those of `AxisMaxima`, whose texels other tests check.
 */
export class AnalyticCollider implements CharacterCollider {
  readonly position = new Vector3();
  readonly readback: 'sync' | 'async';
  readonly output: 'axis' | 'surface';
  /** Fixed: the paper's loop sets no reach. */
  readonly autoFar = false;
  readonly excluded: Object3D[] = [];
  maxima: AxisMaxima | null = null;
  field: SurfaceField | null = null;
  draws = 0;
  /** Makes `update` do nothing, as a lost context does. */
  lost = false;
  readonly options: Required<AnalyticOptions>;
  readonly #survey = { moved: false, changed: true, deforms: false, sensors: [] };
  readonly #directions: Float32Array;
  readonly #pending: { maxima: AxisMaxima | null; field: SurfaceField | null; due: number }[] = [];

  constructor(
    public shape: Shape,
    {
      output = 'axis',
      readback = output === 'axis' ? 'sync' : 'async',
      latency = 2,
      resolution = 16,
      rMax = 0.35,
      rMin = rMax / 2,
      far = 1.8,
      quantised = true,
    }: AnalyticOptions = {},
  ) {
    this.readback = readback;
    this.output = output;
    this.#directions = texelDirections(resolution);
    this.options = { output, readback, latency, resolution, rMin, rMax, far, quantised };
  }

  update(): boolean {
    if (this.lost) return false;
    this.draws++;
    const axis = this.options.output === 'axis';
    const maxima = axis ? this.#maxima() : null;
    const field = axis ? null : this.#field();
    const late = this.readback === 'sync' ? 0 : this.options.latency;
    this.#pending.push({ maxima, field, due: this.draws + late });
    while (this.#pending.length > 0 && this.#pending[0]!.due <= this.draws) {
      const arrived = this.#pending.shift()!;
      this.maxima = arrived.maxima;
      this.field = arrived.field;
    }
    return true;
  }

  get far(): number {
    return this.options.far;
  }

  set far(far: number) {
    this.options.far = far;
  }

  /** Nothing here ever changes, but what is not drawn yet. */
  survey(): Readonly<Survey> {
    this.#survey.changed = this.draws === 0;
    return this.#survey;
  }

  invalidate(): void {
    this.maxima = null;
    this.field = null;
    this.#pending.length = 0;
  }

  exclude(object: Object3D): void {
    this.excluded.push(object);
  }

  include(object: Object3D): void {
    this.excluded.splice(this.excluded.indexOf(object), 1);
  }

  #maxima(): AxisMaxima {
    const { resolution: n, rMin, rMax } = this.options;
    const target = new AxisMaxima(rMin, rMax);
    target.center.copy(this.position);
    for (let face = 0; face < 6; face++) {
      const red = redTexels(this.shape, this.position, face, this.options);
      let best = 0;
      for (let i = 1; i < n * n; i++) {
        if (red[i]! < red[best]!) continue;
        if (red[i]! > red[best]! || offMiddle(i, n) < offMiddle(best, n)) best = i;
      }
      target.set(face, red[best]!, best % n, Math.floor(best / n), n);
    }
    return target;
  }

  /** Distances alone: no test here asks for normals. */
  #field(): SurfaceField {
    const field = new SurfaceField(this.options.resolution, this.options.far, this.#directions);
    const { direction, distance } = field;
    const { x, y, z } = field.center.copy(this.position);
    for (let i = 0, k = 0; i < field.count; i++, k += 3) {
      const seen = this.shape(x, y, z, direction[k]!, direction[k + 1]!, direction[k + 2]!);
      distance[i] = seen <= field.far ? seen : Infinity;
    }
    return field;
  }
}

/** How far from a face's middle a texel is: squared, in half texels. */
const offMiddle = (texel: number, n: number) =>
  (2 * (texel % n) + 1 - n) ** 2 + (2 * Math.floor(texel / n) + 1 - n) ** 2;

/** Red of every texel of a face, row by row, by casting its middle's ray. */
export function redTexels(
  shape: Shape,
  center: Vector3,
  face: number,
  {
    resolution: n,
    rMin,
    rMax,
    quantised,
  }: { resolution: number; rMin: number; rMax: number; quantised: boolean },
): Float64Array {
  const [fx, fy, fz, rx, ry, rz, ux, uy, uz] = AXES[face]!;
  const red = new Float64Array(n * n);
  for (let i = 0; i < n * n; i++) {
    const u = ((i % n) + 0.5) * (2 / n) - 1;
    const v = (Math.floor(i / n) + 0.5) * (2 / n) - 1;
    const l = Math.hypot(1, u, v);
    const t = shape(
      center.x,
      center.y,
      center.z,
      (fx + u * rx + v * ux) / l,
      (fy + u * ry + v * uy) / l,
      (fz + u * rz + v * uz) / l,
    );
    const exact = t >= rMax ? 0 : t <= rMin ? 1 : (rMax - t) / (rMax - rMin);
    red[i] = quantised ? Math.round(exact * 255) / 255 : exact;
  }
  return red;
}
