import { Vector3 } from 'three';
import { onePopup } from '../hud/onePopup.js';
import { element } from '../page.js';
import { EXAMPLES } from './examples.js';
import type { Level, Placing } from './Level.js';
import { UPS } from './orientation.js';

/** What the menu asks for. */
export interface MenuActions {
  /** Opens the file picker. */
  pick(): void;
  visit(url: string): void;
  place(placing: Partial<Placing>): void;
  /** Back to the start. */
  again(): void;
  /** From now on the start is where one stands. */
  here(): void;
}

const MARKUP = `
  <button type="button" class="level-toggle" aria-expanded="false" aria-controls="level-panel">Level</button>
  <section id="level-panel" class="level-panel" aria-label="Level" hidden>
    <ul class="level-list"></ul>
    <button type="button" class="level-open">Open a level…</button>
    <p class="level-about"><span>or drop a .glb, or a .gltf with its files, anywhere. </span>It stays on this device.</p>
    <fieldset class="level-adjust" disabled>
      <legend></legend>
      <label for="level-scale">Scale <span><button type="button" data-by="0.8" aria-label="Smaller">−</button><input id="level-scale" name="scale" type="number" min="0.000001" max="1000000" step="any" inputmode="decimal" /><button type="button" data-by="1.25" aria-label="Larger">+</button></span></label>
      <label>Up axis <select name="up"></select></label>
      <label>Floor below <input name="floor" type="checkbox" /></label>
      <div class="level-row"><button type="button" data-do="guess">Reset</button></div>
    </fieldset>
    <div class="level-row">
      <button type="button" data-do="again">Back to start</button>
      <button type="button" data-do="here">Start here</button>
    </div>
  </section>`;

/** The list of levels, and what can be changed of the one that is walked in. */
export class LevelMenu {
  readonly #toggle: HTMLButtonElement;
  readonly #panel: HTMLElement;
  readonly #adjust: HTMLFieldSetElement;
  readonly #scale: HTMLInputElement;
  readonly #up: HTMLSelectElement;
  readonly #floor: HTMLInputElement;
  readonly #actions: MenuActions;
  readonly #opened = onePopup(() => this.open(false));
  #level: Level | null = null;

  constructor(parent: HTMLElement, actions: MenuActions) {
    const root = document.createElement('div');
    root.className = 'level-menu';
    root.innerHTML = MARKUP;
    const find = <E extends HTMLElement>(selector: string) => root.querySelector<E>(selector)!;
    this.#actions = actions;
    this.#toggle = find('.level-toggle');
    this.#panel = find('.level-panel');
    this.#adjust = find('fieldset');
    this.#scale = find('[name=scale]');
    this.#up = find('[name=up]');
    this.#floor = find('[name=floor]');
    for (const up of UPS) this.#up.add(new Option(up));
    find('.level-list').append(...EXAMPLES.map((each) => this.#item(each)));
    this.#toggle.addEventListener('click', ({ detail }) => {
      this.open(this.#panel.hidden === true);
      if (this.#panel.hidden === true && detail > 0) walkOn();
    });
    for (const opener of document.querySelectorAll('[data-opens="level"]')) {
      opener.addEventListener('click', () => {
        this.open(true);
        this.#panel.querySelector('button')!.focus();
      });
    }
    find('.level-open').addEventListener('click', () => actions.pick());
    this.#scale.addEventListener('change', () => this.#setScale(Number(this.#scale.value)));
    this.#up.addEventListener('change', () => this.#place({ up: UPS[this.#up.selectedIndex]! }));
    this.#floor.addEventListener('change', () => this.#place({ floor: this.#floor.checked }));
    root.addEventListener('click', (event) => this.#clicked(event));
    root.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.open(false);
      event.stopPropagation(); // typed, not walked
    });
    parent.append(root);
  }

  open(on: boolean): void {
    this.#panel.hidden = !on;
    this.#toggle.setAttribute('aria-expanded', String(on));
    if (on) this.#opened();
  }

  /** Shows what is true of a level now. */
  show(level: Level): void {
    this.#level = level;
    this.#adjust.disabled = level.own;
    this.#adjust.hidden = level.own;
    const size = level.bounds.getSize(new Vector3()).toArray().map(metres).join(' × ');
    this.#adjust.querySelector('legend')!.textContent = `${level.name}: ${size} m`;
    this.#scale.value = String(Number(level.placing.scale.toPrecision(4)));
    this.#up.value = level.placing.up;
    this.#floor.checked = level.placing.floor;
  }

  #item({ name, about, url }: (typeof EXAMPLES)[number]): HTMLLIElement {
    const item = document.createElement('li');
    const button = document.createElement('button');
    const small = document.createElement('small');
    button.type = 'button';
    small.textContent = about;
    button.append(name, small);
    button.addEventListener('click', () => this.#actions.visit(url));
    item.append(button);
    return item;
  }

  #clicked({ target, detail }: MouseEvent): void {
    const { dataset } = target as HTMLElement;
    if (dataset.by !== undefined && this.#level !== null)
      this.#setScale(this.#level.placing.scale * Number(dataset.by));
    if (dataset.do === 'again') this.#actions.again();
    if (dataset.do === 'here') this.#actions.here();
    if (dataset.do === 'guess' && this.#level !== null) this.#place(this.#level.guessed);
    if (detail > 0 && dataset.do !== undefined) walkOn();
  }

  #setScale(scale: number): void {
    if (scale > 0 && Number.isFinite(scale)) this.#place({ scale });
    else if (this.#level !== null) this.show(this.#level);
  }

  #place(placing: Partial<Placing>): void {
    this.#actions.place(placing);
    if (this.#level !== null) this.show(this.#level);
  }
}

/** After a click, not a key's press: the keys are for walking again. */
const walkOn = () => element('picture').focus({ preventScroll: true });

/** Two digits that count. */
export const metres = (length: number) =>
  length >= 10 ? String(Math.round(length)) : String(Number(length.toPrecision(2)));
