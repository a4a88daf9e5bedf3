import { Matrix4, Vector3, type Object3D } from 'three';
import type { CharacterCollider, Survey } from '../../../src/character/CharacterCollider.js';
import type { AxisMaxima } from '../../../src/cube/AxisMaxima.js';
import { texelDirections } from '../../../src/cube/texelDirections.js';
import { SurfaceField } from '../../../src/field/SurfaceField.js';
import type { Solid } from './Solid.js';
import { withinReach, type World } from './World.js';

export interface WorldColliderOptions {
  /** Frames (`tick`) from a draw to its field; 0 is 'sync'. */
  latency?: number;
  resolution?: number;
  /** Draws so many times finer along each edge, and keeps the nearest of each block, as the real collider does. Default 1. */
  supersample?: number;
  far?: number;
  autoFar?: boolean;
  /** Most reads on their way; `update` passes while there are as many, as the real collider does. */
  inFlight?: number;
}

/**
 * A collider made of an analytic world, for Node. Its fields live as long as the real collider's: each is overwritten
 * two fields later.
 */
export class WorldCollider implements CharacterCollider {
  readonly position = new Vector3();
  readonly output = 'surface';
  readonly readback: 'sync' | 'async';
  readonly maxima: AxisMaxima | null = null;
  readonly autoFar: boolean;
  far: number;
  field: SurfaceField | null = null;
  readonly excluded: Object3D[] = [];
  /** Draws made, and frames begun. */
  draws = 0;
  frames = 0;
  /** Makes `update` do nothing, as a lost context does. */
  lost = false;
  readonly latency: number;
  readonly resolution: number;
  readonly inFlight: number;

  /** Drawn into first, if finer. */
  readonly #finer: SurfaceField | null;
  readonly #directions: Float32Array;
  readonly #pending: { field: SurfaceField; due: number }[] = [];
  readonly #published: SurfaceField[] = [];
  readonly #free: SurfaceField[] = [];
  readonly #drawnAt = new Vector3();
  #drawnFar = 0;
  /** What there was at the last draw, and where. */
  readonly #drawn = new Map<Solid, Matrix4>();
  readonly #survey = {
    moved: false,
    changed: true,
    deforms: false,
    sensors: [] as Object3D[],
  };

  constructor(
    readonly world: World,
    {
      latency = 0,
      resolution = 32,
      supersample = 1,
      far = 1.8,
      autoFar = true,
      inFlight = 2,
    }: WorldColliderOptions = {},
  ) {
    this.readback = latency === 0 ? 'sync' : 'async';
    this.latency = latency;
    this.resolution = resolution;
    this.far = far;
    this.autoFar = autoFar;
    this.inFlight = inFlight;
    this.#directions = texelDirections(resolution);
    this.#finer = supersample > 1 ? new SurfaceField(supersample * resolution, far) : null;
  }

  /** Begins a frame: what is due has come in meanwhile. */
  tick(): void {
    this.frames++;
    while (this.#pending.length > 0 && this.#pending[0]!.due <= this.frames) {
      this.#publish(this.#pending.shift()!.field);
    }
  }

  update(): boolean {
    if (this.lost || this.#pending.length >= this.inFlight) return false;
    this.world.refresh();
    const field = this.#free.pop() ?? this.#newField();
    field.far = this.far;
    field.serial = ++this.draws;
    field.time = performance.now();
    if (this.#finer === null) this.world.draw(field, this.position);
    else this.#drawFiner(field, this.#finer);
    this.#remember();
    if (this.latency === 0) this.#publish(field);
    else this.#pending.push({ field, due: this.frames + this.latency });
    return true;
  }

  survey(): Readonly<Survey> {
    this.world.refresh();
    const survey = this.#survey;
    survey.moved = survey.deforms = false;
    survey.changed = this.#drawnFar === 0;
    let known = 0;
    for (const solid of this.world.solids) {
      if (!solid.object.visible) continue;
      const near = withinReach(solid, this.#drawnAt, this.#drawnFar);
      if (near && solid.deforms) survey.deforms = true;
      const before = this.#drawn.get(solid);
      if (before === undefined) {
        if (near) survey.changed = true;
        continue;
      }
      known++;
      if (solid.shown !== null || before.equals(solid.object.matrixWorld)) continue;
      if (near || withinReach(solid, this.#drawnAt, this.#drawnFar, before)) survey.moved = true;
    }
    // Something that was drawn is gone or hidden, near or far.
    if (known < this.#drawn.size) survey.changed = true;
    survey.sensors.length = 0;
    for (const sensor of this.world.sensors) survey.sensors.push(sensor);
    return survey;
  }

  invalidate(): void {
    this.field = null;
    this.#free.push(...this.#published, ...this.#pending.map(({ field }) => field));
    this.#published.length = this.#pending.length = 0;
  }

  exclude(object: Object3D): void {
    this.excluded.push(object);
  }

  include(object: Object3D): void {
    this.excluded.splice(this.excluded.indexOf(object), 1);
  }

  /** Finer ones have directions of their own. */
  #newField(): SurfaceField {
    const { resolution, far } = this;
    if (this.#finer === null) return new SurfaceField(resolution, far, this.#directions);
    return new SurfaceField(resolution, far, this.#directions.slice());
  }

  #drawFiner(field: SurfaceField, finer: SurfaceField): void {
    finer.far = this.far;
    this.world.draw(finer, this.position);
    field.center.copy(this.position);
    field.clearObjects();
    finer.objects.forEach((object, i) => field.addObject(object, finer.rigid[i]!));
    const { resolution: n } = this;
    const times = finer.resolution / n;
    for (let texel = 0; texel < field.count; texel++) {
      const x = times * (texel % n);
      const y = times * Math.floor(texel / n);
      let best = -1;
      for (let fine = 0; fine < times * times; fine++) {
        const i = (y + Math.floor(fine / times)) * finer.resolution + x + (fine % times);
        if (best < 0 || finer.distance[i]! < finer.distance[best]!) best = i;
      }
      field.distance[texel] = finer.distance[best]!;
      field.front[texel] = finer.front[best]!;
      field.object[texel] = finer.object[best]!;
      field.instance[texel] = finer.instance[best]!;
      for (let v = 0; v < 3; v++) {
        field.normal[3 * texel + v] = finer.normal[3 * best + v]!;
        field.direction[3 * texel + v] = finer.direction[3 * best + v]!;
      }
    }
  }

  #publish(field: SurfaceField): void {
    this.field = field;
    this.#published.push(field);
    if (this.#published.length > 2) this.#free.push(this.#published.shift()!);
  }

  #remember(): void {
    this.#drawnAt.copy(this.position);
    this.#drawnFar = this.far;
    this.#drawn.clear();
    for (const solid of this.world.solids) {
      if (solid.object.visible) this.#drawn.set(solid, solid.object.matrixWorld.clone());
    }
  }
}
