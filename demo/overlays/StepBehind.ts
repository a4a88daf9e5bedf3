import type { Settings } from '../hud/panel.js';
import { notify } from '../page.js';
import type { OverlayName } from './kinds.js';

/** What is shown around the feet, where the eyes do not look. */
const AT_FEET: readonly OverlayName[] = ['surfels', 'contacts', 'body'];

/** Looks from behind as long as something is shown that one does not see in first person. */
export class StepBehind {
  readonly #settings: Pick<Settings, 'view'>;
  readonly #apply: (what: 'view') => void;
  readonly #preferred: () => Settings['view'];
  #stepped = false;

  /**
   * @param apply called after the settings' view was changed
   * @param preferred what the user has chosen last, to which it goes back
   */
  constructor(
    settings: Pick<Settings, 'view'>,
    apply: (what: 'view') => void,
    preferred: () => Settings['view'],
  ) {
    this.#settings = settings;
    this.#apply = apply;
    this.#preferred = preferred;
  }

  /**
   * After the user has shown or hidden one. A view that they choose themselves meanwhile stays.
   *
   * @param has whether one is shown
   */
  changed(name: OverlayName, has: (name: OverlayName) => boolean): void {
    if (!AT_FEET.includes(name)) return;
    const { view } = this.#settings;
    if (view === 'first') this.#stepped = false;
    if (has(name) && view === 'first') {
      this.#stepped = true;
      this.#look('third');
      notify('Third person, as long as this is shown');
    } else if (this.#stepped && !AT_FEET.some(has)) {
      this.#stepped = false;
      if (this.#preferred() === 'third') return;
      this.#look('first');
      notify('First person again');
    }
  }

  #look(view: Settings['view']): void {
    this.#settings.view = view;
    this.#apply('view');
  }
}
