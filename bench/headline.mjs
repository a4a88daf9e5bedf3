// @ts-check
import { median, show } from './report/figures.mjs';

/** @typedef {import('./report/results.mjs').Results} Results */
/** @typedef {import('./suites/suite.js').SuiteRow} SuiteRow */

const OURS = 'three-cube-collider, WebGL2';

/**
 * README's figures, a line each, from the results of `npm run bench`; without what has not been measured.
 *
 * @param {Results} results
 * @returns {string} a list in Markdown
 */
export function headline(results) {
  const lines = [loading, stepping, walking, crowd, bundle].map((line) => line(results));
  return lines.filter((line) => line !== '').join('\n');
}

/** @param {Results} results */
function loading(results) {
  const at = (/** @type {string} */ contestant) =>
    find(results, 'load', { of: '1M triangles', contestant, figure: 'blocking, ms' });
  return line('Loading 1M triangles blocks the page for', 'ms', [
    ['', at(OURS)],
    ['three-mesh-bvh', at('three-mesh-bvh')],
    ['Octree', at('Octree')],
  ]);
}

/** @param {Results} results */
function stepping(results) {
  const at = (/** @type {string} */ contestant) =>
    find(results, 'step', { of: 'level.glb', contestant, figure: 'a step, mean, ms' });
  return line('A character on the demo’s level takes, of the main thread a step,', 'ms', [
    ['', at(OURS)],
    ['(on WebGPU)', at('three-cube-collider, WebGPU')],
    ['Rapier', at('Rapier')],
    ['three-mesh-bvh', at('three-mesh-bvh')],
  ]);
}

/** The worst of all walks. @param {Results} results */
function walking(results) {
  const rows = results.suites.walk?.rows ?? [];
  const worst = (/** @type {string} */ contestant, /** @type {string} */ figure) =>
    Math.max(
      ...rows
        .filter((row) => row.contestant === contestant && row.figure === figure)
        .flatMap(({ samples }) => samples),
    );
  const both = (/** @type {string} */ contestant) =>
    ['penetration p99, mm', 'penetration max, mm']
      .map((figure) => worst(contestant, figure))
      .map((depth) => depth.toFixed(1))
      .join(' / ');
  const names = [OURS, 'three-mesh-bvh', 'Octree', 'Rapier'].filter((name) =>
    rows.some(({ contestant }) => contestant === name),
  );
  if (!names.includes(OURS)) return '';
  const told = names.map((name) => (name === OURS ? both(name) : `${name} ${both(name)}`));
  return `- Deepest that its body gets into a level, the worst of all walks, p99 / max, mm (negative: a gap): ${told.join('; ')}.`;
}

/** @param {Results} results */
function crowd(results) {
  const at = (/** @type {string} */ contestant) =>
    find(results, 'moving', { of: 'skinned crowd, 100k', contestant, figure: 'a frame, ms' });
  return line('Among a skinned crowd of 100k triangles a frame takes, of the main thread,', 'ms', [
    ['', at(OURS)],
    ['three-mesh-bvh, refitted,', at('three-mesh-bvh')],
    ['refitted near the character only', at('three-mesh-bvh, near ones only')],
  ]);
}

/** @param {Results} results */
function bundle(results) {
  const at = (/** @type {string} */ contestant) =>
    find(results, 'bundle', { of: 'gzipped', contestant, figure: 'shipped, kB' });
  return line('Collider and character ship', 'kB, gzipped', [
    ['', at('three-cube-collider: CubeCollider, CharacterController')],
    ['Octree', at('Octree and Capsule')],
    ['three-mesh-bvh', at('three-mesh-bvh: MeshBVH, StaticGeometryGenerator')],
    ['Rapier', at('Rapier, compat (WASM within)')],
  ]);
}

/**
 * The row of that contestant and figure whose case begins so; undefined if nobody measured it, or it could not take part.
 *
 * @param {Results} results
 * @param {string} suite
 * @param {{ of: string, contestant: string, figure: string }} wanted
 */
function find(results, suite, { of, contestant, figure }) {
  const row = results.suites[suite]?.rows.find(
    (each) => each.case.startsWith(of) && each.contestant === contestant && each.figure === figure,
  );
  return row && row.samples.length > 0 ? row : undefined;
}

/**
 * Ours first, the others with how many times ours they are.
 *
 * @param {string} what
 * @param {string} unit
 * @param {[name: string, row: SuiteRow | undefined][]} rows
 * @returns {string} empty if ours is missing
 */
function line(what, unit, [[, ours], ...others]) {
  if (ours === undefined) return '';
  const own = median(ours.samples);
  const words = others.flatMap(([name, row]) => {
    if (row === undefined) return [];
    const value = median(row.samples);
    return [`${name} ${show(value)} (×${show(value / own)}${row.note ? `, ${row.note}` : ''})`];
  });
  return `- ${what} **${show(own)} ${unit}**${words.map((word) => `; ${word}`).join('')}.`;
}
