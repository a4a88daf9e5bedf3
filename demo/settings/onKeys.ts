import { element } from '../page.js';
import type { Keys } from './keys.js';

/**
 * Calls what a pressed key stands for, unless an input has the focus, which needs it itself; and what a button of the
 * page does by its `data-does`.
 *
 * @param preferences whose keys are read at each press
 * @param enabled whether keys are wanted now
 */
export function onKeys(
  preferences: { readonly keys: Keys },
  enabled: () => boolean,
  actions: Record<string, () => void>,
): void {
  for (const button of document.querySelectorAll<HTMLElement>('[data-does]')) {
    button.addEventListener('click', ({ detail }) => {
      actions[button.dataset.does!]!();
      // Clicked, not pressed by a key: the keys are for walking again.
      if (detail > 0) element('picture').focus({ preventScroll: true });
    });
  }
  window.addEventListener('keydown', ({ code, repeat, ctrlKey, altKey, metaKey, target }) => {
    if (!enabled() || repeat || ctrlKey || altKey || metaKey) return;
    if (target instanceof HTMLInputElement || target instanceof HTMLSelectElement) return;
    for (const [action, act] of Object.entries(actions)) {
      if (preferences.keys[action]?.includes(code)) act();
    }
  });
}
