// @ts-check
import { readFileSync, writeFileSync } from 'node:fs';
import { format, resolveConfig } from 'prettier';

/** @type {Record<string, string>} what each mover is called in tables */
export const NAMES = {
  cube: 'three-cube-collider',
  'mesh-bvh': 'three-mesh-bvh (characterMovement)',
  octree: 'Octree (games_fps)',
  rapier: 'Rapier KinematicCharacterController',
};

/** @typedef {Record<string, any>} Row a `WalkCase` with what came of it */

/** @param {number | undefined} value */
const fixed = (value, digits = 0) => (Number.isFinite(value) ? value?.toFixed(digits) : '-');
/** @param {number} metres */
const millimetres = (metres) => fixed(1000 * metres, 1);

/** What a walk's mover is called. @param {Row} row */
export const nameOf = ({ mover, backend = 'WebGL2' }) =>
  backend === 'WebGL2' || mover !== 'cube' ? NAMES[mover] : `${NAMES[mover]}, ${backend}`;

/** @type {[string, (row: Row, level: { rows: Row[] }) => unknown][]} heading and cell of each column */
const COLUMNS = [
  ['mover', nameOf],
  ['Hz', (row) => row.hz],
  ['late', (row) => (row.mover === 'cube' ? lateness(row.latency) : '')],
  ['penetration p50, mm', (row) => millimetres(row.penetration.p50)],
  ['p99', (row) => millimetres(row.penetration.p99)],
  ['max', (row) => millimetres(row.penetration.max)],
  ['crossed', (row) => row.crossed],
  ['fell through', (row) => row.fellThrough],
  ['off the edge', (row) => row.fellOff],
  ['NaN', (row) => row.nan],
  ['walked, m', (row) => fixed(row.distance)],
  ['of BVH’s', (row, level) => percent(share(row, level), 1)],
  ['held', (row) => percent(row.counts.held, row.counts.steps)],
  ['slowed', (row) => percent(row.counts.slowed, row.counts.steps)],
  [
    'first field, frames a leg',
    (row) => (row.mover === 'cube' ? fixed(row.waits / row.legs, 1) : '-'),
  ],
  ['draws a frame', (row) => fixed(row.counts.draws / row.frames, 2)],
  [
    'JS, ms a frame: p50 (mean)',
    ({ milliseconds: js }) => `${fixed(js.p50, 2)} (${fixed(js.mean, 2)})`,
  ],
  ['prepared in, ms', (row) => fixed(row.preparation)],
  ['gap at rest, mm', (row) => range(row.rest.gaps)],
  ['drift at rest, mm', (row) => fixed(1000 * row.rest.drift, 2)],
];

/** @type {[string, (rows: Row[], level: { rows: Row[] }) => unknown][]} of all walks of a mover: the worst, a line each */
const WORST = [
  ['penetration p99, mm', (rows) => millimetres(most(rows, (row) => row.penetration.p99))],
  ['max, mm', (rows) => millimetres(most(rows, (row) => row.penetration.max))],
  ['crossed', (rows) => sum(rows, (row) => row.crossed)],
  ['fell through', (rows) => sum(rows, (row) => row.fellThrough)],
  ['NaN', (rows) => sum(rows, (row) => row.nan)],
  ['of BVH’s way', (rows, level) => percent(-most(rows, (row) => -share(row, level)), 1)],
  ['held or slowed', (rows) => percent(most(rows, waited), 1)],
  ['gap at rest, mm', (rows) => range(rows.flatMap((row) => row.rest.gaps))],
  ['drift at rest, mm', (rows) => fixed(1000 * most(rows, (row) => row.rest.drift), 2)],
];

/**
 * Two tables a level: the worst of each mover, a column each, then every walk, a line each.
 *
 * @param {{ machine: string, versions: Record<string, string>, seed: number, levels: any[] }} results
 */
