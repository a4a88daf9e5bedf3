// @ts-check
// Suites of figures: `npm run bench -- size [--only part] [--seconds 60] [--markdown docs/size.md] [--json file]`. Each
// prints its tables, and can write them between its marks, <!-- size:begin --> and <!-- size:end -->.
import { writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { main } from '../scripts/run.mjs';
import { writeBetweenMarks } from './walk/table.mjs';

/** @type {Record<string, () => Promise<{ default: (options: Record<string, string>) => Promise<{ text: string, results: unknown }> }>>} */
const SUITES = { size: () => import('./size/suite.mjs') };

await main(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      only: { type: 'string', default: '' },
      seconds: { type: 'string', default: '60' },
      markdown: { type: 'string' },
      json: { type: 'string' },
    },
  });
  if (positionals.length === 0) throw new Error(`Which of ${Object.keys(SUITES).join(', ')}?`);
  for (const name of positionals) {
    const load = SUITES[name];
    if (!load) throw new Error(`There is no suite ${name}, but ${Object.keys(SUITES).join(', ')}.`);
    const { default: suite } = await load();
    const { text, results } = await suite({ only: values.only, seconds: values.seconds });
    console.log(text);
    if (values.json) writeFileSync(values.json, JSON.stringify(results));
    if (values.markdown) await writeBetweenMarks(values.markdown, name, text);
  }
});
