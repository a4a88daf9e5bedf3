import { ActionSet, type ButtonAction, type ButtonMap } from './actions.js';

/** What `Gamepads` is told; `CharacterControls` has these fields. Read at each question, so they may be changed. */
export interface GamepadsSettings {
  buttons: ButtonMap;
  /** Part of a stick's way that counts as none. */
  deadZone: number;
}

const ACTIONS: readonly ButtonAction[] = ['jump', 'crouch', 'run', 'view'];
/** The cross of the standard mapping walks, too: up, down, left, right. */
const CROSS = 12;
const MOST_BUTTONS = 32;
/** Of a button: up, down, or down since before the page was left. */
const UP = 0;
const DOWN = 1;
const STALE = 2;

/**
 * Gamepads of the standard mapping, all of them as one. Asked only while one is connected. What was down or tilted when
 * the page was left counts no more until it has been let go.
 */
export class Gamepads {
  /** Left stick, -1 to 1, right and down positive, without the dead zone. */
  walkX = 0;
  walkY = 0;
  /** Right stick, likewise; finer near its middle. */
  lookX = 0;
  lookY = 0;
  readonly actions = new ActionSet();

  readonly #settings: GamepadsSettings;
  readonly #buttons = new Uint8Array(MOST_BUTTONS);
  #window: Window | null = null;
  /** How many are connected, as events tell. */
  #count = 0;
  #walkStale = false;
  #lookStale = false;

  constructor(settings: GamepadsSettings) {
    this.#settings = settings;
  }

  connect(window: Window | null): void {
    this.#window = window;
    window?.addEventListener('gamepadconnected', this.#onChange);
    window?.addEventListener('gamepaddisconnected', this.#onChange);
    this.#onChange();
  }

  disconnect(): void {
    this.#window?.removeEventListener('gamepadconnected', this.#onChange);
    this.#window?.removeEventListener('gamepaddisconnected', this.#onChange);
    this.#window = null;
    this.#count = 0;
    this.clear();
  }

  /** Reads sticks and buttons: once a frame. */
  read(): void {
    this.walkX = this.walkY = this.lookX = this.lookY = 0;
    if (this.#count === 0) return;
    const pads = this.#window!.navigator.getGamepads();
    for (let i = 0; i < pads.length; i++) {
      const pad = pads[i];
      if (pad && pad.mapping === 'standard') this.#readSticks(pad);
    }
    if (this.#walkStale) {
      this.#walkStale = this.walkX !== 0 || this.walkY !== 0;
      this.walkX = this.walkY = 0;
    }
    if (this.#lookStale) {
      this.#lookStale = this.lookX !== 0 || this.lookY !== 0;
      this.lookX = this.lookY = 0;
    }
    this.lookX *= Math.abs(this.lookX);
    this.lookY *= Math.abs(this.lookY);
    for (let b = 0; b < MOST_BUTTONS; b++) this.#readButton(b, isDown(pads, b));
    this.walkX += this.#cross(3) - this.#cross(2);
    this.walkY += this.#cross(1) - this.#cross(0);
  }

  /** Lets go of all: the page is being left. */
  clear(): void {
    this.actions.clear();
    this.#walkStale = this.#lookStale = true;
    this.walkX = this.walkY = this.lookX = this.lookY = 0;
    for (let b = 0; b < MOST_BUTTONS; b++) if (this.#buttons[b] === DOWN) this.#buttons[b] = STALE;
  }

  #readSticks({ axes }: Gamepad): void {
    const { deadZone } = this.#settings;
    const walk = live(axes[0]!, axes[1]!, deadZone);
    this.walkX += walk * axes[0]!;
    this.walkY += walk * axes[1]!;
    const look = live(axes[2]!, axes[3]!, deadZone);
    this.lookX += look * axes[2]!;
    this.lookY += look * axes[3]!;
  }

  #readButton(b: number, down: boolean): void {
    const before = this.#buttons[b];
    if (!down) this.#buttons[b] = UP;
    else if (before === UP) this.#buttons[b] = DOWN;
    const now = this.#buttons[b];
    if (now === before || now === STALE) return;
    for (let a = 0; a < ACTIONS.length; a++) {
      if (!this.#settings.buttons[ACTIONS[a]!].includes(b)) continue;
      if (now === DOWN) this.actions.press(ACTIONS[a]!);
      else this.actions.release(ACTIONS[a]!);
    }
  }

  #cross(side: number): number {
    return this.#buttons[CROSS + side] === DOWN ? 1 : 0;
  }

  readonly #onChange = (): void => {
    this.#count = 0;
    // Where a page may not have gamepads, asking throws.
    try {
      for (const pad of this.#window?.navigator?.getGamepads?.() ?? []) if (pad) this.#count++;
    } catch {
      this.#count = 0;
    }
    if (this.#count === 0) this.clear();
  };
}

/** What a stick's tilt is to be multiplied by, so that it grows from 0 at the dead zone's rim to 1 at its own. */
function live(x: number, y: number, deadZone: number): number {
  const tilt = Math.sqrt(x * x + y * y);
  if (!(tilt > deadZone)) return 0;
  return Math.min(1, (tilt - deadZone) / (1 - deadZone)) / tilt;
}

function isDown(pads: readonly (Gamepad | null)[], b: number): boolean {
  for (let i = 0; i < pads.length; i++) {
    const pad = pads[i];
    if (pad && pad.mapping === 'standard' && pad.buttons[b]?.pressed) return true;
  }
  return false;
}
