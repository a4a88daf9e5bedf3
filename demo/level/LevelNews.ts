/** Seconds that a note stays which asks for nothing. */
const NOTE = 9;

/** What the page says about a level that comes: where to drop it, how far it is, what is wrong with it. */
export class LevelNews {
  readonly #target = make('div', 'level-target');
  readonly #card = make('div', 'level-news');
  readonly #text = make('p', 'level-text');
  readonly #bar = document.createElement('progress');
  readonly #close = document.createElement('button');
  #timer = 0;

  constructor(parent: HTMLElement) {
    const about = make('p', '');
    about.textContent = 'Drop a .glb, or a .gltf with its files, to walk in it';
    this.#target.append(about);
    this.#bar.max = 1;
    this.#bar.setAttribute('aria-label', 'Loading');
    this.#close.type = 'button';
    this.#close.setAttribute('aria-label', 'Close');
    this.#close.textContent = '×';
    this.#close.addEventListener('click', () => this.clear());
    this.#card.append(this.#text, this.#bar, this.#close);
    parent.append(this.#target, this.#card);
    this.dragging(false);
    this.clear();
  }

  /** Whether files are being dragged over the page. */
  dragging(on: boolean): void {
    this.#target.hidden = !on;
  }

  /** @param part from 0 to 1, or NaN while nobody knows */
  progress(text: string, part: number): void {
    this.#show('busy', text);
    if (Number.isNaN(part)) this.#bar.removeAttribute('value');
    else this.#bar.value = part;
  }

  /** What went wrong; it stays until it is closed, or something else comes. */
  fail(text: string): void {
    this.#show('failed', text);
  }

  /** Something worth knowing; it goes by itself. */
  note(text: string): void {
    this.#show('note', text);
    this.#timer = window.setTimeout(() => this.clear(), 1000 * NOTE);
  }

  clear(): void {
    window.clearTimeout(this.#timer);
    this.#card.hidden = true;
  }

  #show(kind: 'busy' | 'failed' | 'note', text: string): void {
    window.clearTimeout(this.#timer);
    this.#card.dataset.kind = kind;
    this.#card.setAttribute('role', kind === 'failed' ? 'alert' : 'status');
    if (this.#text.textContent !== text) this.#text.textContent = text;
    this.#bar.hidden = kind !== 'busy';
    this.#close.hidden = kind === 'busy';
    this.#card.hidden = false;
  }
}

function make(tag: string, name: string): HTMLElement {
  const element = document.createElement(tag);
  element.className = name;
  return element;
}
