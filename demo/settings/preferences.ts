import type { QualityMode } from '../Quality.js';
import { isBindable, type Keys } from './keys.js';

/** What a user likes, on any level. */
export interface Preferences {
  view: 'first' | 'third';
  /** Times the controls' own sensitivity. */
  lookSpeed: number;
  /** Of the picture's height, degrees. */
  fieldOfView: number;
  invertY: boolean;
  toggleRun: boolean;
  quality: QualityMode;
  motion: 'system' | 'full' | 'reduced';
  keys: Keys;
}

/** What one begins with. @param keys of every action there is */
export const defaultPreferences = (keys: Keys): Preferences => ({
  view: 'first',
  lookSpeed: 1,
  fieldOfView: 70,
  invertY: false,
  toggleRun: false,
  quality: 'auto',
  motion: 'system',
  keys: structuredClone(keys),
});

const PLACE = 'three-cube-collider';
/** Counted up when what is stored means something else. */
const VERSION = 1;
/** Keys that an action may have. */
const MOST_KEYS = 3;

/**
 * @param storage may be null, or refuse: the page then works without
 * @param defaults for whatever is not stored, or makes no sense
 */
export function loadPreferences(storage: Storage | null, defaults: Preferences): Preferences {
  let stored: unknown = null;
  try {
    stored = JSON.parse(storage?.getItem(PLACE) ?? 'null');
  } catch {
    // Refused, or not ours.
  }
  return readPreferences(stored, defaults);
}

export function savePreferences(storage: Storage | null, preferences: Preferences): void {
  try {
    storage?.setItem(PLACE, JSON.stringify({ version: VERSION, ...preferences }));
  } catch {
    // Refused, or full: they last as long as the page.
  }
}

/** The browser's storage, or null where even asking for it is refused. */
export function storageOf(page: Window): Storage | null {
  try {
    return page.localStorage;
  } catch {
    return null;
  }
}

/** Takes what it understands of what was stored; the rest is as in `defaults`. */
export function readPreferences(stored: unknown, defaults: Preferences): Preferences {
  const read = structuredClone(defaults);
  if (!isObject(stored) || stored.version !== VERSION) return read;
  const { view, lookSpeed, fieldOfView, invertY, toggleRun, quality, motion, keys } = stored;
  read.view = oneOf(['first', 'third'], view) ?? read.view;
  read.lookSpeed = within(0.2, 3, lookSpeed) ?? read.lookSpeed;
  read.fieldOfView = within(50, 100, fieldOfView) ?? read.fieldOfView;
  if (typeof invertY === 'boolean') read.invertY = invertY;
  if (typeof toggleRun === 'boolean') read.toggleRun = toggleRun;
  read.quality = oneOf(['auto', 'high', 'low'], quality) ?? read.quality;
  read.motion = oneOf(['system', 'full', 'reduced'], motion) ?? read.motion;
  if (isObject(keys)) readKeys(keys, read.keys);
  return read;
}

/** All actions' keys, or none: half of a map could leave two actions with one key. */
function readKeys(stored: Record<string, unknown>, keys: Keys): void {
  const taken = new Set<string>();
  const read: Keys = {};
  for (const action of Object.keys(keys)) {
    const codes = stored[action];
    if (!Array.isArray(codes) || codes.length > MOST_KEYS) return;
    for (const code of codes as unknown[]) {
      if (typeof code !== 'string' || !isBindable(code) || taken.has(code)) return;
      taken.add(code);
    }
    read[action] = codes as string[];
  }
  Object.assign(keys, read);
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function oneOf<T>(choices: T[], value: unknown): T | undefined {
  return choices.find((choice) => choice === value);
}

function within(least: number, most: number, value: unknown): number | undefined {
  return typeof value === 'number' && value >= least && value <= most ? value : undefined;
}
