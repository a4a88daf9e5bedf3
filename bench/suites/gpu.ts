import { Vector3 } from 'three';
import { createProbe, type Probe, PROBES } from './gpu/probes.js';
import { later, mean, quantile, rotated } from './pace.js';
import { levelPlace, type Place, terrainPlace } from './places.js';
import { Rows } from './Rows.js';
import type { SuiteOptions, SuiteRow } from './suite.js';

/** Height of a character's probe above its foot, metres. */
const LEVEL = 0.65;
/** Apart from each other, metres. */
const STRIDE = 0.34;

/** What a probe takes from its draw to its texels: of ours, and of three's own cube camera read face by face. */
export default async function gpu(
  { quick, repeats, levels }: SuiteOptions,
  tell: (line: string) => void,
): Promise<SuiteRow[]> {
  const rows = new Rows();
  const rounds = quick ? 2 : Math.max(repeats, 5);
  const probes = quick ? 20 : 100;
  const places = [
    async () => terrainPlace('100k triangles', 100_000),
    ...levels.slice(0, quick ? 1 : undefined).map((level) => () => levelPlace(level)),
  ];
  for (const make of places) {
    const place = await make();
    const contestants: Probe[] = [];
    for (const name of PROBES) {
      const probe = await createProbe(name, place);
      if (probe) contestants.push(probe);
      else rows.add(place.name, name, 'draw and read, ms', undefined, 'not in this browser');
    }
    for (const each of contestants) await walk(each, place, 0, 10);
    for (let round = 0; round < rounds; round++) {
      for (const each of rotated(contestants, round)) {
        const times = await walk(each, place, round, probes);
        rows.add(place.name, each.name, 'draw and read, ms', quantile(times, 0.5));
        rows.add(place.name, each.name, 'draw and read, mean, ms', mean(times));
        tell(`${place.name}, ${each.name}: ${quantile(times, 0.5).toFixed(2)} ms`);
        await noteTimer(rows, place, each, round, probes);
      }
    }
    for (const each of contestants) each.dispose();
    await later();
  }
  return rows.all;
}

/** Along a line through the place, to and fro. @returns milliseconds of each probe */
async function walk(probe: Probe, place: Place, round: number, count: number): Promise<number[]> {
  const times: number[] = [];
  for (let i = 0; i < count; i++) {
    const centre = centreOf(place, round, i);
    // What was before is through, so that each is timed alone.
    await later();
    const start = performance.now();
    await probe.see(centre);
    times.push(performance.now() - start);
  }
  return times;
}

/** The GPU's own milliseconds, where it tells them. */
async function noteTimer(
  rows: Rows,
  place: Place,
  probe: Probe,
  round: number,
  count: number,
): Promise<void> {
  const figure = 'of the GPU, ms';
  const times: number[] = [];
  for (let i = 0; i < count && probe.timed !== null; i++) {
    const time = await probe.timed(centreOf(place, round, i));
    if (time !== null) times.push(time);
  }
  if (times.length > 0) rows.add(place.name, probe.name, figure, quantile(times, 0.5));
  else rows.add(place.name, probe.name, figure, undefined, 'no timer query');
}

const centre = new Vector3();

function centreOf(place: Place, round: number, i: number): Vector3 {
  centre.copy(place.start(round));
  centre.y += LEVEL;
  // Four strides either way: what is near stays near.
  centre.x += STRIDE * (Math.abs((i % 16) - 8) - 4) * 0.25;
  return centre;
}
