import { onePopup } from '../hud/onePopup.js';
import { element, isSmall } from '../page.js';
import { OVERLAYS, type OverlayKind, type OverlayName } from './kinds.js';

/** The list of what can be shown: a button each, which says so once it is on. */
export class OverlayList {
  readonly element = document.createElement('section');
  readonly #buttons = new Map<OverlayName, HTMLButtonElement>();
  readonly #notes = new Map<OverlayName, HTMLElement>();

  /** @param toggle called with what was pressed */
  constructor(toggle: (name: OverlayName) => void) {
    this.element.className = 'overlay-list';
    this.element.setAttribute('aria-label', 'What the collider sees');
    const list = document.createElement('ul');
    list.id = 'overlay-list';
    list.hidden = isSmall();
    const resting = document.createElement('p');
    resting.className = 'resting';
    resting.textContent = 'Another library walks; these rest until the cube collider does again.';
    this.element.append(opener(list), resting, list);
    for (const kind of OVERLAYS) {
      const note = explanation(kind);
      const button = document.createElement('button');
      button.type = 'button';
      button.title = kind.more;
      button.setAttribute('aria-keyshortcuts', kind.key);
      const key = document.createElement('kbd');
      key.textContent = kind.key;
      key.setAttribute('aria-hidden', 'true');
      button.append(key, kind.label);
      button.addEventListener('click', ({ detail }) => {
        toggle(kind.name);
        // Clicked, not pressed by a key: the keys are for walking again.
        if (detail > 0) element('picture').focus({ preventScroll: true });
      });
      const item = document.createElement('li');
      item.append(button, note);
      list.append(item);
      this.#buttons.set(kind.name, button);
      this.#notes.set(kind.name, note);
    }
  }

  show(name: OverlayName, on: boolean): void {
    this.#buttons.get(name)!.setAttribute('aria-pressed', String(on));
    this.#notes.get(name)!.hidden = !on;
  }
}

/** Folds the list away, and out again; where there is no room for two panels, it is one of them. */
function opener(list: HTMLElement): HTMLButtonElement {
  const button = document.createElement('button');
  button.type = 'button';
  button.className = 'opener';
  button.textContent = 'What the collider sees';
  button.setAttribute('aria-controls', list.id);
  const open = (on: boolean) => {
    list.hidden = !on;
    button.setAttribute('aria-expanded', String(on));
    if (on && isSmall()) opened();
  };
  const opened = onePopup(() => isSmall() && open(false));
  button.setAttribute('aria-expanded', String(!list.hidden));
  button.addEventListener('click', () => open(list.hidden === true));
  return button;
}

function explanation({ line, legend = [] }: OverlayKind): HTMLElement {
  const note = document.createElement('p');
  note.textContent = line;
  if (legend.length > 0) note.append(document.createElement('br'));
  for (const [color, meaning] of legend) {
    const swatch = document.createElement('span');
    swatch.className = 'swatch';
    swatch.style.setProperty('--swatch', `#${color.toString(16).padStart(6, '0')}`);
    swatch.textContent = meaning;
    note.append(swatch);
  }
  return note;
}
