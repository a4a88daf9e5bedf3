/** So long without a cubemap the strip shows nothing, milliseconds: what it shows, and a bit. */
const EMPTY = 5200;

/** The canvas of the strip of read-backs, which says why it is empty while nobody moves. */
export class RestingStrip {
  readonly element = document.createElement('div');
  readonly canvas = document.createElement('canvas');
  readonly #note = document.createElement('p');
  #draws = -1;
  #since = 0;

  constructor() {
    this.element.className = 'timeline';
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', 'Read-backs of the last seconds');
    this.#note.textContent = 'Standing, it needs no cubemap: walk to see';
    this.element.append(this.canvas, this.#note);
  }

  /** @param draws cubemaps drawn so far */
  update(draws: number): void {
    const now = performance.now();
    if (draws !== this.#draws) this.#since = now;
    this.#draws = draws;
    const empty = now - this.#since > EMPTY;
    if (this.#note.hidden === empty) this.#note.hidden = !empty;
  }
}
