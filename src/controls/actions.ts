/** What a button on the screen or of a gamepad can ask for. */
export type ButtonAction = 'jump' | 'crouch' | 'run' | 'view';
/** What a key can ask for. */
export type Action =
  ButtonAction | 'forward' | 'back' | 'left' | 'right' | 'turnLeft' | 'turnRight';

/** Per action the keys that ask for it, as `KeyboardEvent.code` names them: by place, whatever the layout. */
export type KeyMap = Record<Action, string[]>;
/** Per action the gamepad's buttons that ask for it, by their numbers in the standard mapping. */
export type ButtonMap = Record<ButtonAction, number[]>;

/**
 * WASD and the arrows, Shift, Space, C (not Ctrl, which closes the page together with W). A new map each time, so that
 * one may be changed.
 */
export function defaultKeys(): KeyMap {
  return {
    forward: ['KeyW', 'ArrowUp'],
    back: ['KeyS', 'ArrowDown'],
    left: ['KeyA', 'ArrowLeft'],
    right: ['KeyD', 'ArrowRight'],
    turnLeft: ['ArrowLeft'],
    turnRight: ['ArrowRight'],
    run: ['ShiftLeft', 'ShiftRight'],
    jump: ['Space'],
    crouch: ['KeyC'],
    view: [],
  };
}

/** A jumps, B crouches, LB or a press of the left stick runs, Y or Back switches the view. A new map each time. */
export function defaultButtons(): ButtonMap {
  return { jump: [0], crouch: [1], run: [4, 10], view: [3, 8] };
}

/** Actions that are being asked for, by whatever presses and lets go. */
export class ActionSet {
  readonly #down = new Set<Action>();
  readonly #pressed = new Set<Action>();

  press(action: Action): void {
    this.#down.add(action);
    this.#pressed.add(action);
  }

  release(action: Action): void {
    this.#down.delete(action);
  }

  held(action: Action): boolean {
    return this.#down.has(action);
  }

  /** Whether it was pressed since this was last asked, however shortly. */
  taken(action: Action): boolean {
    return this.#pressed.delete(action);
  }

  clear(): void {
    this.#down.clear();
    this.#pressed.clear();
  }
}
