import { type CharacterControls, DEFAULTS } from 'three-cube-collider';
import type { Preferences } from './preferences.js';

/** Preferences that are switches of the controls, by name. */
export const SWITCHES = ['invertY', 'toggleRun'] as const;

/** Sets what the controls have of what a user likes. */
export function followPreferences(controls: CharacterControls, preferences: Preferences): void {
  const { keys } = controls;
  for (const action of Object.keys(keys) as (keyof typeof keys)[]) {
    keys[action] = preferences.keys[action] ?? keys[action];
  }
  for (const name of SWITCHES) {
    if (name in controls) Object.assign(controls, { [name]: preferences[name] });
  }
  controls.sensitivity = DEFAULTS.controls.sensitivity * preferences.lookSpeed;
}