export function tables(results) {
  const made = Object.entries(results.versions).map(([name, version]) => `${name} ${version}`);
  const lines = [`${results.machine}. ${made.join(', ')}. Seed ${results.seed}.`];
  for (const level of results.levels) {
    lines.push('', `**${level.name}**, ${level.triangles} triangles, ${frames(level.rows)}:`, '');
    const names = new Set(
      Object.keys(NAMES).flatMap((mover) => level.rows.filter(isMover(mover)).map(nameOf)),
    );
    const worst = [...names].map((name) =>
      level.rows.filter((/** @type {Row} */ row) => nameOf(row) === name),
    );
    lines.push(...columns(WORST, [...names], worst, level));
    lines.push('', ...table(COLUMNS, level.rows, level));
  }
  return lines.join('\n');
}

/**
 * @template T
 * @param {[string, (item: T, level: any) => unknown][]} columns
 * @param {T[]} items
 * @param {any} level
 */
function table(columns, items, level) {
  return [
    `| ${columns.map(([name]) => name).join(' | ')} |`,
    `| ${columns.map((_, i) => (i === 0 ? '---' : '--:')).join(' | ')} |`,
    ...items.map((item) => `| ${columns.map(([, cell]) => cell(item, level)).join(' | ')} |`),
  ];
}

/**
 * @param {[string, (rows: Row[], level: any) => unknown][]} lines
 * @param {string[]} names a column each
 * @param {Row[][]} walks of each
 * @param {any} level
 */
function columns(lines, names, walks, level) {
  return [
    `| worst of all its walks | ${names.join(' | ')} |`,
    `| --- | ${names.map(() => '--:').join(' | ')} |`,
    ...lines.map(
      ([name, cell]) => `| ${name} | ${walks.map((rows) => cell(rows, level)).join(' | ')} |`,
    ),
  ];
}

/** @param {string} name */
const isMover = (name) => (/** @type {Row} */ row) => row.mover === name;
/** @param {Row[]} rows @param {(row: Row) => number} of */
const most = (rows, of) => Math.max(...rows.map(of));
/** @param {Row[]} rows @param {(row: Row) => number} of */
const sum = (rows, of) => rows.reduce((total, row) => total + of(row), 0);
/** Held or slowed, as a part of the steps. @param {Row} row */
const waited = ({ counts }) => ((counts.held ?? 0) + (counts.slowed ?? 0)) / (counts.steps ?? 1);
/** Its way, as a part of that of three-mesh-bvh's. @param {Row} row @param {{ rows: Row[] }} level */
const share = (row, level) => row.distance / (rivalOf(row, level)?.distance ?? NaN);

/** @param {number | 'real'} latency frames */
export const lateness = (latency) =>
  latency === 'real' ? 'async' : latency === 0 ? 'sync' : String(latency);

/** @param {Row[]} rows */
function frames(rows) {
  const counts = [...new Set(rows.map((row) => row.frames))];
  return `${counts.join(' or ')} frames a walk`;
}

/** The walk of three-mesh-bvh's controller on the same inputs. @param {Row} row @param {{ rows: Row[] }} level */
function rivalOf({ hz, frames }, { rows }) {
  return rows.find((row) => row.mover === 'mesh-bvh' && row.hz === hz && row.frames === frames);
}

/** @param {number | undefined} part @param {number | undefined} whole */
function percent(part, whole) {
  return !Number.isFinite(part) || part === undefined || !whole
    ? '-'
    : `${fixed((100 * part) / whole, 1)} %`;
}

/** @param {number[]} gaps metres */
function range(gaps) {
  if (gaps.length === 0) return '-';
  return `${millimetres(Math.min(...gaps))} to ${millimetres(Math.max(...gaps))}`;
}

/**
 * Puts text into a file between the marks `<!-- name:begin -->` and `<!-- name:end -->`.
 *
 * @param {string} file
 * @param {string} name
 * @param {string} text
 */
export async function writeBetweenMarks(file, name, text) {
  const page = readFileSync(file, 'utf8');
  const [begin, end] = [`<!-- ${name}:begin -->`, `<!-- ${name}:end -->`];
  const from = page.indexOf(begin);
  const to = page.indexOf(end);
  if (from < 0 || to < from) throw new Error(`${file} has no marks ${begin} and ${end}.`);
  const whole = `${page.slice(0, from + begin.length)}\n\n${text}\n\n${page.slice(to)}`;
  const style = await resolveConfig(file);
  writeFileSync(file, await format(whole, { ...style, filepath: file }));
}
