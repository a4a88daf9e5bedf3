import {
  type AnimationClip,
  Box3,
  BufferAttribute,
  Group,
  Matrix4,
  type Mesh,
  type Object3D,
  Vector3,
} from 'three';
import { playClips } from './clips.js';
import { disposeOf } from './dispose.js';
import { findStart, groundBelow, type Start } from './findStart.js';
import { createFloor } from './floor.js';
import { guessScale } from './guessScale.js';
import { boundsOf, guessUp, turnOf, type Up } from './orientation.js';
import { prepare } from './prepare.js';
import { spawnNode } from './spawnNode.js';
import { tintPlain } from './tintPlain.js';
import { collectTriangles } from './triangles.js';

/** How a file stands in the world. */
export interface Placing {
  up: Up;
  /** Metres of a unit of the file. */
  scale: number;
  /** A floor is laid below it: it has no ground of its own. */
  floor: boolean;
}

/** Below its lowest point by so much one has fallen out of a level, metres. */
const BELOW = 8;
/** Below this one has fallen into our own level's pit, metres. */
const PIT = -8;
/** So far before a thing on a floor one begins, metres. */
const BEFORE = 2.5;

/** A file to walk in: where its start is, which way is up in it, and how large it is. */
export class Level {
  /** What belongs into the scene. */
  readonly root = new Group();
  /** What the placing was guessed to be. */
  readonly guessed: Readonly<Placing>;
  readonly placing: Placing;
  /** Its box, world, metres; without the floor laid below it. */
  readonly bounds = new Box3();
  start: Start = { position: new Vector3(), yaw: 0 };

  readonly #content: Object3D;
  readonly #frame = new Group();
  readonly #mixer: ReturnType<typeof playClips>;
  #floor: Mesh | null = null;

  /**
   * @param own the demo's own level, which is placed and has its start by definition
   */
  constructor(
    readonly name: string,
    content: Object3D,
    clips: readonly AnimationClip[],
    readonly own: boolean,
  ) {
    this.#content = content;
    this.root.name = 'level';
    this.root.add(this.#frame.add(content));
    prepare(content);
    if (!own) tintPlain(content);
    this.#mixer = playClips(content, clips);
    this.placing = { up: '+Y', scale: 1, floor: false };
    this.root.updateMatrixWorld(true);
    if (own) {
      this.bounds.setFromObject(content);
      this.start = spawnNode(content) ?? this.start;
    } else this.#guess();
    this.guessed = { ...this.placing };
  }

  /** Height below which one has fallen out of it, metres. */
  get abyss(): number {
    return this.own ? PIT : this.bounds.min.y - BELOW;
  }

  /** Its longest side, metres. */
  get width(): number {
    const { x, y, z } = this.bounds.getSize(new Vector3());
    return Math.max(x, y, z);
  }

  /** Plays what moves in it. */
  update(delta: number): void {
    this.#mixer?.update(delta);
  }

  /** Puts it otherwise, and finds the start anew. */
  place(placing: Partial<Placing>): void {
    Object.assign(this.placing, placing);
    this.#begin(this.#stand(collectTriangles(this.#content)));
  }

  dispose(): void {
    this.#mixer?.stopAllAction();
    disposeOf(this.root);
  }

  #guess(): void {
    const soup = collectTriangles(this.#content);
    const up = guessUp(soup);
    const turned = new Box3().copy(boundsOf(soup)).applyMatrix4(matrixOf(up, 1));
    const scale = guessScale(turned.getSize(new Vector3()));
    Object.assign(this.placing, { up, scale });
    this.#begin(this.#stand(soup));
  }

  /**
   * Turns and scales the content, about the file's own origin.
   *
   * @param soup the file's triangles in its own units, overwritten
   * @returns them in the world, metres
   */
  #stand(soup: Float32Array): Float32Array {
    if (this.#floor !== null) disposeOf(this.#floor);
    this.#floor = null;
    const matrix = matrixOf(this.placing.up, this.placing.scale);
    matrix.decompose(this.#frame.position, this.#frame.quaternion, this.#frame.scale);
    this.root.updateMatrixWorld(true);
    new BufferAttribute(soup, 3).applyMatrix4(matrix);
    this.bounds.copy(boundsOf(soup));
    return soup;
  }

  /** At the node that says so, else where there is room; on a floor laid for it, where there is none. */
  #begin(soup: Float32Array): void {
    this.start =
      this.#byNode(soup) ?? (this.placing.floor ? null : findStart(soup)) ?? this.#onFloor();
  }

  #byNode(soup: Float32Array): Start | null {
    const said = spawnNode(this.root);
    if (said === null || this.placing.floor) return said;
    const ground = groundBelow(soup, said.position);
    if (ground === null) return null;
    said.position.y = ground + 0.03;
    return said;
  }

  #onFloor(): Start {
    this.placing.floor = true;
    this.#floor = createFloor(this.bounds);
    this.root.add(this.#floor);
    const { min, max } = this.bounds;
    const [x, z] = [(min.x + max.x) / 2, max.z + Math.max(BEFORE, 0.4 * (max.y - min.y))];
    return { position: new Vector3(x, min.y + 0.03, z), yaw: 0 };
  }
}

/** From a file's frame to the world's. */
function matrixOf(up: Up, scale: number): Matrix4 {
  return new Matrix4().makeRotationFromQuaternion(turnOf(up)).scale(new Vector3().setScalar(scale));
}
