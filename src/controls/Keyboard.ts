import type { Action, KeyMap } from './actions.js';

/** What `Keyboard` is told; `CharacterControls` has these fields. Read at each question, so they may be changed. */
export interface KeyboardSettings {
  keys: KeyMap;
  /** Whether the keys of `turnLeft` and `turnRight` turn, and do nothing else. */
  turnKeys: boolean;
}

/** Inputs that take no text: they own only the keys that press them. */
const PRESSABLE = new Set(['button', 'checkbox', 'color', 'file', 'image', 'reset', 'submit']);

/**
 * Whether the focused element needs this key itself: a text field needs all of them, a button those that press it.
 */
export function ownsKey(target: EventTarget | null, code: string): boolean {
  const element = target as Partial<HTMLInputElement> | null;
  if (!element?.tagName) return false;
  const tag = element.tagName.toLowerCase();
  const presses = code === 'Space' || code === 'Enter';
  if (tag === 'button' || tag === 'a' || tag === 'summary') return presses;
  if (tag === 'input' && PRESSABLE.has(element.type ?? 'text')) return presses;
  return tag === 'input' || tag === 'select' || tag === 'textarea' || !!element.isContentEditable;
}

/**
 * Which actions are being asked for. Holds no listeners of its own: `CharacterControls` hands it the events.
 */
export class Keyboard {
  readonly #down = new Set<string>();
  readonly #pressed = new Set<string>();

  readonly #settings: KeyboardSettings;

  constructor(settings: KeyboardSettings) {
    this.#settings = settings;
  }

  /** Takes a `keydown`. A key that is bound is swallowed, so the page does not scroll; Tab and shortcuts never are. */
  press(event: KeyboardEvent): void {
    if (event.code === 'Tab' || event.ctrlKey || event.metaKey || event.altKey) return;
    if (ownsKey(event.target, event.code) || !this.#bound(event.code)) return;
    event.preventDefault();
    if (event.repeat) return;
    this.#down.add(event.code);
    this.#pressed.add(event.code);
  }

  /** Takes a `keyup`. macOS sends none for keys let go while Command is down, so Command lets go of all. */
  release(event: KeyboardEvent): void {
    if (event.key === 'Meta') this.clear();
    this.#down.delete(event.code);
  }

  /** Whether a key of `action` is down. */
  held(action: Action): boolean {
    const codes = this.#settings.keys[action];
    for (let i = 0; i < codes.length; i++) {
      if (this.#down.has(codes[i]!) && this.#means(codes[i]!, action)) return true;
    }
    return false;
  }

  /** Whether a key of `action` went down since this was last asked, however short it was held. */
  taken(action: Action): boolean {
    const codes = this.#settings.keys[action];
    let any = false;
    for (let i = 0; i < codes.length; i++) any = this.#pressed.delete(codes[i]!) || any;
    return any;
  }

  /** Lets go of every key: the page lost the focus and will not see them come up. */
  clear(): void {
    this.#down.clear();
    this.#pressed.clear();
  }

  /** A key that turns does not walk as well. */
  #means(code: string, action: Action): boolean {
    const { keys, turnKeys } = this.#settings;
    if (action === 'turnLeft' || action === 'turnRight') return turnKeys;
    return !turnKeys || !(keys.turnLeft.includes(code) || keys.turnRight.includes(code));
  }

  #bound(code: string): boolean {
    return Object.values(this.#settings.keys).some((codes) => codes.includes(code));
  }
}
