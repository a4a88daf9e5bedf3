// @ts-check
import { arch, cpus, platform } from 'node:os';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { ADVICE, findBrowser } from '../scripts/browser.mjs';

/** In software too; see playwright.config.ts. */
const WEBGPU = [
  '--enable-unsafe-webgpu',
  '--use-webgpu-adapter=swiftshader',
  '--use-vulkan=swiftshader',
  '--enable-features=Vulkan',
];

/** What this runs on, in a few words. */
export const HOST = `${platform()} ${arch()}, ${cpus().length} cores (${cpus()[0]?.model})`;

/** For suites that count the heap's bytes: exact ones, and rubbish collected when they say so. */
const HEAP = ['--enable-precise-memory-info', '--js-flags=--expose-gc'];

/** Microseconds between two looks of the profiler. */
const SAMPLING = 100;

/** Headers that give the page a fine clock: without them it ticks in tenths of a millisecond. */
const ISOLATED = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
};

/**
 * An empty page in a browser with a software GPU, whose server serves the whole repository.
 *
 * @param {object} [options]
 * @param {import('vite').Plugin[]} [options.plugins] of the server
 * @param {(type: string, text: string) => void} [options.onMessage] hears what the page's console gets
 * @returns `run(module, argument)`, which imports a module there and calls its default export; `profiled`, which does so
 *   under the browser's profiler; a line on the machine; the browser's name; and `close()`
 */
export async function openPage({ plugins = [], onMessage } = {}) {
  const found = await findBrowser();
  if (!found) throw new Error(ADVICE);
  const server = await createServer({
    configFile: 'e2e/vite.config.ts',
    logLevel: 'error',
    server: { port: 0, strictPort: false, headers: ISOLATED },
    plugins,
  });
  await server.listen();
  const browser = await chromium.launch({
    executablePath: found.path,
    args: [
      '--no-sandbox',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      ...WEBGPU,
      ...HEAP,
    ],
  });
  const page = await browser.newPage({ viewport: { width: 800, height: 600 } });
  if (onMessage) page.on('console', (message) => onMessage(message.type(), message.text()));
  const address = server.httpServer?.address();
  if (typeof address !== 'object' || address === null) throw new Error('The server has no port.');
  await page.goto(`http://localhost:${address.port}/e2e/harness/index.html`);
  /** @type {(module: string, argument: unknown) => Promise<any>} */
  const run = (module, argument) =>
    page.evaluate(
      async ([url, value]) => (await import(/** @type {string} */ (url))).default(value),
      /** @type {const} */ ([module, argument]),
    );
  const devtools = await page.context().newCDPSession(page);
  return {
    run,
    /** Runs it while the browser's profiler looks on. @type {(module: string, argument: unknown) => Promise<import('./suites/selfTimes.mjs').CpuProfile>} */
    async profiled(module, argument) {
      await devtools.send('Profiler.enable');
      await devtools.send('Profiler.setSamplingInterval', { interval: SAMPLING });
      await devtools.send('Profiler.start');
      await run(module, argument);
      const { profile } = await devtools.send('Profiler.stop');
      return { samples: [], timeDeltas: [], ...profile };
    },
    machine: `Chromium ${browser.version()}, ${HOST}, software GPU`,
    browser: `Chromium ${browser.version()}`,
    async close() {
      await browser.close();
      await server.close();
    },
  };
}

/** The value that the part `q` of a list lies below. @param {number[]} list @param {number} q */
export function quantile(list, q) {
  return [...list].sort((a, b) => a - b)[Math.floor(q * (list.length - 1))];
}

/** Two digits after the point, for a table. @param {number | undefined} value */
export function show(value) {
  return value === undefined ? '-' : value.toFixed(2);
}
