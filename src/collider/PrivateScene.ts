import { Scene } from 'three';

/** Neither a colour nor a texture nor nothing: three then draws no background and leaves the clear colour alone. */
const NO_BACKGROUND = {} as never;

/**
 * A scene of the collider's own: no lights, shadows, fog, background or environment, matrices left as they are.
 * Rendering it changes neither the user's scene nor the context's clear colour, which cannot be asked for without
 * waiting for the GPU (docs/architecture.md, "The user's frame").
 */
export class PrivateScene extends Scene {
  constructor() {
    super();
    this.matrixAutoUpdate = false;
    this.matrixWorldAutoUpdate = false;
    this.background = NO_BACKGROUND;
    this.layers.enableAll();
  }
}
