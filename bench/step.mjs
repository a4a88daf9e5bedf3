// @ts-check
// What a step costs in JavaScript, and taking a new field in: `npm run bench:step [-- --seconds 20 --only stairs
// --cold --markdown docs/architecture.md]`. In Node, with the product's own code on fields of 6 x 32 x 32 texels; reproduces the table in docs/architecture.md.
import { mkdtempSync, rmSync } from 'node:fs';
import { arch, cpus, platform } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { build } from 'vite';
import { main, root } from '../scripts/run.mjs';
import { quantile } from './page.mjs';
import { writeBetweenMarks } from './walk/table.mjs';

await main(async () => {
  const { values } = parseArgs({
    options: {
      seconds: { type: 'string', default: '20' },
      cold: { type: 'boolean', default: false },
      only: { type: 'string', default: '' },
      markdown: { type: 'string' },
    },
  });
  const folder = mkdtempSync(join(root, 'node_modules/.bench-'));
  try {
    // As users get it, in one piece: modules loaded one by one call each other more slowly.
    await build({
      configFile: false,
      root,
      logLevel: 'error',
      build: { ssr: join(root, 'bench/step/steps.ts'), outDir: folder, minify: false },
      ssr: { noExternal: true },
    });
    const { CASES, measure } = await import(pathToFileURL(join(folder, 'steps.js')).href);
    const lines = [
      `Node ${process.versions.node}, ${platform()} ${arch()}, ${cpus().length} cores (${cpus()[0]?.model}).`,
      '',
      '| | steps | one step, ms: p50 | mean | p90 | p99 | a new field, ms: p50 |',
      '| --- | ---: | ---: | ---: | ---: | ---: | ---: |',
    ];
    for (const name of Object.keys(CASES)) {
      if (!name.includes(values.only)) continue;
      measure(name, 3);
      /** @type {Record<string, number[]>} */
      const { steps, fields } = measure(name, Number(values.seconds), values.cold);
      const mean = steps.reduce((sum, time) => sum + time, 0) / steps.length;
      const ms = [quantile(steps, 0.5), mean, quantile(steps, 0.9), quantile(steps, 0.99)];
      const field = fields.length > 0 ? quantile(fields, 0.5)?.toFixed(2) : '-';
      const told = ms.map((time) => time?.toFixed(3)).join(' | ');
      lines.push(`| ${name} | ${steps.length} | ${told} | ${field} |`);
    }
    console.log(lines.join('\n'));
    if (values.markdown) await writeBetweenMarks(values.markdown, 'step', lines.join('\n'));
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
