import { keyName, learnLayout, type Keys } from './keys.js';

/** Writes the first key of each action into every `data-keys="forward left"` of the page. */
export function showKeys(keys: Keys): void {
  const write = () => {
    for (const list of document.querySelectorAll<HTMLElement>('[data-keys]')) {
      const codes = list.dataset.keys!.split(' ').flatMap((action) => keys[action]?.[0] ?? []);
      list.replaceChildren(
        ...codes.map((code) => {
          const key = document.createElement('kbd');
          key.textContent = keyName(code);
          return key;
        }),
      );
    }
  };
  write();
  void learnLayout().then(write);
}
