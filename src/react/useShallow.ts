import { useRef } from 'react';

/** The value of an earlier render as long as each of its own properties is the same: literals in JSX are new each time. */
export function useShallow<T extends object | undefined>(value: T): T {
  const kept = useRef(value);
  if (!isAlike(kept.current, value)) kept.current = value;
  return kept.current;
}

function isAlike(a: object | undefined, b: object | undefined): boolean {
  if (a === b) return true;
  if (a === undefined || b === undefined) return false;
  const names = Object.keys(a);
  const [before, now] = [a, b] as Record<string, unknown>[];
  return (
    names.length === Object.keys(b).length &&
    names.every((name) => name in b && Object.is(before![name], now![name]))
  );
}
