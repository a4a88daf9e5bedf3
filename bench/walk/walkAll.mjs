// @ts-check
import { appendFileSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';
import { versions } from './options.mjs';
import { openSession, urlOf } from './session.mjs';
import { lateness, nameOf } from './table.mjs';

/** @typedef {ReturnType<typeof import('./options.mjs').readOptions>} Options */
/** @typedef {Pick<Options, 'levels' | 'start' | 'trace' | 'json' | 'hz' | 'latency' | 'steps' | 'asyncSteps' | 'seed' | 'leg' | 'rivals' | 'collider' | 'character' | 'backend' | 'real-async'>} WalkOptions as `npm run walk` takes them */

const RIVALS = ['mesh-bvh', 'octree', 'rapier'];

/**
 * Every walk on every level.
 *
 * @param {WalkOptions} options
 */
export async function walkAll(options) {
  const session = await openSession(options.levels);
  try {
    const results = {
      machine: session.machine,
      versions: versions(),
      seed: options.seed,
      /** @type {any[]} */
      levels: [],
    };
    for (const [i, file] of options.levels.entries()) {
      const place = { level: urlOf(i), start: options.start };
      const description = await session.ask({ do: 'describe', ...place });
      const level = { name: basename(file), ...description, rows: [] };
      results.levels.push(level);
      for (const walk of cases(options)) {
        const title = `${level.name}, ${nameOf(walk)}, ${walk.hz} Hz, ${lateness(walk.latency)}`;
        const { trace, ...result } = await session.walk(
          { ...walk, ...place, trace: options.trace !== undefined },
          title,
        );
        level.rows.push({ ...walk, ...result });
        if (options.trace) appendTrace(options.trace, [level.name, walk], trace);
        // A long run that is broken off leaves what it has.
        if (options.json) writeFileSync(options.json, JSON.stringify(results));
      }
    }
    return results;
  } finally {
    await session.close();
  }
}

/**
 * @param {string} file
 * @param {[string, any]} of the level's name, and the walk
 * @param {number[][]} trace
 */
function appendTrace(file, [level, { mover, hz, latency }], trace) {
  const head = `${level},${mover},${hz},${lateness(latency)}`;
  appendFileSync(file, trace.map((frame, i) => `${head},${i},${frame.join()}\n`).join(''));
}

/**
 * Every walk of one level.
 *
 * @param {WalkOptions} options
 * @returns {Generator<any>} a `WalkCase` each, but for the level
 */
function* cases({
  hz: rates,
  latency,
  steps,
  asyncSteps,
  seed,
  leg,
  rivals,
  collider,
  character,
  backend: backends,
  ...options
}) {
  const ours = { mover: 'cube', collider, character };
  for (const hz of rates) {
    const common = { hz, seed, leg, frames: steps, latency: 0 };
    if (rivals) for (const mover of RIVALS) yield { ...common, mover };
    for (const backend of backends) {
      // Elsewhere the next frame is the earliest.
      for (const late of backend === 'WebGL2' ? latency : [1]) {
        yield { ...common, ...ours, backend, latency: late };
      }
    }
  }
  if (!options['real-async']) return;
  const common = { hz: 60, seed, leg, frames: asyncSteps };
  if (rivals && asyncSteps !== steps) yield { ...common, mover: 'mesh-bvh', latency: 0 };
  for (const backend of backends) yield { ...common, ...ours, backend, latency: 'real' };
}
