import { createServer, type AddressInfo } from 'node:net';
import { defineConfig } from '@playwright/test';
import { ADVICE, findBrowser } from './scripts/browser.mjs';

const env = process.env;
const browser = await findBrowser();
if (!browser) throw new Error(ADVICE);
// Playwright reads this file again in every worker: what is found or chosen once is handed down.
env.CHROMIUM_PATH = browser.path;
env.E2E_PORT ??= String(await freePort());

/** `newest` or `oldest`: which of the two installed copies of three the pages get; or another version (scripts/three.mjs). */
env.THREE_VERSION ??= 'newest';

export default defineConfig({
  testDir: 'e2e',
  testMatch: '**/*.spec.ts',
  outputDir: `test-results/${env.THREE_VERSION}`,
  snapshotPathTemplate: 'e2e/screenshots/{arg}{ext}',
  // Pages wait as often as they draw: two on two cores take three quarters of the time that one takes.
  workers: 2,
  fullyParallel: false,
  // A test that passes at the second try hides a race.
  retries: 0,
  timeout: 120_000,
  reporter: 'list',
  expect: { toHaveScreenshot: { threshold: 0.1, maxDiffPixelRatio: 0.01 } },
  use: {
    baseURL: `http://localhost:${env.E2E_PORT}`,
    viewport: { width: 960, height: 540 },
    deviceScaleFactor: 1,
    trace: 'off',
  },
  projects: [
    {
      name: 'chromium',
      use: {
        browserName: 'chromium',
        launchOptions: {
          executablePath: browser.path,
          args: softwareGpu(),
        },
      },
    },
  ],
  webServer: {
    command: 'node node_modules/vite/bin/vite.js --config e2e/vite.config.ts',
    // Not by asking for the page: Playwright would ask the proxy of a closed network for it.
    wait: { stdout: /Local/ },
    // Never somebody else's server: it may serve another checkout, or the other three.
    reuseExistingServer: false,
    timeout: 60_000,
  },
});

/**
 * The same software GPU everywhere, so that pictures and depths are the same everywhere. Playwright itself adds
 * --enable-unsafe-swiftshader, --hide-scrollbars, --force-color-profile=srgb, --no-sandbox, --no-first-run and the
 * switches that keep Chromium off the network.
 */
function softwareGpu(): string[] {
  const webgl = ['--use-angle=swiftshader'];
  if (process.platform !== 'linux') return webgl;
  return [
    ...webgl,
    // WebGPU too; three's renderer for it needs all four. They cost WebGL nothing. The features after Vulkan are
    // Playwright's own: a second --enable-features replaces the first.
    '--enable-unsafe-webgpu',
    '--use-webgpu-adapter=swiftshader',
    '--use-vulkan=swiftshader',
    '--enable-features=Vulkan,CDPScreenshotNewSurface,SkipListAccountsWithoutGaiaCookies',
  ];
}

/** A port that nobody holds, so that several runs on one machine do not meet. */
function freePort(): Promise<number> {
  return new Promise((resolve, reject) => {
    const server = createServer().once('error', reject);
    server.listen(0, 'localhost', () => {
      const { port } = server.address() as AddressInfo;
      server.close(() => resolve(port));
    });
  });
}
