import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { assignKey, keyName, type Keys, titleOf } from '../demo/settings/keys.js';
import {
  defaultPreferences,
  loadPreferences,
  type Preferences,
  readPreferences,
  savePreferences,
} from '../demo/settings/preferences.js';

const defaults = () =>
  defaultPreferences({ forward: ['KeyW', 'ArrowUp'], back: ['KeyS'], jump: ['Space'] });

/** A browser's storage with one place. */
function storageWith(text: string | null) {
  const storage = {
    text,
    getItem: () => storage.text,
    setItem: (_: string, value: string) => (storage.text = value),
  };
  return storage as typeof storage & Storage;
}

describe('the demo’s preferences', () => {
  it('should come back as they were kept', () => {
    const liked: Preferences = {
      view: 'third',
      lookSpeed: 1.7,
      fieldOfView: 95,
      invertY: true,
      toggleRun: true,
      quality: 'low',
      motion: 'reduced',
      keys: { forward: ['KeyI'], back: ['KeyK', 'ArrowDown'], jump: [] },
    };
    const storage = storageWith(null);
    savePreferences(storage, liked);
    expect(loadPreferences(storage, defaults())).toEqual(liked);
  });

  it('should do without a storage, or with one that refuses', () => {
    const refuse = () => {
      throw new DOMException('no', 'SecurityError');
    };
    const refusing = { getItem: refuse, setItem: refuse } as unknown as Storage;
    for (const storage of [null, refusing]) {
      expect(() => savePreferences(storage, defaults())).not.toThrow();
      expect(loadPreferences(storage, defaults())).toEqual(defaults());
    }
  });

  it('should be as made where what is stored is broken, or of another version', () => {
    for (const text of ['{', 'null', '[]', '7', '{"version":2,"view":"third"}']) {
      expect(loadPreferences(storageWith(text), defaults())).toEqual(defaults());
    }
  });

  it('should take each value that makes sense and no other', () => {
    const stored = {
      version: 1,
      view: 'second',
      lookSpeed: 99,
      fieldOfView: '80',
      quality: 'high',
    };
    expect(readPreferences(stored, defaults())).toEqual({ ...defaults(), quality: 'high' });
  });

  it('should keep the keys as made if any of those stored will not do', () => {
    const keys = { forward: ['KeyI'], back: ['KeyK'], jump: ['KeyJ'] };
    const read = (wrong: object) =>
      readPreferences({ version: 1, keys: { ...keys, ...wrong } }, defaults()).keys;
    expect(read({})).toEqual(keys);
    for (const wrong of [
      { jump: 'KeyJ' },
      { jump: ['KeyI'] },
      { jump: ['Escape'] },
      { jump: [7] },
      { jump: ['<b>'] },
      { jump: undefined },
    ]) {
      expect(read(wrong)).toEqual(defaults().keys);
    }
  });

  it('should never give two actions one key, nor lose an action', () => {
    const codes = ['KeyA', 'KeyB', 'KeyC', 'Space'];
    const change = fc.tuple(
      fc.constantFrom('forward', 'back', 'jump'),
      fc.nat(1),
      fc.constantFrom(...codes),
    );
    fc.assert(
      fc.property(fc.array(change, { maxLength: 20 }), (changes) => {
        const keys: Keys = { forward: ['KeyA', 'KeyB'], back: ['KeyC'], jump: ['Space'] };
        for (const [action, place, code] of changes) {
          assignKey(keys, action, Math.min(place, keys[action]!.length), code);
          expect(keys[action]).toContain(code);
          const all = Object.values(keys).flat();
          expect(new Set(all).size).toBe(all.length);
          expect(all.every((each) => typeof each === 'string')).toBe(true);
        }
      }),
      { seed: 7 },
    );
  });

  it('should tell who lost a key', () => {
    const keys = defaults().keys;
    expect(assignKey(keys, 'jump', 0, 'KeyS')).toBe('back');
    expect(keys).toEqual({ forward: ['KeyW', 'ArrowUp'], back: [], jump: ['KeyS'] });
    expect(assignKey(keys, 'jump', 0, 'KeyX')).toBeNull();
  });

  it('should call keys and actions what people call them', () => {
    const names = ['KeyW', 'Digit1', 'ArrowUp', 'Space', 'PageDown', 'Numpad0'].map(keyName);
    expect(names).toEqual(['W', '1', '↑', 'Space', 'Page Down', 'Numpad 0']);
    expect([titleOf('jump'), titleOf('turnLeft')]).toEqual(['Jump', 'Turn left']);
  });
});
