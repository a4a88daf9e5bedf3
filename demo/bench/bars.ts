import {
  figuresOf,
  isOurs,
  median,
  referenceOf,
  spread,
  told,
} from '../../bench/report/figures.mjs';
import type { SuiteRow } from '../../bench/suites/suite.js';

/** Above this ratio of the longest to the shortest, bars are told apart only by their logarithm. */
const LOGARITHMIC = 30;

/** Bars of every figure, each to unfold, the first unfolded. */
export function barsOf(rows: readonly SuiteRow[]): HTMLElement[] {
  return figuresOf(rows).map(({ figure, cases, contestants, rows: own, rowOf }, i) => {
    const place = scaleOf(own);
    const panel = create('details');
    panel.open = i === 0;
    panel.append(create('summary', '', figure));
    for (const name of cases) {
      const reference = referenceOf(own, name);
      panel.append(create('h3', '', name));
      for (const contestant of contestants) {
        const row = rowOf(name, contestant);
        if (row) panel.append(barOf(row, told(row, reference), place));
      }
    }
    return panel;
  });
}

/** One contestant in one case. */
function barOf(row: SuiteRow, value: string, place: (value: number) => number): HTMLElement {
  const line = create('div', isOurs(row.contestant) ? 'contestant ours' : 'contestant');
  const name = create('span', 'name', row.contestant);
  const track = create('span', 'track');
  if (row.samples.length > 0) {
    const bar = create('span', 'median');
    bar.style.width = percent(place(median(row.samples)));
    const [low, high] = spread(row.samples).map(place) as [number, number];
    const line = create('span', 'spread');
    line.style.left = percent(low);
    line.style.width = percent(high - low);
    track.append(bar, line);
  }
  line.append(name, track, create('span', 'value', value));
  return line;
}

/** From values to parts of the track. */
function scaleOf(rows: readonly SuiteRow[]): (value: number) => number {
  const ends = rows.flatMap(({ samples }) =>
    samples.length > 0 ? [median(samples), ...spread(samples)] : [],
  );
  const [least, most] = [Math.min(...ends), Math.max(...ends)];
  const within = (part: number) => Math.min(1, Math.max(0, part));
  if (least <= 0 || most / least < LOGARITHMIC) return (value) => within(value / most);
  // The shortest still shows.
  const begin = Math.log(least / 2);
  return (value) => within((Math.log(value) - begin) / (Math.log(most) - begin));
}

const percent = (part: number) => `${(100 * part).toFixed(2)}%`;

/** An element with a class and text in it. */
export function create<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  className = '',
  text = '',
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  if (className) made.className = className;
  made.textContent = text;
  return made;
}
