import type { CharacterControls } from 'three-cube-collider';
import { SWITCHES } from './followPreferences.js';
import { keysToChoose, PAGE_KEYS } from './keys.js';
import {
  defaultPreferences,
  loadPreferences,
  type Preferences,
  savePreferences,
  storageOf,
} from './preferences.js';
import { SettingsDialog } from './SettingsDialog.js';

/** What the user prefers, as kept from the last visit, and the dialog that changes it. */
export interface KeptPreferences {
  readonly preferences: Preferences;
  /** Keeps them for the next visit. */
  save(): void;
}

/**
 * @param kept whether they last longer than the page
 * @param changed called after the dialog has changed one
 */
export function createPreferences(
  controls: CharacterControls,
  kept: boolean,
  changed: () => void,
): KeptPreferences {
  const storage = kept ? storageOf(window) : null;
  const defaults = defaultPreferences({ ...keysToChoose(controls.keys), ...PAGE_KEYS });
  const preferences = loadPreferences(storage, defaults);
  const save = () => savePreferences(storage, preferences);
  const dialog = new SettingsDialog(preferences, defaults, () => {
    changed();
    save();
  });
  for (const name of SWITCHES) if (!(name in controls)) dialog.leaveOut(name);
  return { preferences, save };
}
