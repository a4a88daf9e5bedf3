import { Vector3 } from 'three';
import { CharacterController } from '../../src/character/CharacterController.js';
import type { CharacterOptions } from '../../src/character/characterOptions.js';
import { AxisResponse } from '../../src/response/AxisResponse.js';
import { AnalyticCollider, type AnalyticOptions } from './AnalyticCollider.js';
import type { Shape } from './analytic.js';

const RENDERER = {};
const SCENE = {};

/** A character by the paper's response in an analytic scene, driven frame by frame as an app would. */
export class Walker {
  readonly collider: AnalyticCollider;
  readonly character: CharacterController;

  constructor(
    shape: Shape,
    readonly rate: number,
    foot: [number, number, number] = [0, 0, 0],
    collider: AnalyticOptions = {},
    options: CharacterOptions = {},
  ) {
    this.collider = new AnalyticCollider(shape, collider);
    this.character = new CharacterController(this.collider, {
      response: new AxisResponse(),
      ...options,
    });
    this.character.teleport(new Vector3(...foot));
  }

  get at(): Vector3 {
    return this.character.position;
  }

  walk(x: number, z = 0): this {
    this.character.walk(new Vector3(x, 0, z));
    return this;
  }

  /** Runs for some seconds; `each` sees every frame after it. */
  run(seconds: number, each?: () => void): this {
    for (let i = Math.round(seconds * this.rate); i > 0; i--) {
      this.character.update(RENDERER, SCENE, 1 / this.rate);
      each?.();
    }
    return this;
  }
}
