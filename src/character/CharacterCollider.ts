import type { Object3D, Vector3 } from 'three';
import type { AxisMaxima } from '../cube/AxisMaxima.js';
import type { SurfaceField } from '../field/SurfaceField.js';

/**
 * What a character asks of its collider: to be moved, drawn and read. `CubeCollider` is one; a test may bring one made
 * of analytic shapes. `R` and `S` are the renderer and the scene, which this layer never looks into.
 */
export interface CharacterCollider<R = unknown, S = unknown> {
  /** The cubemap's centre, in the frame of its parent (the world, if it has none). */
  readonly position: Vector3;
  /** Newest surfaces read back, or null. */
  readonly field: SurfaceField | null;
  /** Newest maxima read back (paper's mode), or null. */
  readonly maxima: AxisMaxima | null;
  /** 'sync' if a field is there as soon as `update` returns. */
  readonly readback: 'sync' | 'async';
  /** Draws around `position` and starts or finishes the read-back. */
  update(renderer: R, scene: S): void;
  /** Forgets every field, the ones on their way included. */
  invalidate(): void;
  /** Leaves `object` and what is below it out of the cubemap. */
  exclude(object: Object3D): void;
  /** Takes `object` back in. */
  include(object: Object3D): void;
}
