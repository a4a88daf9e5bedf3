import type { CharacterControls } from 'three-cube-collider';
import { element, hasMouse } from '../page.js';

/** Captures the mouse, and says how to look around while it is not captured. */
export class MouseHint {
  readonly #controls: CharacterControls;
  readonly #canvas: HTMLElement;
  readonly #shown: boolean;
  readonly #hint = element('hint');

  /** @param shown false on a page that is to be all picture */
  constructor(controls: CharacterControls, canvas: HTMLElement, shown: boolean) {
    this.#controls = controls;
    this.#canvas = canvas;
    this.#shown = shown;
    for (const type of ['lock', 'unlock'] as const) {
      controls.addEventListener(type, () => {
        document.body.classList.toggle('captured', controls.isLocked);
        this.#show();
      });
    }
    canvas.addEventListener('pointermove', ({ buttons }) => {
      if (buttons !== 0) this.#hint.hidden = true;
    });
  }

  /**
   * One walks from now on.
   *
   * @param capture whether this is a user's gesture, in which the mouse may be captured; a browser may still refuse, as
   *   in the second after Escape: dragging looks then
   */
  begin(capture: boolean): void {
    this.#show();
    document.body.classList.remove('tabbed');
    if (!capture || !hasMouse()) return;
    this.#canvas.focus({ preventScroll: true });
    void this.#controls.lock();
  }

  #show(): void {
    this.#hint.hidden = !this.#shown || this.#controls.isLocked;
    this.#hint.textContent = hasMouse()
      ? 'Click to look with the mouse, or drag'
      : 'Left thumb walks, right thumb looks';
  }
}
