import type { BufferGeometry } from 'three';
import { TriangleIndex } from '../../src/collider/TriangleIndex.js';
import { verticesOf } from '../../src/collider/verticesOf.js';
import { loadOurs } from './load/loadOurs.js';
import { loadRival } from './load/loadRival.js';
import type { Loaded } from './load/Loaded.js';
import { BACKENDS, nameOf } from './ours.js';
import { later, rotated } from './pace.js';
import { fresh, SIZES, terrainPlace } from './places.js';
import { RIVALS } from './rivals.js';
import { Rows } from './Rows.js';
import type { SuiteOptions, SuiteRow } from './suite.js';

/** Meshes with fewer triangles are never indexed. */
const HUGE = 20_000;

interface Contestant {
  name: string;
  /** Of more triangles than these its figures are extrapolated. */
  most: number;
  /** Loads it anew, and lets it go. @returns null where it cannot */
  load(geometry: BufferGeometry): Promise<Loaded | null>;
}

/** What it takes from a scene that is in memory to a character's first step in it. */
export default async function load(
  { quick, repeats }: SuiteOptions,
  tell: (line: string) => void,
): Promise<SuiteRow[]> {
  const rows = new Rows();
  const rounds = quick ? 1 : Math.max(repeats, 5);
  const contestants: Contestant[] = [
    ...BACKENDS.map((backend) => ({
      name: nameOf(backend),
      most: Infinity,
      load: (geometry: BufferGeometry) => loadOurs(backend, geometry),
    })),
    ...RIVALS.map((rival) => ({
      name: rival.name,
      most: rival.most,
      load: (geometry: BufferGeometry) => loadRival(rival, geometry),
    })),
  ];
  for (const each of contestants) await each.load(terrainPlace('warm-up', 5000).geometry);

  let largest = 0;
  for (const [name, wanted] of Object.entries(SIZES).slice(0, quick ? 2 : undefined)) {
    const { geometry, triangles } = terrainPlace(name, wanted);
    for (let round = 0; round < rounds; round++) {
      for (const each of rotated(contestants, round)) {
        if (triangles > each.most) continue;
        const loaded = await each.load(fresh(geometry));
        note(rows, name, each.name, triangles, loaded);
        tell(`${name}, ${each.name}: ${loaded?.blocking.toFixed(2) ?? '-'} ms`);
        await later();
      }
    }
    if (contestants.every(({ most }) => triangles <= most)) largest = wanted;
    noteIndex(rows, name, geometry, rounds);
  }
  for (const { name, most } of contestants) extrapolate(rows, name, most, largest);
  return rows.all;
}

function note(
  rows: Rows,
  where: string,
  name: string,
  triangles: number,
  loaded: Loaded | null,
): void {
  if (loaded === null) {
    rows.add(where, name, 'blocking, ms', undefined, 'not in this browser');
    return;
  }
  rows.add(where, name, 'blocking, ms', loaded.blocking);
  rows.add(where, name, 'to the first step, ms', loaded.first);
  if (loaded.withUpload !== undefined) {
    rows.add(where, name, 'blocking with the upload, ms', loaded.withUpload);
  }
  if (loaded.waited !== undefined) {
    rows.add(where, name, 'of it waiting for the GPU, ms', loaded.waited);
  }
  const heap = loaded.heap ?? undefined;
  const untold = heap === undefined ? 'the browser does not say' : undefined;
  rows.add(where, name, 'heap, MB', heap && heap / 1e6, untold);
  rows.add(where, name, 'heap, bytes a triangle', heap && heap / triangles, untold);
}

/** Where the triangles of a huge mesh are, which the collider finds in slices while the character walks already. */
function noteIndex(rows: Rows, where: string, geometry: BufferGeometry, rounds: number): void {
  const vertices = verticesOf(geometry)!;
  if (vertices.triangles < HUGE) return;
  for (let round = 0; round < rounds; round++) {
    const start = performance.now();
    const index = new TriangleIndex(geometry, vertices);
    index.work(Infinity);
    const took = performance.now() - start;
    const name = 'three-cube-collider';
    rows.add(where, name, 'found later in slices, ms', took);
    rows.add(where, name, 'index, bytes a triangle', index.bytes / vertices.triangles);
  }
}

/** Of what would take too long, by the triangles. */
function extrapolate(rows: Rows, name: string, most: number, largest: number): void {
  if (most === Infinity || largest === 0) return;
  const from = Object.keys(SIZES).find((size) => SIZES[size] === largest)!;
  const known = rows.all.filter((row) => row.case === from && row.contestant === name);
  const cases = new Set(rows.all.map((row) => row.case));
  for (const [size, triangles] of Object.entries(SIZES)) {
    if (triangles <= largest || !cases.has(size)) continue;
    for (const { figure, samples } of known) {
      const factor = figure === 'heap, bytes a triangle' ? 1 : triangles / largest;
      for (const sample of samples) {
        rows.add(size, name, figure, factor * sample, `extrapolated from ${from}`);
      }
    }
  }
}
