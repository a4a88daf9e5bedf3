import type { Object3D } from 'three';

/** Something to walk on, through or into. */
export interface Exhibit {
  /** Named after what it shows. Its origin lies on the hall's floor. */
  readonly object: Object3D;
  /** Brings it to a time; one that stands still has none. @param time seconds since the hall was made */
  update?(time: number): void;
}
