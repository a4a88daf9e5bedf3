import { type Action, ActionSet, type ButtonAction } from './actions.js';
import { Fingers, type FingersListener, type FingersSettings } from './Fingers.js';
import { Gamepads, type GamepadsSettings } from './Gamepads.js';
import { Keyboard, type KeyboardSettings } from './Keyboard.js';

/** What `Inputs` is told; `CharacterControls` has these fields. */
export interface InputsSettings extends KeyboardSettings, GamepadsSettings, FingersSettings {
  /** Whether a press of run switches it on or off. */
  toggleRun: boolean;
}

/**
 * Keyboard, gamepads, the stick under the thumb and buttons on the screen, added up.
 */
export class Inputs {
  readonly keyboard: Keyboard;
  readonly gamepads: Gamepads;
  readonly fingers: Fingers;
  /** Pressed by the page itself. */
  readonly screen = new ActionSet();
  /** Wanted walk: right and back, together 0 to 1 long. */
  x = 0;
  z = 0;
  run = false;

  readonly #settings: InputsSettings;
  #running = false;

  constructor(settings: InputsSettings, listener: FingersListener) {
    this.#settings = settings;
    this.keyboard = new Keyboard(settings);
    this.gamepads = new Gamepads(settings);
    this.fingers = new Fingers(settings, listener);
  }

  /** Reads all of them: once a frame. */
  read(): void {
    const { fingers, gamepads } = this;
    const { stick } = fingers;
    gamepads.read();
    this.x = this.#along('right', 'left') + gamepads.walkX;
    this.z = this.#along('back', 'forward') + gamepads.walkY;
    const { tilt } = stick;
    if (tilt > 0) {
      const out = Math.sqrt(stick.x * stick.x + stick.y * stick.y);
      this.x += (tilt * stick.x) / out;
      this.z += (tilt * stick.y) / out;
    }
    const length = Math.sqrt(this.x * this.x + this.z * this.z);
    if (length > 1) {
      this.x /= length;
      this.z /= length;
    }
    if (this.taken('run')) this.#running = !this.#running;
    const { toggleRun } = this.#settings;
    if (!toggleRun) this.#running = false;
    this.run = stick.runs || (toggleRun ? this.#running : this.held('run'));
  }

  /** -1 to 1: how the keys turn, left positive. */
  get turn(): number {
    return this.#along('turnLeft', 'turnRight');
  }

  held(action: ButtonAction): boolean {
    return (
      this.keyboard.held(action) || this.gamepads.actions.held(action) || this.screen.held(action)
    );
  }

  /** Whether it was pressed anywhere since this was last asked. */
  taken(action: ButtonAction): boolean {
    // Asked of each: a press must not be left for later.
    const key = this.keyboard.taken(action);
    const button = this.gamepads.actions.taken(action);
    return this.screen.taken(action) || key || button;
  }

  /** Lets go of everything: the page will not see it come up. */
  clear(): void {
    this.keyboard.clear();
    this.gamepads.clear();
    this.fingers.clear();
    this.screen.clear();
    this.x = this.z = 0;
    this.run = false;
  }

  #along(more: Action, less: Action): number {
    return Number(this.keyboard.held(more)) - Number(this.keyboard.held(less));
  }
}
