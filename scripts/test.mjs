// @ts-check
// npm test [-- the stages to run, all of them by default]
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { ADVICE, ensureBrowser } from './browser.mjs';
import { install } from './install.mjs';
import { main, npm, root, run, secondsSince } from './run.mjs';

/**
 * @typedef {object} Stage
 * @property {string} script the script of package.json
 * @property {string[]} [args]
 * @property {NodeJS.ProcessEnv} [env]
 * @property {string} [heartbeat] for a tool that says nothing while it works; those next to each other work at once
 * @property {(report: any) => Counts} [count] reads the numbers of tests out of a report; marks a stage of tests
 * @property {boolean} [browser]
 *
 * @typedef {{ passed: number, failed: number }} Counts
 * @typedef {{ name: string, ok: boolean, note: string, counts?: Counts }} Outcome
 */

/** A stage of tests that did not run, or broke outside of any test: one failure, or the sum would read as a success. */
const BROKEN = { passed: 0, failed: 1 };

/** @param {string} stage */
const reportOf = (stage) => join(root, 'test-results', `${stage}.json`);

/**
 * @param {string} name
 * @param {string} version of three, see e2e/vite.config.ts
 * @param {string[]} args
 * @returns {Stage}
 */
const browserTests = (name, version, ...args) => ({
  script: 'test:e2e',
  args: ['--forbid-only', '--reporter=list,json', ...args],
  env: { THREE_VERSION: version, PLAYWRIGHT_JSON_OUTPUT_NAME: reportOf(name) },
  count: ({ stats }) => ({ passed: stats.expected + stats.flaky, failed: stats.unexpected }),
  browser: true,
});

/**
 * @param {string} name
 * @param {string} script
 * @returns {Stage}
 */
const nodeTests = (name, script) => ({
  script,
  args: [
    '--allowOnly=false',
    '--reporter=default',
    '--reporter=json',
    // Relative, since the path to here may have blanks in it.
    `--outputFile.json=test-results/${name}.json`,
  ],
  count: (report) => ({ passed: report.numPassedTests, failed: report.numFailedTests }),
});

/** @type {Record<string, Stage>} */
const STAGES = {
  format: { script: 'check:format', heartbeat: 'format' },
  lint: { script: 'check:lint', heartbeat: 'lint' },
  types: { script: 'check:types', heartbeat: 'types' },
  unit: nodeTests('unit', 'test:unit'),
  build: { script: 'build' },
  package: nodeTests('package', 'test:package'),
  e2e: browserTests('e2e', 'newest'),
  'e2e-oldest': browserTests('e2e-oldest', 'oldest', '--grep', '@three'),
};

const names = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(STAGES);

await main(async () => {
  const unknown = names.find((name) => !STAGES[name]);
  if (unknown) {
    throw new Error(`No stage "${unknown}"; there are: ${Object.keys(STAGES).join(', ')}.`);
  }
  await install();
  process.exitCode = (await testAll()) ? 0 : 1;
});

/** Runs the stages, each whatever the others say, then sums up. */
async function testAll() {
  const browser = names.some((name) => STAGES[name].browser) ? await ensureBrowser() : undefined;
  console.log(`Node ${process.version}`);
  if (browser) console.log(`Browser: ${browser.version}, ${browser.path}, from ${browser.from}`);

  /** @type {Outcome[]} */
  const outcomes = [];
  for (const batch of batches(names)) {
    const [name] = batch;
    const buildFailed = outcomes.some((outcome) => outcome.name === 'build' && !outcome.ok);
    if (STAGES[name].browser && buildFailed) {
      outcomes.push({ name, ok: false, note: 'not run, the build failed', counts: BROKEN });
    } else if (STAGES[name].browser && !browser) {
      outcomes.push({ name, ok: false, note: 'not run, no browser', counts: BROKEN });
    } else {
      outcomes.push(...(await Promise.all(batch.map(test))));
    }
  }

  console.log('\n== summary');
  for (const { name, ok, note } of outcomes) {
    console.log(`${name.padEnd(12)}${ok ? 'ok' : 'FAILED'}  ${note}`);
  }
  if (names.some((name) => STAGES[name].browser) && !browser) console.log(ADVICE);
  if (names.some((name) => STAGES[name].count)) {
    const counts = outcomes.flatMap(({ counts }) => counts ?? []);
    const passed = counts.reduce((sum, count) => sum + count.passed, 0);
    const failed = counts.reduce((sum, count) => sum + count.failed, 0);
    console.log(`${passed} passed, ${failed} failed`);
  }
  return outcomes.every(({ ok }) => ok);
}

/**
 * One after the other, but those that use one core and say nothing at the same time.
 *
 * @param {string[]} names of stages
 * @returns {string[][]}
 */
function batches(names) {
  /** @type {string[][]} */
  const found = [];
  for (const name of names) {
    const last = found.at(-1);
    if (STAGES[name].heartbeat && last && STAGES[last[0]].heartbeat) last.push(name);
    else found.push([name]);
  }
  return found;
}

/**
 * @param {string} name
 * @returns {Promise<Outcome>}
 */
async function test(name) {
  const { script, args = [], env, heartbeat, count } = STAGES[name];
  console.log(`\n== ${name}`);
  // A report of an earlier run must not be taken for this one's.
  rmSync(reportOf(name), { force: true });
  mkdirSync(join(root, 'test-results'), { recursive: true });
  const started = Date.now();
  const ended = await run(npm('run', script, '--', ...args), { env, heartbeat });
  const seconds = `${secondsSince(started)} s`;
  if (!count) return { name, ok: ended, note: seconds };

  let counts = { passed: 0, failed: 0 };
  try {
    counts = count(JSON.parse(readFileSync(reportOf(name), 'utf8')));
  } catch {
    // It broke before it could report: no tests.
  }
  const none = counts.passed + counts.failed === 0;
  const ok = ended && !none && counts.failed === 0;
  const note = none ? 'no test ran' : `${counts.passed} passed, ${counts.failed} failed`;
  if (!ok && counts.failed === 0) counts = { ...counts, failed: BROKEN.failed };
  return { name, ok, note: `${seconds}, ${note}`, counts };
}
