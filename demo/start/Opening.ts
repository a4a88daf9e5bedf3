import type { PerspectiveCamera } from 'three';
import type { CharacterControls, View } from 'three-cube-collider';

/** The boom behind the start screen, metres: on a wide page, and on a phone, whose text takes from below. */
const DISTANCE = { wide: 5.2, high: 6.4 };
/** Part of what the text takes from below by which the picture is moved up: the figure's feet stay above it. */
const BELOW = 0.46;
/** How fast the picture's middle comes back once one walks, 1/s. */
const RATE = 5;

/**
 * The picture behind the start screen: the character from behind, moved aside for the text. Once one walks the camera
 * glides to where the user wants it.
 */
export class Opening {
  /** Whether the start screen is there. */
  active = true;
  readonly #camera: PerspectiveCamera;
  readonly #controls: CharacterControls;
  readonly #text: HTMLElement;
  readonly #distance: number;
  /** Part of the full way aside. */
  #aside = 1;
  /** The room that the text took while it was there, pixels. */
  #last: [x: number, y: number] = [0, 0];

  /** @param text what the picture makes room for */
  constructor(camera: PerspectiveCamera, controls: CharacterControls, text: HTMLElement) {
    this.#camera = camera;
    this.#controls = controls;
    this.#text = text;
    this.#distance = controls.distance;
    controls.view = 'third';
    controls.distance = window.innerWidth > window.innerHeight ? DISTANCE.wide : DISTANCE.high;
  }

  /** Once a frame. */
  update(delta: number): void {
    if (this.#aside === 0) return;
    if (!this.active) this.#aside *= Math.exp(-RATE * this.#controls.smoothing * delta);
    if (this.#aside < 0.002 || this.#controls.smoothing === Infinity) {
      this.#aside = Number(this.active);
    }
    if (this.#aside === 0) {
      this.#camera.clearViewOffset();
      return;
    }
    const { innerWidth: width, innerHeight: height } = window;
    const [x, y] = this.#room(width, height);
    this.#camera.setViewOffset(width, height, this.#aside * x, this.#aside * y, width, height);
  }

  /** One walks, in that view. */
  end(view: View): void {
    this.active = false;
    this.#controls.distance = this.#distance;
    this.#controls.view = view;
  }

  /** Half of what the text takes of the picture, pixels: from the left, or from below on a phone. */
  #room(width: number, height: number): [x: number, y: number] {
    if (this.#text.offsetWidth === 0) return this.#last;
    const { right, top } = this.#text.getBoundingClientRect();
    this.#last = right < 0.7 * width ? [-right / 2, 0] : [0, BELOW * (height - top)];
    return this.#last;
  }
}
