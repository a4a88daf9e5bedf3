import { Vector3 } from 'three';
import { DrawnObjects } from './DrawnObjects.js';

/** When and where the texels of a read were drawn, and what. */
export class DrawStamp {
  readonly center = new Vector3();
  /** Reach, metres. */
  far = 0;
  /** `performance.now()` milliseconds. */
  time = 0;
  /** Number of the draw. */
  serial = 0;
  /** Number of the update that drew. */
  update = 0;
  /** The draw's own table. */
  objects = new DrawnObjects();

  /** Takes everything over from `stamp`, and its table, for which it leaves an empty one. */
  take(stamp: DrawStamp): void {
    this.center.copy(stamp.center);
    this.far = stamp.far;
    this.time = stamp.time;
    this.serial = stamp.serial;
    this.update = stamp.update;
    const { objects } = this;
    this.objects = stamp.objects;
    stamp.objects = objects;
  }
}
