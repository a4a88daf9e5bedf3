import { element } from '../page.js';
import { assignKey, isBindable, keyName, titleOf, type Keys } from './keys.js';

/** The settings' list of actions, each with a button for every key: pressed, it waits for another key. */
export class KeyRows {
  readonly #rows = element('key-rows');
  readonly #told = element('key-told');
  readonly #changed: () => void;
  #keys: Keys = {};
  /** The button that waits, and what for. */
  #waiting: { button: HTMLButtonElement; action: string; place: number } | null = null;

  /** @param changed called after a key was given to another action */
  constructor(changed: () => void) {
    this.#changed = changed;
    // Before the dialog, which closes on Escape, and before the buttons, which Space and Enter press.
    this.#rows.addEventListener('keydown', (event) => this.#take(event), { capture: true });
    this.#rows.addEventListener('focusout', () => this.#rest());
  }

  show(keys: Keys): void {
    this.#keys = keys;
    this.#waiting = null;
    this.#told.textContent = '';
    this.#rows.replaceChildren(...Object.keys(keys).map((action) => this.#row(action)));
  }

  #row(action: string): HTMLElement {
    const row = document.createElement('div');
    row.role = 'group';
    row.ariaLabel = titleOf(action);
    const title = document.createElement('span');
    title.textContent = titleOf(action);
    const codes = this.#keys[action]!;
    const places = codes.length > 0 ? codes : [undefined];
    row.append(title, ...places.map((code, place) => this.#button(action, place, code)));
    return row;
  }

  #button(action: string, place: number, code: string | undefined): HTMLButtonElement {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'key';
    button.dataset.key = `${action} ${place}`;
    button.textContent = code === undefined ? 'none' : keyName(code);
    button.ariaLabel = `${titleOf(action)}: ${button.textContent}, change`;
    button.addEventListener('click', () => {
      this.#rest();
      this.#waiting = { button, action, place };
      button.textContent = 'a key…';
      button.classList.add('waits');
      this.#told.textContent = `Press a key for “${titleOf(action)}”, or Esc to leave it.`;
    });
    return button;
  }

  #take(event: KeyboardEvent): void {
    const waiting = this.#waiting;
    if (waiting === null || event.code === 'Tab') return;
    event.preventDefault();
    event.stopPropagation();
    if (event.code === 'Escape') {
      this.#rest();
      return;
    }
    if (!isBindable(event.code)) {
      this.#told.textContent = 'The browser keeps that key for itself; press another.';
      return;
    }
    const { action, place } = waiting;
    const loser = assignKey(this.#keys, action, place, event.code);
    this.#changed();
    this.show(this.#keys);
    const name = keyName(event.code);
    this.#told.textContent =
      loser === null
        ? `${titleOf(action)} is on ${name} now.`
        : `${titleOf(action)} is on ${name} now, taken from “${titleOf(loser)}”.`;
    this.#rows.querySelector<HTMLElement>(`[data-key="${action} ${place}"]`)?.focus();
  }

  /** Waits no more. */
  #rest(): void {
    if (this.#waiting === null) return;
    const { button, action, place } = this.#waiting;
    this.#waiting = null;
    const code = this.#keys[action]![place];
    button.textContent = code === undefined ? 'none' : keyName(code);
    button.classList.remove('waits');
    this.#told.textContent = '';
  }
}
