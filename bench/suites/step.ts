import { Vector3 } from 'three';
import type { Backend } from '../../e2e/support/rendering.js';
import { Inputs } from '../walk/Inputs.js';
import type { Walker } from '../rivals/Walker.js';
import { type FrameCost, MeteredCharacter, partsOf } from './MeteredCharacter.js';
import { BACKENDS, nameOf } from './ours.js';
import { FRAME, later, mean, nextFrame, quantile, rotated } from './pace.js';
import { levelPlace, type Place, SIZES, terrainPlace } from './places.js';
import { type Rival, RIVALS } from './rivals.js';
import { Rows } from './Rows.js';
import type { SuiteOptions, SuiteRow } from './suite.js';

/** Frames after it was placed for a walker to come to rest. */
const SETTLING = 90;
/** How far below everything it has fallen out, metres. */
const LOST = 10;

const STILL = new Vector3();

/** One who walks through a place, over and over. */
interface Contestant {
  name: string;
  /** @returns figures by name; of the frames with inputs alone */
  walk(place: Place, number: number, frames: number): Promise<Record<string, number>>;
  dispose(): void;
}

/** What a character's frame keeps the main thread, as the triangles around it grow. */
export default async function step(
  { quick, repeats, levels }: SuiteOptions,
  tell: (line: string) => void,
): Promise<SuiteRow[]> {
  const rows = new Rows();
  const frames = quick ? 40 : 150;
  const rounds = quick ? Math.min(repeats, 2) : Math.max(repeats, 5);
  const places = [
    ...Object.entries(SIZES)
      .slice(0, quick ? 2 : undefined)
      .map(
        ([name, triangles]) =>
          async () =>
            terrainPlace(name, triangles),
      ),
    ...levels.slice(0, quick ? 1 : undefined).map((level) => () => levelPlace(level)),
  ];
  for (const make of places) {
    const place = await make();
    tell(`${place.name}: ${place.triangles} triangles`);
    const contestants = await enter(place, rows);
    for (const each of contestants) await each.walk(place, 0, quick ? 60 : frames);
    for (let round = 0; round < rounds; round++) {
      for (const each of rotated(contestants, round)) {
        const figures = await each.walk(place, round, frames);
        for (const [figure, sample] of Object.entries(figures)) {
          rows.add(place.name, each.name, figure, sample);
        }
        tell(`  ${each.name}: ${figures['a step, mean, ms']?.toFixed(3)} ms a step`);
      }
    }
    for (const each of contestants) each.dispose();
    await later();
  }
  return rows.all;
}

/** All who can, ready to walk. */
async function enter(place: Place, rows: Rows): Promise<Contestant[]> {
  const found: Contestant[] = [];
  for (const backend of BACKENDS) {
    const ours = await enterOurs(backend, place);
    if (ours) found.push(ours);
    else
      rows.add(place.name, nameOf(backend), 'a step, mean, ms', undefined, 'not in this browser');
  }
  for (const rival of RIVALS) {
    const entered = await enterRival(rival, place);
    if (typeof entered !== 'string') found.push(entered);
    else rows.add(place.name, rival.name, 'a step, mean, ms', undefined, entered);
  }
  return found;
}

async function enterOurs(backend: Backend, { scene, start }: Place): Promise<Contestant | null> {
  const metered = await MeteredCharacter.create(backend, scene, start(0));
  if (metered === null) return null;
  const { character, collider } = metered;
  return {
    name: nameOf(backend),
    walk: (place, number, frames) =>
      metered.watched(async () => {
        character.teleport(place.start(number));
        for (let i = 0; i < SETTLING; i++) {
          await metered.frame(STILL, false);
          if (i > 2 && character.grounded) break;
        }
        const { steps, held } = character.stats;
        const { draws, forced } = collider.stats;
        const costs: FrameCost[] = [];
        const inputs = new Inputs(1 + number, new Vector3());
        for (let i = 0; i < frames; i++) {
          const { velocity, jump } = inputs.advanceTo(i * FRAME);
          costs.push(await metered.frame(velocity, jump));
          const { position } = character.body;
          if (position.y < place.lowest - LOST) character.teleport(place.start(number));
        }
        const figures = { ...summary(costs.map(({ whole }) => whole)), ...partsOf(costs) };
        figures['probes a frame'] = (collider.stats.draws - draws) / frames;
        figures['reads waited for, % of probes'] =
          (100 * (collider.stats.forced - forced)) / (collider.stats.draws - draws);
        figures['steps held, %'] =
          (100 * (character.stats.held - held)) / (character.stats.steps - steps);
        return figures;
      }),
    dispose: () => metered.dispose(),
  };
}

/** @returns or why it cannot */
async function enterRival(rival: Rival, { geometry, triangles }: Place) {
  if (triangles > rival.most) return 'cannot: over a minute to build';
  let walker: Walker;
  try {
    walker = await rival.create(geometry);
  } catch (error) {
    return `cannot: ${String(error)}`;
  }
  return {
    name: rival.name,
    walk: (place: Place, number: number, frames: number) =>
      walkRival(walker, place, number, frames),
    dispose: () => walker.dispose(),
  };
}

async function walkRival(walker: Walker, place: Place, number: number, frames: number) {
  walker.place(place.start(number));
  for (let i = 0; i < SETTLING; i++) {
    walker.frame(STILL, false, FRAME);
    if (i > 2 && walker.grounded) break;
  }
  const times: number[] = [];
  const inputs = new Inputs(1 + number, new Vector3());
  for (let i = 0; i < frames; i++) {
    // As seldom as ours: what lies idle between two frames finds its caches cold.
    await nextFrame();
    const { velocity, jump } = inputs.advanceTo(i * FRAME);
    const start = performance.now();
    walker.frame(velocity, jump, FRAME);
    times.push(performance.now() - start);
    if (walker.foot.y < place.lowest - LOST) walker.place(place.start(number));
  }
  return summary(times);
}

function summary(times: number[]): Record<string, number> {
  return {
    'a step, mean, ms': mean(times),
    'a step, median, ms': quantile(times, 0.5),
    'a step, p95, ms': quantile(times, 0.95),
  };
}
