import { Mesh, MeshStandardMaterial, type Object3D, type Texture, type WebGLRenderer } from 'three';

/** Parts of the full pixel ratio, best first. */
const RATIOS = [1, 0.8, 0.65];
/** Frames looked at before a decision, and their mean times beyond which one is made, seconds. */
const FRAMES = 12;
const SLOW = 1 / 28;
const FAST = 1 / 55;
/** Fast decisions in a row before it dares a better picture. */
const PATIENCE = 30;

/** Trades sharpness for frames on GPUs that are too slow for the full picture. */
export class Quality {
  readonly #renderer: WebGLRenderer;
  readonly #scene: Object3D;
  readonly #pixelRatio: number;
  #step = 0;
  #seconds = 0;
  #frames = 0;
  #fast = 0;
  #mode: 'auto' | 'high' | 'low' = 'auto';
  /** What samples the softened textures had along the slant. */
  readonly #sharp = new Map<Texture, number>();

  constructor(renderer: WebGLRenderer, scene: Object3D) {
    this.#renderer = renderer;
    this.#scene = scene;
    this.#pixelRatio = renderer.getPixelRatio();
  }

  /** Sharp or fast, whatever comes of it, or whichever the GPU can do. */
  set mode(mode: 'auto' | 'high' | 'low') {
    if (mode === this.#mode) return;
    this.#mode = mode;
    this.#take(mode === 'low' ? RATIOS.length - 1 : 0);
    if (mode === 'high') this.#sharpenTextures();
  }

  /** Once a frame, with the seconds since the last. */
  update(delta: number): void {
    if (this.#mode !== 'auto') return;
    this.#seconds += delta;
    if (++this.#frames < FRAMES) return;
    const mean = this.#seconds / this.#frames;
    this.#seconds = this.#frames = 0;
    this.#fast = mean < FAST ? this.#fast + 1 : 0;
    if (mean > SLOW) this.#take(this.#step + 1);
    else if (this.#fast >= PATIENCE) this.#take(this.#step - 1);
  }

  #take(step: number): void {
    if (step === this.#step || RATIOS[step] === undefined) return;
    if (step > 0) this.#softenTextures();
    this.#step = step;
    this.#fast = 0;
    this.#renderer.setPixelRatio(this.#pixelRatio * RATIOS[step]);
  }

  /** Sharp floors seen at a low angle take half of a slow GPU's time. */
  #softenTextures(): void {
    this.#scene.traverse((object) => {
      if (!(object instanceof Mesh) || !(object.material instanceof MeshStandardMaterial)) return;
      const { map } = object.material;
      if (map === null || map.anisotropy === 1) return;
      this.#sharp.set(map, map.anisotropy);
      map.anisotropy = 1;
      map.needsUpdate = true;
    });
  }

  #sharpenTextures(): void {
    for (const [map, anisotropy] of this.#sharp) {
      map.anisotropy = anisotropy;
      map.needsUpdate = true;
    }
    this.#sharp.clear();
  }
}
