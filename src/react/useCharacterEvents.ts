import { useLayoutEffect, useRef } from 'react';
import type { CharacterEvent } from '../character/characterEvents.js';
import { type CharacterEventProps, EVENT_PROPS } from './characterProps.js';
import type { Walker } from './Walker.js';

const TYPES = Object.keys(EVENT_PROPS) as (keyof typeof EVENT_PROPS)[];

/** The character, as whoever listens to all of its events alike sees it. */
interface Dispatcher {
  addEventListener(type: string, listener: (event: CharacterEvent) => void): void;
  removeEventListener(type: string, listener: (event: CharacterEvent) => void): void;
}

/** Hands the character's events to the newest props. */
export function useCharacterEvents(walker: Walker | null, props: CharacterEventProps): void {
  const newest = useRef(props);
  useLayoutEffect(() => {
    newest.current = props;
  });
  useLayoutEffect(() => {
    if (walker === null) return;
    const character = walker.character as unknown as Dispatcher;
    const listener = (event: CharacterEvent) => {
      (newest.current[EVENT_PROPS[event.type]] as ((event: CharacterEvent) => void) | undefined)?.(
        event,
      );
    };
    for (const type of TYPES) character.addEventListener(type, listener);
    return () => {
      for (const type of TYPES) character.removeEventListener(type, listener);
    };
  }, [walker]);
}
