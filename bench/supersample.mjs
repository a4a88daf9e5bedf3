// What a finer draw costs: `npm run bench:supersample [-- --rounds 300 --json file]`. Reproduces the table in
// docs/architecture.md, "Thin things", with the product's own code.
import { writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { openPage, quantile, show } from './page.mjs';

const { values } = parseArgs({
  options: { rounds: { type: 'string', default: '300' }, json: { type: 'string' } },
});
const { run, machine, close } = await openPage();
const results = await run('/bench/supersample.ts', { rounds: Number(values.rounds) });
console.log(`${machine}; public/level.glb, ${values.rounds} places`);
console.log('\n| `resolution` | `supersample` | update, ms: median (p95) | times the first |');
console.log('| --- | --- | --- | --- |');
for (const { resolution, supersample, times } of results) {
  const median = quantile(times, 0.5);
  console.log(
    `| ${resolution} | ${supersample} | ${show(median)} (${show(quantile(times, 0.95))}) ` +
      `| ${show(median / quantile(results[0].times, 0.5))} |`,
  );
}
if (values.json) writeFileSync(values.json, JSON.stringify(results));
await close();
