// @ts-check
import * as vega from 'vega';
import * as vegaLite from 'vega-lite';
import { figuresOf, isOurs, median, show, spread } from './figures.mjs';

/** Above this ratio of the longest to the shortest, bars are told apart only by their logarithm. */
const LOGARITHMIC = 30;
/** Okabe and Ito's, told apart by the colour-blind. */
const [OURS, OTHERS] = ['#0072B2', '#B8BEC4'];

/**
 * Bars of one figure, a panel for each case: medians, with a line over most samples.
 *
 * @param {string} title
 * @param {readonly import('../suites/suite.js').SuiteRow[]} rows
 * @param {string} [figure] the first, if not given
 * @returns {Promise<string>} an SVG file
 */
export async function drawBars(title, rows, figure) {
  const all = figuresOf(rows);
  const shown = all.find((each) => each.figure === figure) ?? all[0];
  if (shown === undefined) throw new Error(`Nothing to draw for "${title}": no rows.`);
  const values = shown.rows.flatMap((row) => {
    if (row.samples.length === 0) return [];
    const [low, high] = spread(row.samples);
    const value = median(row.samples);
    const name = { case: row.case, contestant: row.contestant };
    return [{ ...name, value, low, high, end: Math.max(high, 0), label: show(value) }];
  });
  const ends = values.map(({ value }) => value);
  const [least, most] = [Math.min(...ends), Math.max(...ends)];
  const logarithmic = least > 0 && most / least > LOGARITHMIC;
  // A bar on a logarithmic axis begins somewhere: at the power of ten below all.
  const begin = logarithmic ? 10 ** Math.floor(Math.log10(least * 0.8)) : 0;
  const scale = logarithmic ? { type: 'log', domainMin: begin, nice: false } : { zero: true };
  /** @type {any} */
  const y = {
    field: 'contestant',
    type: 'nominal',
    sort: shown.contestants,
    title: null,
    axis: { domain: false, ticks: false, labelPadding: 6 },
  };
  // In thousands from a thousand on, but never in thousandths.
  const labelExpr = "format(datum.value, abs(datum.value) < 1000 ? '~g' : '~s')";
  const axis = logarithmic
    ? { labelExpr, values: powers(begin, most) }
    : { labelExpr, tickCount: 6 };
  const repeated = shown.rows.some(({ samples }) => samples.length > 1);
  const notes = [
    shown.figure,
    ...(logarithmic ? ['a logarithmic axis'] : []),
    ...(repeated ? ['lines span most repeats'] : []),
  ];
  /** @type {any} */
  const spec = {
    background: 'white',
    padding: 12,
    title: {
      text: title,
      subtitle: notes.join('; '),
      anchor: 'start',
      fontSize: 15,
      subtitleFontSize: 12,
      offset: 14,
    },
    data: { values },
    facet: {
      row: {
        field: 'case',
        sort: shown.cases,
        title: null,
        header: {
          labelAngle: 0,
          labelAlign: 'left',
          labelOrient: 'top',
          labelAnchor: 'start',
          labelPadding: 4,
          labelFontSize: 12,
          labelFontWeight: 600,
        },
      },
    },
    // Only those who take part in a case.
    resolve: { scale: { y: 'independent' } },
    spacing: 14,
    spec: {
      width: 460,
      height: { step: 17 },
      layer: [
        {
          mark: { type: 'bar', height: 11 },
          encoding: {
            y,
            x: { field: 'value', type: 'quantitative', title: shown.figure, scale, axis },
            x2: { datum: begin },
            color: {
              field: 'contestant',
              type: 'nominal',
              scale: {
                domain: shown.contestants,
                range: shown.contestants.map((name) => (isOurs(name) ? OURS : OTHERS)),
              },
              legend: null,
            },
          },
        },
        {
          mark: { type: 'rule', color: '#222', strokeWidth: 1.2 },
          encoding: {
            y,
            x: { field: 'low', type: 'quantitative' },
            x2: { field: 'high' },
          },
        },
        {
          mark: { type: 'text', align: 'left', dx: 5, fontSize: 10, color: '#444' },
          encoding: { y, x: { field: 'end', type: 'quantitative' }, text: { field: 'label' } },
        },
      ],
    },
    config: {
      font: 'system-ui, sans-serif',
      axis: { gridOpacity: 0.6, labelFontSize: 11, labelLimit: 600 },
    },
  };
  // Its warning is of two layers with one axis, which here are of the same data.
  const { spec: compiled } = vegaLite.compile(spec, { logger: vega.logger(vega.Error) });
  const view = new vega.View(vega.parse(compiled), { renderer: 'none' });
  return `${await view.toSVG()}\n`;
}

/** Those of ten from the first on. @param {number} first @param {number} most */
function powers(first, most) {
  const count = Math.floor(Math.log10(most / first)) + 1;
  return Array.from({ length: count }, (_, i) => Number((first * 10 ** i).toPrecision(6)));
}
