import type { CharacterControls } from 'three-cube-collider';
import { announce, element, hasMouse } from '../page.js';

/** An Escape so soon after a pause began is the one that began it, milliseconds. */
const SAME_KEY = 300;

/** What a pause stops, and sets going again. */
export interface Pausable {
  readonly controls: CharacterControls;
  /** No frame from now on. */
  rest(): void;
  /** @param capture whether this is a user's gesture, in which the pointer may be captured */
  goOn(capture: boolean): void;
  /** Puts the character back to where it began. */
  restart(): void;
}

/**
 * Rests whenever nobody can be walking: the window or tab is left, the captured mouse let go, Escape or the button
 * pressed. A click goes on just there.
 */
export class Pause {
  readonly #dialog = element<HTMLDialogElement>('paused');
  readonly #pausable: Pausable;
  /** The pointer is let go by us, not by someone who wants to stop. */
  #expected = false;
  #paused = false;
  /** When the pause began, milliseconds of the page. */
  #since = 0;

  constructor(pausable: Pausable) {
    this.#pausable = pausable;
    const pause = () => this.pause();
    window.addEventListener('blur', pause);
    document.addEventListener('visibilitychange', () => document.hidden && pause());
    pausable.controls.addEventListener('unlock', () => {
      if (!this.#expected) pause();
      this.#expected = false;
    });
    // Before the panel, which keeps the keys of its inputs to itself.
    document.addEventListener('keydown', (event) => this.#onKey(event), { capture: true });
    element('pause').addEventListener('click', pause);

    const dialog = this.#dialog;
    dialog.addEventListener('click', ({ target }) => {
      // Anywhere but on another button.
      if (target instanceof Element && target.closest('button') === null) this.resume();
    });
    // It opens beside the picture, and wants a mouse to point with.
    for (const opener of dialog.querySelectorAll('[data-opens="level"]')) {
      opener.addEventListener('click', () => this.resume(false));
    }
    element('resume').addEventListener('click', () => this.resume());
    element('restart').addEventListener('click', () => {
      pausable.restart();
      this.resume();
    });
    // By Escape. The event comes late: of a dialog that another pause has opened since, it tells nothing.
    dialog.addEventListener('close', () => {
      if (!dialog.open) this.resume();
    });
  }

  /** The Escape that pauses, or that let go of the mouse, must not close the dialog, too. */
  #onKey(event: KeyboardEvent): void {
    if (event.code !== 'Escape') return;
    const walking = this.#pausable.controls.enabled;
    if (walking || (this.#paused && event.timeStamp - this.#since < SAME_KEY))
      event.preventDefault();
    if (walking) this.pause();
  }

  get paused(): boolean {
    return this.#paused;
  }

  /** Does nothing before the walk has begun. */
  pause(): void {
    const { controls } = this.#pausable;
    if (!controls.enabled) return;
    controls.enabled = false;
    // Keys that are down now nobody will see come up.
    controls.update(0);
    this.freeMouse();
    this.#paused = true;
    this.#since = performance.now();
    this.#pausable.rest();
    element('how-to-go-on').textContent = hasMouse() ? 'Click to go on' : 'Tap to go on';
    this.#dialog.showModal();
    announce('Paused');
  }

  /** @param capture whether this is a user's gesture, in which the pointer may be captured */
  resume(capture = true): void {
    if (!this.#paused) return;
    this.#paused = false;
    this.#dialog.close();
    this.#pausable.controls.enabled = true;
    this.#pausable.goOn(capture);
    announce('Walking');
  }

  /** Lets the mouse go without a pause. */
  freeMouse(): void {
    const { controls } = this.#pausable;
    this.#expected = controls.isLocked;
    controls.unlock();
  }
}
