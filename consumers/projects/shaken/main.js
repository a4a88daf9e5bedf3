// An app that wants the cubemap alone: no character, no controls.
import { CubeCollider } from 'three-cube-collider';

export const collider = new CubeCollider({ far: 2 });
