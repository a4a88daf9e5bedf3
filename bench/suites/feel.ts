import { Vector3 } from 'three';
import type { Backend } from '../../e2e/support/rendering.js';
import { CubeWalker } from '../walk/CubeWalker.js';
import type { Walker } from '../rivals/Walker.js';
import { type FeelCase, feelCases } from './feel/scenes.js';
import { BACKENDS, disposeRendering, nameOf, tryRendering } from './ours.js';
import { FRAME, later, rotated } from './pace.js';
import { RIVALS } from './rivals.js';
import { Rows } from './Rows.js';
import type { SuiteOptions, SuiteRow } from './suite.js';

/** Above the floor where it is put, and seconds to come to rest there. */
const DROP = 0.05;
const REST = 0.5;
/** Seconds that it stands at the end, of which the second half counts. */
const STAND = 2;
/** Each repeat begins a little elsewhere, metres: between two frames of a walk. */
const SHIFT = 0.0137;

const STILL = new Vector3();

interface Contestant {
  name: string;
  walker: Walker;
  /** Awaited after each frame. */
  between(): Promise<void>;
}

/** How smoothly a body walks stairs, slopes and kerbs, slides along walls and stands. */
export default async function feel(
  { quick, repeats }: SuiteOptions,
  tell: (line: string) => void,
): Promise<SuiteRow[]> {
  const rows = new Rows();
  const rounds = quick ? 2 : Math.max(repeats, 5);
  const backends = new Set<Backend>();
  for (const backend of BACKENDS) {
    const rendering = await tryRendering(backend);
    if (rendering === null) continue;
    backends.add(backend);
    disposeRendering(rendering);
  }
  for (const test of feelCases()) {
    const contestants = await gather(test, backends, rows);
    // The first walk compiles what a walk compiles.
    for (const each of contestants) await walk(each, test, 0, new Rows());
    for (let round = 0; round < rounds; round++) {
      for (const each of rotated(contestants, round)) await walk(each, test, round, rows);
    }
    for (const { walker } of contestants) walker.dispose();
    tell(test.name);
    await later();
  }
  return rows.all;
}

async function gather(test: FeelCase, backends: Set<Backend>, rows: Rows): Promise<Contestant[]> {
  const found: Contestant[] = [];
  for (const backend of BACKENDS) {
    if (!backends.has(backend)) {
      rows.add(test.name, nameOf(backend), 'progress, %', undefined, 'not in this browser');
      continue;
    }
    // Each field a frame late, as where the GPU has the time; to the frame the same in every run.
    const walker = await CubeWalker.create(test.scene, { latency: 1, backend });
    found.push({ name: nameOf(backend), walker, between: () => walker.between() });
  }
  for (const rival of RIVALS) {
    const walker = await rival.create(test.geometry);
    found.push({ name: rival.name, walker, between: async () => {} });
  }
  return found;
}

async function walk(
  { name, walker, between }: Contestant,
  test: FeelCase,
  round: number,
  rows: Rows,
): Promise<void> {
  const { foot } = walker;
  const live = async (velocity: Vector3, seconds: number, note: () => void = () => {}) => {
    for (let i = 0; i < Math.round(seconds / FRAME); i++) {
      walker.frame(velocity, false, FRAME);
      note();
      await between();
    }
  };
  const from = test.from.clone().addScaledVector(test.along, SHIFT * round);
  from.y += DROP;
  walker.place(from);
  await live(STILL, REST);

  const begin = foot.clone();
  const heights = [foot.y];
  await live(test.velocity, test.seconds, () => heights.push(foot.y));
  const made = foot.clone().sub(begin).dot(test.along);
  rows.add(test.name, name, 'progress, %', (100 * made) / test.ideal);
  rows.add(test.name, name, 'vertical jerk, m/s³', jerk(heights));

  const stood: Vector3[] = [];
  await live(STILL, STAND / 2);
  await live(STILL, STAND / 2, () => stood.push(foot.clone()));
  rows.add(test.name, name, 'wobble, mm', 1000 * spread(stood));
}

/** Root mean square of the third difference of heights, m/s³. */
function jerk(heights: number[]): number {
  let sum = 0;
  for (let i = 3; i < heights.length; i++) {
    const third = heights[i]! - 3 * heights[i - 1]! + 3 * heights[i - 2]! - heights[i - 3]!;
    sum += (third / FRAME ** 3) ** 2;
  }
  return Math.sqrt(sum / (heights.length - 3));
}

/** Farthest that two places are apart along an axis, metres. */
function spread(places: Vector3[]): number {
  const least = places[0]!.clone();
  const most = places[0]!.clone();
  for (const place of places) {
    least.min(place);
    most.max(place);
  }
  const { x, y, z } = most.sub(least);
  return Math.max(x, y, z);
}
