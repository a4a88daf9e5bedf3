// @ts-check
import * as vega from 'vega';
import * as vegaLite from 'vega-lite';
import { lateness } from './table.mjs';

/** Millimetres shown; deeper gaps are all alike. */
const RANGE = [-25, 400];
const TICKS = [-20, -5, -1, 0, 1, 5, 20, 100, 350];
/**
 * Okabe and Ito's colours, told apart by the colour-blind.
 *
 * @type {Record<string, { color: string, dash: number[], width: number }>}
 */
const STYLES = {
  'three-cube-collider, sync': { color: '#0072B2', dash: [1, 0], width: 2.5 },
  'three-cube-collider, 3 frames late': { color: '#0072B2', dash: [5, 3], width: 2 },
  'three-mesh-bvh': { color: '#D55E00', dash: [1, 0], width: 1.5 },
  Octree: { color: '#CC79A7', dash: [1, 0], width: 1.5 },
  Rapier: { color: '#009E73', dash: [1, 0], width: 1.5 },
};
/** @type {Record<string, string>} by lateness */
const OURS = { sync: 'three-cube-collider, sync', 3: 'three-cube-collider, 3 frames late' };
/** @type {Record<string, string>} */
const RIVALS = { 'mesh-bvh': 'three-mesh-bvh', octree: 'Octree', rapier: 'Rapier' };

/**
 * The distributions of the penetrations, a panel for each level and frame rate: what part of the frames was deeper.
 *
 * @param {{ levels: any[] }} results
 * @returns {Promise<string>} an SVG file
 */
export async function drawChart(results) {
  const rows = results.levels.flatMap((level) => level.rows.flatMap(linesOf(level.name)));
  if (rows.length === 0) throw new Error('Nothing to draw: no walk of 20 or 60 Hz.');
  const names = Object.keys(STYLES).filter((name) => rows.some((row) => row.mover === name));
  const styles = names.map((name) => STYLES[name]);
  // The same for colour, dash and width, which makes one legend of three.
  const legend = {
    title: null,
    orient: 'bottom',
    columns: names.length,
    labelLimit: 400,
    symbolType: 'stroke',
    symbolSize: 400,
  };
  /** @type {any} */
  const spec = {
    background: 'white',
    padding: 12,
    title: {
      text: 'How deep the capsule got into the level',
      subtitle:
        'Part of all frames that was at least so deep; left of 0 is a gap. Lower and further left is better.',
      anchor: 'start',
      fontSize: 15,
      subtitleFontSize: 12,
      offset: 14,
    },
    data: { values: rows },
    facet: {
      column: {
        field: 'level',
        sort: null,
        title: null,
        header: { labelFontSize: 13, labelFontWeight: 600 },
      },
      row: {
        field: 'rate',
        sort: null,
        title: null,
        header: { labelFontSize: 13, labelFontWeight: 600 },
      },
    },
    spec: {
      width: 380,
      height: 230,
      layer: [
        {
          mark: { type: 'rule', color: '#888' },
          encoding: { x: { datum: 0, type: 'quantitative' } },
        },
        {
          mark: { type: 'line', interpolate: 'step-after', clip: true },
          encoding: {
            x: {
              field: 'depth',
              type: 'quantitative',
              title: 'penetration, mm',
              scale: { type: 'symlog', constant: 1, domain: RANGE, nice: false },
              axis: { values: TICKS, format: 'd' },
            },
            y: {
              field: 'part',
              type: 'quantitative',
              title: 'part of the frames',
              scale: { type: 'log', domain: [5e-5, 1] },
              axis: { values: [1e-4, 1e-3, 1e-2, 1e-1, 1], format: '~p' },
            },
            order: { field: 'order' },
            color: {
              field: 'mover',
              sort: names,
              scale: { domain: names, range: styles.map(({ color }) => color) },
              legend,
            },
            strokeDash: {
              field: 'mover',
              sort: names,
              scale: { domain: names, range: styles.map(({ dash }) => dash) },
              legend,
            },
            strokeWidth: {
              field: 'mover',
              sort: names,
              scale: { domain: names, range: styles.map(({ width }) => width) },
              legend,
            },
          },
        },
      ],
    },
    config: {
      font: 'system-ui, sans-serif',
      axis: { gridOpacity: 0.6, labelFontSize: 11 },
    },
  };
  const view = new vega.View(vega.parse(vegaLite.compile(spec).spec), { renderer: 'none' });
  return `${await view.toSVG()}\n`;
}

/** @param {string} level */
function linesOf(level) {
  /** @param {any} row */
  return (row) => {
    const late = lateness(row.latency);
    const mover = row.mover !== 'cube' ? RIVALS[row.mover] : OURS[late];
    if (mover === undefined || ![20, 60].includes(row.hz)) return [];
    return row.penetration.tail.map(
      (/** @type {number[]} */ [depth, part], /** @type {number} */ order) => ({
        level,
        rate: `${row.hz} Hz`,
        mover,
        depth: Math.max(RANGE[0], 1000 * depth),
        part,
        order,
      }),
    );
  };
}
