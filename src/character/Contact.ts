import { type Object3D, Vector3 } from 'three';

/** Where the body touches something. */
export class Contact {
  /** On the surface, world space, metres. */
  readonly point = new Vector3();
  /** Unit vector from the surface to the body, world axes. */
  readonly normal = new Vector3();
  /** Between surface and body, metres: about `skin`, negative where they overlap. */
  gap = 0;
  /** What is touched; null if the field does not know. */
  object: Object3D | null = null;
  /** Which instance of it, if it has several (as three counts those of an `InstancedMesh` or a `BatchedMesh`); else 0. */
  instance = 0;
}
