import type { BufferGeometry } from 'three';
import { TriangleIndex } from '../../src/collider/TriangleIndex.js';
import { verticesOf } from '../../src/collider/verticesOf.js';
import { loadOurs, weighOurs } from './load/loadOurs.js';
import { loadRival, weighRival } from './load/loadRival.js';
import type { Loaded } from './load/Loaded.js';
import { BACKENDS, nameOf } from './ours.js';
import { later, rotated } from './pace.js';
import { fresh, SIZES, terrainPlace } from './places.js';
import { RIVALS } from './rivals.js';
import { Rows } from './Rows.js';
import type { SuiteOptions, SuiteRow } from './suite.js';

/** Meshes with fewer triangles are never indexed. */
const HUGE = 512;

interface Contestant {
  name: string;
  /** Of more triangles than these its figures are extrapolated. */
  most: number;
  /** Loads it anew, and lets it go. @returns null where it cannot */
  load(geometry: BufferGeometry): Promise<Loaded | null>;
  /** Bytes that it keeps; null where nobody says. Collecting garbage slows what follows, so it is done apart. */
  weigh(geometry: BufferGeometry): Promise<number | null>;
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
      weigh: (geometry: BufferGeometry) => weighOurs(backend, geometry),
    })),
    ...RIVALS.map((rival) => ({
      name: rival.name,
      most: rival.most,
      load: (geometry: BufferGeometry) => loadRival(rival, geometry),
      weigh: (geometry: BufferGeometry) => weighRival(rival, geometry),
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
        note(rows, name, each.name, loaded);
        tell(`${name}, ${each.name}: ${loaded?.blocking.toFixed(2) ?? '-'} ms`);
        await later();
      }
    }
    for (const backend of BACKENDS) {
      const undrawn = await loadOurs(backend, fresh(geometry), false);
      rows.add(name, nameOf(backend), 'blocking with the upload, ms', undrawn?.blocking);
    }
    for (const each of contestants) {
      if (triangles > each.most) continue;
      noteHeap(rows, name, each.name, triangles, await each.weigh(fresh(geometry)));
    }
    if (contestants.every(({ most }) => triangles <= most)) largest = wanted;
    noteIndex(rows, name, geometry, rounds);
  }
  for (const { name, most } of contestants) extrapolate(rows, name, most, largest);
  return rows.all;
}

function note(rows: Rows, where: string, name: string, loaded: Loaded | null): void {
  if (loaded === null) {
    rows.add(where, name, 'blocking, ms', undefined, 'not in this browser');
    return;
  }
  rows.add(where, name, 'blocking, ms', loaded.blocking);
  rows.add(where, name, 'blocking at a stretch, ms', loaded.longest);
  rows.add(where, name, 'to the first step, ms', loaded.first);
  if (loaded.waited !== undefined) {
    rows.add(where, name, 'of it waiting for the GPU, ms', loaded.waited);
  }
}

function noteHeap(
  rows: Rows,
  where: string,
  name: string,
  triangles: number,
  heap: number | null,
): void {
  const told = heap ?? undefined;
  const untold = heap === null ? 'the browser does not say' : undefined;
  rows.add(where, name, 'heap, MB', told && told / 1e6, untold);
  rows.add(where, name, 'heap, bytes a triangle', told && told / triangles, untold);
}

/** Where the triangles of a large mesh are, which the collider finds in slices. */
function noteIndex(rows: Rows, where: string, geometry: BufferGeometry, rounds: number): void {
  const vertices = verticesOf(geometry)!;
  if (vertices.triangles < HUGE) return;
  for (let round = 0; round < rounds; round++) {
    const start = performance.now();
    const index = new TriangleIndex(geometry, vertices);
    index.work(Infinity);
    const took = performance.now() - start;
    const name = 'three-cube-collider';
    rows.add(where, name, 'found in slices, ms', took);
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
