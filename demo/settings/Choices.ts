import type { CharacterControls } from 'three-cube-collider';
import type { Change, Settings } from '../hud/panel.js';
import { announce, onReducedMotion } from '../page.js';
import type { Parameters } from '../parameters.js';
import { createPreferences, type KeptPreferences } from './createPreferences.js';
import { followPreferences } from './followPreferences.js';
import { onKeys } from './onKeys.js';
import type { Preferences } from './preferences.js';
import { showKeys } from './showKeys.js';

/** What choices need of the page. */
export interface Choosable {
  readonly settings: Settings;
  readonly controls: CharacterControls;
  readonly canvas: HTMLElement;
  readonly parameters: Parameters;
  /** Called after `settings` have changed. */
  apply(what: Change): void;
  /** Called after a preference has changed that is not the controls' own. */
  prefer(preferences: Preferences): void;
  /** By its key: opens or closes the collider's panel. */
  togglePanel(): void;
}

/** What a visitor chooses, wherever they do: by a key, a button, a gamepad, in the panel or in the dialog of settings. */
export class Choices {
  readonly #page: Choosable;
  readonly #kept: KeptPreferences;
  /** Whether the system asks for less motion. */
  #stillSystem = false;
  /** Whether nobody has walked yet: then the camera is where it belongs at once. */
  #waiting: boolean;
  /** The view that was preferred when the preferences were followed last. */
  #followed: Settings['view'] | null = null;

  constructor(page: Choosable) {
    const { settings, controls, parameters } = page;
    this.#page = page;
    this.#waiting = parameters.ui;
    this.#kept = createPreferences(controls, parameters.ui, () => this.#follow());
    this.preferences.view = parameters.view ?? this.preferences.view;
    onKeys(this.preferences, () => controls.enabled, {
      switchView: () => this.#look(settings.view === 'first' ? 'third' : 'first'),
      colliderView: () => this.#switchColliderView(),
      panel: () => page.togglePanel(),
    });
    // By a gamepad; the panel and the key go the other way round.
    controls.addEventListener('change', ({ view }) => {
      if (view !== settings.view) this.#look(view);
    });
  }

  get preferences(): Preferences {
    return this.#kept.preferences;
  }

  /** Follows the preferences, from now on. */
  begin(): void {
    onReducedMotion((reduced) => {
      this.#stillSystem = reduced;
      this.#follow();
    });
  }

  /** One walks from now on. */
  walk(): void {
    this.#waiting = false;
    this.#smooth();
  }

  /** A choice in the panel or by a key, which lasts. */
  chosen(what: Change): void {
    const { settings, canvas } = this.#page;
    if (what === 'view') {
      this.preferences.view = this.#followed = settings.view;
      this.#kept.save();
      announce(settings.view === 'first' ? 'First person' : 'Third person');
    }
    this.#page.apply(what);
    // A choice in the panel leaves the keys to the walk again.
    if (document.activeElement instanceof HTMLSelectElement) canvas.focus({ preventScroll: true });
  }

  #look(view: Settings['view']): void {
    this.#page.settings.view = view;
    this.chosen('view');
  }

  #switchColliderView(): void {
    const { settings } = this.#page;
    settings.helper = !settings.helper;
    announce(settings.helper ? 'Showing what the collider sees' : 'Hiding what the collider sees');
    this.chosen('helper');
  }

  #follow(): void {
    const { settings, controls } = this.#page;
    const { view, keys } = this.preferences;
    followPreferences(controls, this.preferences);
    this.#smooth();
    // What is shown at the feet may hold another view: that one ends by another choice of the view alone.
    if (view !== this.#followed) settings.view = this.#followed = view;
    this.#page.apply('view');
    this.#page.prefer(this.preferences);
    showKeys(keys);
  }

  #smooth(): void {
    const { motion } = this.preferences;
    const still = motion === 'system' ? this.#stillSystem : motion === 'reduced';
    this.#page.controls.smoothing = still || this.#waiting ? Infinity : 1;
    document.documentElement.classList.toggle('still', still);
  }
}
