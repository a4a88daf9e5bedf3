// @ts-check
// Walks levels with the character and its rivals, judges every step: `npm run walk -- --help`; results in
// docs/accuracy.md.
import { readFileSync, writeFileSync } from 'node:fs';
import { main } from '../../scripts/run.mjs';
import { drawChart } from './chart.mjs';
import { readOptions } from './options.mjs';
import { tables, writeBetweenMarks } from './table.mjs';
import { walkAll } from './walkAll.mjs';

/** Of runs on one machine, one after the other or side by side. @param {string[]} files */
function readResults(files) {
  const [first, ...others] = files.map((file) => JSON.parse(readFileSync(file, 'utf8')));
  for (const level of others.flatMap(({ levels }) => levels)) {
    const same = first.levels.find((/** @type {any} */ { name }) => name === level.name);
    if (same) same.rows.push(...level.rows);
    else first.levels.push(level);
  }
  for (const { rows } of first.levels) {
    rows.sort((/** @type {any} */ a, /** @type {any} */ b) => a.hz - b.hz || b.frames - a.frames);
  }
  return first;
}

await main(async () => {
  const options = readOptions();
  if (options.trace) {
    writeFileSync(options.trace, 'level,mover,hz,late,frame,x,y,z,grounded,penetration\n');
  }
  const results = options.from ? readResults(options.from) : await walkAll(options);
  const movers = options.only?.split(',');
  for (const level of movers === undefined ? [] : results.levels) {
    level.rows = level.rows.filter((/** @type {any} */ { mover }) => movers?.includes(mover));
  }
  const text = tables(results);
  console.log(text);
  if (options.markdown) await writeBetweenMarks(options.markdown, options.marks, text);
  if (options.chart) writeFileSync(options.chart, await drawChart(results));
});
