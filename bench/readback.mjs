// What a read-back costs the page, with the product's own code:
// `npm run bench:readback [-- --frames 150 --json file --markdown docs/architecture.md]`.
import { writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { openPage, quantile, show } from './page.mjs';
import { writeBetweenMarks } from './walk/table.mjs';

const { values } = parseArgs({
  options: {
    frames: { type: 'string', default: '150' },
    json: { type: 'string' },
    markdown: { type: 'string' },
  },
});
const LOADS = { light: 3, 'just GPU-bound': 9, 'badly GPU-bound': 40 };
const MODES = {
  sync: 'sync',
  fenced: 'fenced, copied at the next frame',
  async: 'async (ours)',
  ask: '(none: asking WebGL for its clear colour)',
  WebGPU: 'WebGPU, mapped (ours)',
  fallback: 'WebGPURenderer on WebGL 2 (ours)',
};
/** @param {string} mode */
const moduleOf = (mode) =>
  mode === 'WebGPU' || mode === 'fallback' ? '/bench/readbackNodes.ts' : '/bench/readback.ts';

const { run, machine, close } = await openPage();
const results = [];
const lines = [
  `${machine}.`,
  '',
  '| page | read-back | blocked a read, ms: median (p95) | reads a frame (of them waited for) | draw to field, ms | frame, ms |',
  '| --- | --- | --- | --- | --- | --- |',
];
console.log(lines.join('\n'));
for (const [page, load] of Object.entries(LOADS)) {
  for (const mode of Object.keys(MODES)) {
    const result = await run(moduleOf(mode), { mode, load, frames: Number(values.frames) });
    results.push({ page, ...result });
    const { blocked, latency, frame } = result;
    const line =
      `| ${page} (${load} ms) | ${MODES[mode]} | ${show(quantile(blocked, 0.5))} (${show(quantile(blocked, 0.95))}) ` +
      `| ${(blocked.length / frame.length).toFixed(2)} (${result.forced}) | ${show(quantile(latency, 0.5))} | ${show(quantile(frame, 0.5))} |`;
    lines.push(line);
    console.log(line);
  }
}
await close();
if (values.json) writeFileSync(values.json, JSON.stringify(results, null, 1));
if (values.markdown) await writeBetweenMarks(values.markdown, 'readback', lines.join('\n'));
