import { useThree } from '@react-three/fiber';
import { useEffect, useRef } from 'react';
import type { CharacterControlsOptions } from '../controls/controlsOptions.js';
import { useShallow } from './useShallow.js';
import type { Walker } from './Walker.js';

/** What may ask a sleeping character to move, or its camera to turn. */
const KEYS = ['keydown', 'keyup'];
const POINTERS = ['pointerdown', 'pointermove', 'wheel'];

/**
 * Gives a walker controls, which are then `useThree(({ controls }) => controls)`, and wakes a canvas that draws on demand
 * when there is input.
 *
 * @param keys whether it walks by the keys of somebody else
 */
export function useControls(
  walker: Walker | null,
  controls: boolean | CharacterControlsOptions,
  keys: boolean,
): void {
  const get = useThree((state) => state.get);
  const set = useThree((state) => state.set);
  const invalidate = useThree((state) => state.invalidate);
  const element = useThree(({ events, gl }) => (events.connected ?? gl.domElement) as HTMLElement);
  const on = controls !== false;
  const options = useShallow(typeof controls === 'object' ? controls : {});
  const newest = useRef(options);
  newest.current = options;

  // Not a layout effect: the canvas tells only then where its events come from.
  useEffect(() => {
    if (walker === null || !on) return;
    const before = get().controls;
    const disconnect = walker.connect(get().camera, element, newest.current);
    const own = walker.controls;
    set({ controls: own });
    return () => {
      disconnect();
      if (get().controls === (own as unknown)) set({ controls: before });
    };
  }, [walker, on, element, get, set]);

  useEffect(() => {
    if (!walker?.controls) return;
    const { keys, ...fields } = options;
    Object.assign(walker.controls, fields);
    Object.assign(walker.controls.keys, keys);
    invalidate();
  }, [walker, on, element, options, invalidate]);

  useEffect(() => {
    if (!on && !keys) return;
    const wake = () => invalidate();
    const document = element.ownerDocument;
    for (const type of KEYS) document.addEventListener(type, wake);
    for (const type of POINTERS) element.addEventListener(type, wake, { passive: true });
    return () => {
      for (const type of KEYS) document.removeEventListener(type, wake);
      for (const type of POINTERS) element.removeEventListener(type, wake);
    };
  }, [on, keys, element, invalidate]);
}
