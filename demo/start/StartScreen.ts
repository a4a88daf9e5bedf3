import { announce, element } from '../page.js';
import { DEFAULT_LEVEL } from '../parameters.js';

/** What lies over the picture until one walks: progress, then the button, or what went wrong. */
export class StartScreen {
  readonly #screen = element('start');
  readonly #status = element('status');
  readonly #progress = element<HTMLProgressElement>('progress');
  readonly #walk = element<HTMLButtonElement>('walk');

  /** @param onWalk called by the button, in the user's gesture: the pointer may be captured in it */
  constructor(onWalk: () => void) {
    this.#walk.addEventListener('click', () => {
      this.hide();
      onWalk();
    });
    element('retry').addEventListener('click', () => location.reload());
  }

  /** @param part from 0 to 1, or NaN while nobody knows */
  loading(part: number): void {
    if (Number.isNaN(part)) this.#progress.removeAttribute('value');
    else this.#progress.value = part;
    // Told to a screen reader at each quarter, not at each packet.
    const text = part >= 0.25 ? `Loading the level… ${25 * Math.floor(4 * part)} %` : null;
    if (text !== null && text !== this.#status.textContent) this.#status.textContent = text;
  }

  /** The level is here, its programs are being compiled. */
  preparing(): void {
    this.#progress.removeAttribute('value');
    this.#status.textContent = 'Preparing the picture…';
  }

  ready(): void {
    this.#progress.hidden = this.#status.hidden = true;
    element('ready').hidden = false;
    this.#screen.dataset.state = 'ready';
    announce('Ready to walk');
    // Enter starts; but a focus already somewhere is not taken away.
    if (document.activeElement === document.body) this.#walk.focus({ preventScroll: true });
  }

  /** @param level the address of what could not be loaded */
  failLevel(error: unknown, level: string): void {
    this.fail(
      error,
      level === DEFAULT_LEVEL
        ? 'Make it with “npm run build:level”, then try again.'
        : 'Is the address after “?level=” right, and is it a GLB or glTF file?',
    );
  }

  /** @param mend what the reader can do about it */
  fail(error: unknown, mend: string): void {
    console.error(error);
    this.#screen.hidden = false;
    this.#screen.dataset.state = 'failed';
    this.#progress.hidden = element('ready').hidden = this.#status.hidden = true;
    element('failure').textContent = error instanceof Error ? error.message : String(error);
    element('mend').textContent = mend;
    element('failed').hidden = false;
  }

  hide(): void {
    this.#screen.hidden = true;
  }
}
