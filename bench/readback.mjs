// What a read-back costs the page: `npm run bench:readback [-- --frames 200 --json file]`. Reproduces the table in
// docs/architecture.md, "The read-back", with the product's own code.
import { writeFileSync } from 'node:fs';
import { arch, cpus, platform } from 'node:os';
import { parseArgs } from 'node:util';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { ADVICE, findBrowser } from '../scripts/browser.mjs';

const { values } = parseArgs({
  options: { frames: { type: 'string', default: '150' }, json: { type: 'string' } },
});
const LOADS = { light: 3, 'just GPU-bound': 9, 'badly GPU-bound': 40 };
const MODES = {
  sync: 'sync',
  fenced: 'fenced, copied at the next frame',
  async: 'async (ours)',
  ask: '(none: asking WebGL for its clear colour)',
};

const found = await findBrowser();
if (!found) throw new Error(ADVICE);
const server = await createServer({
  configFile: 'e2e/vite.config.ts',
  logLevel: 'error',
  server: { port: 0, strictPort: false },
});
await server.listen();
const browser = await chromium.launch({
  executablePath: found.path,
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
const page = await browser.newPage({ viewport: { width: 800, height: 600 } });
await page.goto(`http://localhost:${server.httpServer.address().port}/e2e/harness/index.html`);

const sorted = (list) => [...list].sort((a, b) => a - b);
const quantile = (list, q) => sorted(list)[Math.floor(q * (list.length - 1))];
const show = (value) => (value === undefined ? '-' : value.toFixed(2));
const results = [];
console.log(
  `${browser.version()}, ${platform()} ${arch()}, ${cpus().length} cores (${cpus()[0].model}), software GPU`,
);
console.log(
  '\n| page | read-back | blocked a read, ms: median (p95) | reads a frame (of them waited for) | draw to field, ms | frame, ms |',
);
console.log('| --- | --- | --- | --- | --- | --- |');
for (const [page_, load] of Object.entries(LOADS)) {
  for (const mode of Object.keys(MODES)) {
    const result = await page.evaluate(
      async ([module, argument]) => (await import(module)).default(argument),
      ['/bench/readback.ts', { mode, load, frames: Number(values.frames) }],
    );
    results.push({ page: page_, ...result });
    const { blocked, latency, frame } = result;
    console.log(
      `| ${page_} (${load} ms) | ${MODES[mode]} | ${show(quantile(blocked, 0.5))} (${show(quantile(blocked, 0.95))}) ` +
        `| ${(blocked.length / frame.length).toFixed(2)} (${result.forced}) | ${show(quantile(latency, 0.5))} | ${show(quantile(frame, 0.5))} |`,
    );
  }
}
if (values.json) writeFileSync(values.json, JSON.stringify(results, null, 1));
await browser.close();
await server.close();
