/** Per action its keys, as `KeyboardEvent.code` names them. */
export type Keys = Record<string, string[]>;

/** What keys do besides walking. */
export const PAGE_KEYS: Keys = { switchView: ['KeyV'], colliderView: ['KeyH'], panel: ['KeyP'] };

/** Those of the controls' keys that the page lets a user choose: the arrows walk in it, and turn nobody. */
export function keysToChoose(keys: Readonly<Keys>): Keys {
  return Object.fromEntries(Object.entries(keys).filter(([action]) => !action.startsWith('turn')));
}

const TITLES: Record<string, string> = {
  forward: 'Forward',
  back: 'Back',
  left: 'Left',
  right: 'Right',
  run: 'Run',
  jump: 'Jump',
  crouch: 'Crouch',
  switchView: 'Switch the view',
  colliderView: 'What the collider sees',
  panel: 'The collider’s options',
};

/** `turnLeft` is "Turn left", where nobody has found better words. */
export function titleOf(action: string): string {
  const words = action.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`);
  return TITLES[action] ?? words[0]!.toUpperCase() + words.slice(1);
}

/** Escape pauses, Tab moves the focus, the others belong to the browser and the system. */
const RESERVED = /^(Escape|Tab|F\d+|Meta.*|OS.*|Control.*|Alt.*|ContextMenu|)$/;

export const isBindable = (code: string) => !RESERVED.test(code) && /^[A-Za-z0-9]+$/.test(code);

/**
 * Gives an action a key in place of one of its own, and takes that key from whatever had it.
 *
 * @param place which of the action's keys; one past the last adds one
 * @returns the action that lost the key, or null
 */
export function assignKey(keys: Keys, action: string, place: number, code: string): string | null {
  let loser: string | null = null;
  for (const [other, codes] of Object.entries(keys)) {
    const at = codes.indexOf(code);
    if (at === -1 || (other === action && at === place)) continue;
    codes.splice(at, 1);
    if (other === action) place -= Number(at < place);
    else loser = other;
  }
  keys[action]![place] = code;
  return loser;
}

const NAMES: Record<string, string> = {
  ArrowUp: '↑',
  ArrowDown: '↓',
  ArrowLeft: '←',
  ArrowRight: '→',
  ShiftLeft: 'Shift',
  ShiftRight: 'right Shift',
};

/** What the keyboard's own letters are, where the browser tells: W is Z on a French one. */
const layout = new Map<string, string>();

/** Learns the keyboard's letters; resolved at once where they are a secret. */
export async function learnLayout(): Promise<void> {
  const { keyboard } = navigator as { keyboard?: { getLayoutMap(): Promise<Map<string, string>> } };
  const known = await keyboard?.getLayoutMap().catch(() => undefined);
  known?.forEach((letter, code) => layout.set(code, letter));
}

/** What is printed on a key. */
export function keyName(code: string): string {
  const letter = layout.get(code);
  if (letter) return letter.toUpperCase();
  return NAMES[code] ?? code.replace(/^(Key|Digit)/, '').replace(/(?<=[a-z])(?=[A-Z0-9])/g, ' ');
}
