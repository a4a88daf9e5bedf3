// @ts-check
// node scripts/install.mjs: all that `npm start` and `npm test` would install, a browser included, and no more.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { ADVICE, ensureBrowser } from './browser.mjs';
import { main, npm, root, run, secondsSince } from './run.mjs';

/**
 * Brings `node_modules` in step with package-lock.json; touches nothing if it is.
 *
 * @throws {Error} in one line, if this Node is too old or npm fails
 */
export async function install() {
  const [major, minor] = process.versions.node.split('.').map(Number);
  const supported = major === 20 ? minor >= 19 : major === 22 ? minor >= 13 : major > 22;
  if (!supported) {
    throw new Error(
      `Node 20.19 or later is needed (of 22, 22.13 or later); this is ${process.version}.`,
    );
  }
  if (inStep()) return;
  console.log('Installing the dependencies (npm ci).');
  const started = Date.now();
  // `--include=dev`: a machine with NODE_ENV=production would otherwise leave out every tool.
  const ci = npm('ci', '--include=dev', '--no-audit', '--no-fund', '--no-progress');
  if (!(await run(ci, { heartbeat: 'npm ci' }))) {
    throw new Error('npm ci failed: see its own message above; without a network it cannot work.');
  }
  console.log(`Installed in ${secondsSince(started)} s.`);
}

/**
 * Whether what npm noted at the end of the last install is what package-lock.json asks for. By content, not by
 * date: a checkout gives every file the date of today.
 */
function inStep() {
  const wanted = packagesOf('package-lock.json');
  const present = packagesOf('node_modules/.package-lock.json');
  if (!wanted || !present) return false;
  return (
    Object.entries(wanted).every(
      ([path, { version, integrity, optional }]) =>
        path === '' || // the project itself
        (present[path]
          ? present[path].version === version && present[path].integrity === integrity
          : optional), // for another system
    ) && Object.keys(present).every((path) => wanted[path])
  );
}

/**
 * @typedef {{ version: string, integrity?: string, optional?: boolean }} Package
 *
 * @param {string} lockFile
 * @returns {Record<string, Package> | undefined}
 */
function packagesOf(lockFile) {
  try {
    return JSON.parse(readFileSync(join(root, lockFile), 'utf8')).packages;
  } catch {
    return undefined;
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  await main(async () => {
    await install();
    const browser = await ensureBrowser();
    if (!browser) throw new Error(ADVICE);
    console.log(`Browser: ${browser.version}, ${browser.path}, from ${browser.from}`);
  });
}
