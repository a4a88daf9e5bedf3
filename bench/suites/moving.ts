import { Vector3 } from 'three';
import { type FrameCost, MeteredCharacter, partsOf } from './MeteredCharacter.js';
import { boxes } from './moving/boxes.js';
import { crowd } from './moving/crowd.js';
import type { MovingCase, MovingRival } from './moving/MovingCase.js';
import { morph } from './moving/morph.js';
import { BACKENDS, nameOf } from './ours.js';
import { later, mean, nextFrame, rotated } from './pace.js';
import { rapierMemory } from '../rivals/rapierMemory.js';
import { Rows } from './Rows.js';
import type { SuiteOptions, SuiteRow } from './suite.js';

/** Of a rival that is slow, so many seconds a repeat are enough to know it. */
const LONGEST = 2;
/** Frames until ours stands on the floor. */
const SETTLING = 60;

const STILL = new Vector3();
const FIGURE = 'a frame, ms';

interface Contestant {
  name: string;
  note?: string;
  /** @returns figures by name, of so many frames in which everything moved */
  live(frames: number): Promise<Record<string, number>>;
  dispose(): void;
}

/** What a character standing in the midst of what moves keeps the main thread, a frame. */
export default async function moving(
  { quick, repeats }: SuiteOptions,
  tell: (line: string) => void,
): Promise<SuiteRow[]> {
  await rapierMemory();
  const rows = new Rows();
  const rounds = quick ? 1 : Math.max(repeats, 5);
  const frames = quick ? 30 : 60;
  const cases = [
    () => crowd(10_000),
    () => crowd(100_000),
    ...(quick ? [] : [() => crowd(500_000)]),
    () => morph(quick ? 10_000 : 100_000),
    () => boxes(1000),
  ];
  for (const make of cases) {
    const what = make();
    tell(what.name);
    for (const [name, why] of Object.entries(what.cannot)) {
      rows.add(what.name, name, FIGURE, undefined, why);
    }
    const contestants = await gather(what, rows);
    // Programs and engines warm.
    for (const each of contestants) await each.live(3);
    for (let round = 0; round < rounds; round++) {
      for (const each of rotated(contestants, round)) {
        const figures = await each.live(frames);
        for (const [figure, sample] of Object.entries(figures)) {
          rows.add(what.name, each.name, figure, sample, each.note);
        }
        tell(`  ${each.name}: ${figures[FIGURE]?.toFixed(3)} ms a frame`);
      }
    }
    for (const each of contestants) each.dispose();
    await later();
  }
  return rows.all;
}

async function gather(what: MovingCase, rows: Rows): Promise<Contestant[]> {
  const found: Contestant[] = [];
  for (const backend of BACKENDS) {
    const metered = await MeteredCharacter.create(backend, what.scene, what.foot);
    if (metered) found.push(ours(nameOf(backend), metered, what));
    else rows.add(what.name, nameOf(backend), FIGURE, undefined, 'not in this browser');
  }
  for (const rival of what.rivals()) found.push(theirs(rival, what));
  return found;
}

function ours(name: string, metered: MeteredCharacter, what: MovingCase): Contestant {
  const { character, collider } = metered;
  let placed = false;
  return {
    name,
    live: (frames) =>
      metered.watched(async () => {
        if (!placed) {
          character.teleport(what.foot);
          for (let i = 0; i < SETTLING && !character.grounded; i++) {
            await metered.frame(STILL, false);
          }
          placed = true;
        }
        const { draws } = collider.stats;
        const costs: FrameCost[] = [];
        const arrivals: number[] = [];
        for (let i = 0; i < frames; i++) {
          advance(what, i);
          const { reads } = collider.stats;
          costs.push(await metered.frame(STILL, false));
          if (collider.stats.reads > reads) arrivals.push(metered.latency);
        }
        return {
          [FIGURE]: mean(costs.map(({ whole }) => whole)),
          ...partsOf(costs),
          // From the draw's begin until the field is there.
          'a probe with its GPU work, ms': mean(arrivals),
          'probes a frame': (collider.stats.draws - draws) / frames,
        };
      }),
    dispose: () => metered.dispose(),
  };
}

function theirs(rival: MovingRival, what: MovingCase): Contestant {
  return {
    name: rival.name,
    note: rival.note,
    async live(frames) {
      const times: number[] = [];
      const end = performance.now() + 1000 * LONGEST;
      for (let i = 0; i < frames && (i === 0 || performance.now() < end); i++) {
        await nextFrame();
        advance(what, i);
        const start = performance.now();
        await rival.frame();
        times.push(performance.now() - start);
      }
      return { [FIGURE]: mean(times) };
    },
    dispose: () => rival.dispose(),
  };
}

/** As the page does it for its own picture: nobody's cost. */
function advance(what: MovingCase, frame: number): void {
  what.move(frame);
  what.scene.updateMatrixWorld();
}
