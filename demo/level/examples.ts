import { DEFAULT_LEVEL } from '../parameters.js';

/** Levels to try: `npm run build:level` makes them. */
export const EXAMPLES = [
  { name: 'Plaza', about: 'this demo’s own, with its hall', url: DEFAULT_LEVEL },
  { name: 'Maze', about: 'hedges, and a way out', url: example('maze') },
  { name: 'Tower', about: 'a stair winds up to its top', url: example('tower') },
  { name: 'Valley', about: 'hills, firs and rocks', url: example('valley') },
] as const;

function example(name: string): string {
  return `${import.meta.env.BASE_URL}examples/${name}.glb`;
}
