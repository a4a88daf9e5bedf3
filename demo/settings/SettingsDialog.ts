import { element } from '../page.js';
import { KeyRows } from './KeyRows.js';
import type { Preferences } from './preferences.js';

const UNITS: Partial<Record<keyof Preferences, (value: number) => string>> = {
  lookSpeed: (value) => `${value.toFixed(1)} ×`,
  fieldOfView: (value) => `${value}°`,
};

/** The dialog of index.html: native controls, each named as its field of the preferences. */
export class SettingsDialog {
  readonly #dialog = element<HTMLDialogElement>('settings');
  readonly #preferences: Preferences;
  readonly #keyRows: KeyRows;

  /**
   * @param defaults what Reset brings back
   * @param changed called after a preference changed
   */
  constructor(preferences: Preferences, defaults: Preferences, changed: () => void) {
    this.#preferences = preferences;
    this.#keyRows = new KeyRows(changed);
    for (const input of this.#inputs()) {
      input.addEventListener('input', () => {
        this.#read(input);
        changed();
      });
    }
    element('reset').addEventListener('click', () => {
      Object.assign(preferences, structuredClone(defaults));
      this.#show();
      changed();
    });
    for (const opener of document.querySelectorAll('[data-opens="settings"]')) {
      opener.addEventListener('click', () => this.open());
    }
  }

  open(): void {
    this.#show();
    this.#dialog.showModal();
  }

  /** Takes a choice off the dialog that nothing here can follow. */
  leaveOut(name: keyof Preferences): void {
    this.#inputs()
      .find((input) => input.name === name)!
      .closest('label')!.hidden = true;
  }

  #inputs(): (HTMLInputElement | HTMLSelectElement)[] {
    return [...this.#dialog.querySelectorAll<HTMLInputElement>('[name]')];
  }

  #show(): void {
    const values = this.#preferences as unknown as Record<string, string>;
    for (const input of this.#inputs()) {
      if (isCheckbox(input)) input.checked = Boolean(values[input.name]);
      else input.value = values[input.name]!;
      this.#label(input);
    }
    this.#keyRows.show(this.#preferences.keys);
  }

  #read(input: HTMLInputElement | HTMLSelectElement): void {
    const { type, value } = input;
    const read = isCheckbox(input) ? input.checked : type === 'range' ? Number(value) : value;
    Object.assign(this.#preferences, { [input.name]: read });
    this.#label(input);
  }

  #label(input: HTMLInputElement | HTMLSelectElement): void {
    const unit = UNITS[input.name as keyof Preferences];
    const output = input.parentElement!.querySelector('output');
    if (unit && output) output.value = unit(Number(input.value));
  }
}

function isCheckbox(input: Element): input is HTMLInputElement {
  return input instanceof HTMLInputElement && input.type === 'checkbox';
}
