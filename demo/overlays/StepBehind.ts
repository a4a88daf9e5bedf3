import { notify } from '../page.js';
import type { OverlayName } from './kinds.js';

/** What is shown around the feet, where the eyes do not look. */
const AT_FEET: readonly OverlayName[] = ['surfels', 'contacts', 'body'];

/** The view, which the settings know. */
export interface ViewChoice {
  get(): 'first' | 'third';
  set(view: 'first' | 'third'): void;
}

/** Looks from behind as long as something is shown that one does not see in first person. */
export class StepBehind {
  readonly #view: ViewChoice;
  #stepped = false;

  constructor(view: ViewChoice) {
    this.#view = view;
  }

  /**
   * After the user has shown or hidden one. A view that they choose themselves meanwhile stays.
   *
   * @param has whether one is shown
   */
  changed(name: OverlayName, has: (name: OverlayName) => boolean): void {
    if (!AT_FEET.includes(name)) return;
    const view = this.#view.get();
    if (view === 'first') this.#stepped = false;
    if (has(name) && view === 'first') {
      this.#stepped = true;
      this.#view.set('third');
      notify('Third person, as long as this is shown');
    } else if (this.#stepped && !AT_FEET.some(has)) {
      this.#stepped = false;
      this.#view.set('first');
      notify('First person again');
    }
  }
}
