import type { Object3D, Vector3 } from 'three';
import type { AxisMaxima } from '../cube/AxisMaxima.js';
import type { SurfaceField } from '../field/SurfaceField.js';

/** What has become of the scenery around the last draw; see `CharacterCollider.survey`. */
export interface Survey {
  /** Something solid within reach has another world matrix than when it was drawn last. */
  moved: boolean;
  /** Something solid within reach came, went, or changed its shape since it was drawn last. */
  changed: boolean;
  /** Something solid within reach may deform unseen by the processor: a skin, a morph, a shader. */
  deforms: boolean;
  /** Objects within reach that report and do not block: `object.userData.sensor === true`. */
  readonly sensors: Object3D[];
}

/**
 * What a character asks of its collider: to be moved, drawn and read. `CubeCollider` is one; a test may bring one made
 * of analytic shapes. `R` and `S` are the renderer and the scene, which this layer never looks into.
 */
export interface CharacterCollider<R = unknown, S = unknown> {
  /** The cubemap's centre, in the frame of its parent (the world, if it has none). */
  readonly position: Vector3;
  /** What is read back: 'surface' fills `field`, 'axis' fills `maxima`. */
  readonly output: 'surface' | 'axis';
  /** Reach of the next draw, metres. */
  far: number;
  /** Whether a character may set `far` to what its body and speed need. */
  readonly autoFar: boolean;
  /** Newest surfaces read back, or null. */
  readonly field: SurfaceField | null;
  /** Newest maxima read back (paper's mode), or null. */
  readonly maxima: AxisMaxima | null;
  /** 'sync' if a field is there as soon as `update` returns. */
  readonly readback: 'sync' | 'async';
  /**
   * Draws around `position` and starts or finishes the read-back.
   *
   * @param patient never to wait for a read because of the way made since the last: the caller itself goes no farther than
   *   its fields vouch for
   * @returns whether it did: not while busy, or lost
   */
  update(renderer: R, scene: S, patient?: boolean): boolean;
  /**
   * Looks at what is solid within `far` of the last draw, drawing nothing, and brings world matrices up to date. Without
   * a draw yet, `changed` is true.
   *
   * @returns the same object each time
   */
  survey(scene: S): Readonly<Survey>;
  /** Forgets every field, the ones on their way included. */
  invalidate(): void;
  /** Leaves `object` and what is below it out of the cubemap. */
  exclude(object: Object3D): void;
  /** Takes `object` back in. */
  include(object: Object3D): void;
}
