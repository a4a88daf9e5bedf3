import {
  DirectionalLight,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  type Texture,
  type WebGLRenderer,
} from 'three';

export type QualityMode = 'auto' | 'high' | 'low';

/** What is drawn, best first: the part of the full pixel ratio, and whether the sun throws shadows. */
const STEPS = [
  { ratio: 1, shadows: true },
  { ratio: 0.8, shadows: true },
  { ratio: 0.65, shadows: true },
  { ratio: 0.65, shadows: false },
] as const;
const WORST = STEPS.length - 1;
/** Frames looked at before a decision, and their mean times beyond which one is made, seconds. */
const FRAMES = 12;
const SLOW = 1 / 28;
const FAST = 1 / 55;
/** Fast decisions in a row before it dares a better picture. */
const PATIENCE = 30;

/** Trades sharpness and shadows for frames on GPUs that are too slow for the full picture. */
export class Quality {
  readonly #renderer: WebGLRenderer;
  readonly #scene: Object3D;
  readonly #pixelRatio: number;
  #step = 0;
  #seconds = 0;
  #frames = 0;
  #fast = 0;
  #mode: QualityMode = 'auto';
  /** What samples the softened textures had along the slant. */
  readonly #sharp = new WeakMap<Texture, number>();
  /** Suns that threw shadows. */
  readonly #suns = new Set<DirectionalLight>();

  constructor(renderer: WebGLRenderer, scene: Object3D) {
    this.#renderer = renderer;
    this.#scene = scene;
    this.#pixelRatio = renderer.getPixelRatio();
  }

  /** Sharp or fast, whatever comes of it, or whichever the GPU can do. */
  set mode(mode: QualityMode) {
    if (mode === this.#mode) return;
    this.#mode = mode;
    this.#take(mode === 'low' ? WORST : 0);
    if (mode === 'high') this.#sharpenTextures();
  }

  /** Draws what has come into the scene as it does the rest. */
  refresh(): void {
    const { shadows } = STEPS[this.#step]!;
    if (this.#step > 0) this.#softenTextures();
    this.#scene.traverse((object) => {
      if (object instanceof DirectionalLight && object.castShadow) this.#suns.add(object);
    });
    for (const sun of this.#suns) sun.castShadow = shadows;
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
    const next = STEPS[step];
    if (step === this.#step || next === undefined) return;
    this.#step = step;
    this.#fast = 0;
    this.refresh();
    this.#renderer.setPixelRatio(this.#pixelRatio * next.ratio);
  }

  /** Sharp floors seen at a low angle take half of a slow GPU's time. */
  #softenTextures(): void {
    for (const map of this.#maps()) {
      if (map.anisotropy === 1) continue;
      this.#sharp.set(map, map.anisotropy);
      map.anisotropy = 1;
      map.needsUpdate = true;
    }
  }

  #sharpenTextures(): void {
    for (const map of this.#maps()) {
      const anisotropy = this.#sharp.get(map);
      if (anisotropy === undefined) continue;
      this.#sharp.delete(map);
      map.anisotropy = anisotropy;
      map.needsUpdate = true;
    }
  }

  #maps(): Set<Texture> {
    const maps = new Set<Texture>();
    this.#scene.traverse((object) => {
      if (!(object instanceof Mesh) || !(object.material instanceof MeshStandardMaterial)) return;
      if (object.material.map !== null) maps.add(object.material.map);
    });
    return maps;
  }
}
