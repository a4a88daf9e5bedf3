import { mkdirSync, writeFileSync } from 'node:fs';
import type { Backend } from './rendering.js';

/** A line of the table in docs/solid.md, as far as one backend says it. */
export interface SolidRow {
  kind: string;
  /** By default WebGL2. */
  backend?: Backend;
  group: 'material' | 'geometry' | 'node' | 'policy';
  /** Largest error of distance, metres. */
  worst: number;
  texels: number;
  /** Draw calls and programs that one cubemap of it alone takes. */
  draws?: number;
  programs: number;
  note?: string;
}

/** Notes what a test measured, for `npm run build:solid`. */
export function writeRow(row: SolidRow): void {
  // The table tells of the newest three.
  if (process.env.THREE_VERSION !== 'newest') return;
  mkdirSync('test-results/solid', { recursive: true });
  const name = row.kind.toLowerCase().replaceAll(/[^a-z0-9]+/g, '-');
  const { backend = 'WebGL2' } = row;
  writeFileSync(`test-results/solid/${name}.${backend}.json`, `${JSON.stringify(row)}\n`);
}
