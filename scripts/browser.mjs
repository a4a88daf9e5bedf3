// @ts-check
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { run } from './run.mjs';

/** @typedef {{ path: string, from: string, version: string }} Browser */

const VARIABLES = ['CHROMIUM_PATH', 'CHROME_PATH', 'PLAYWRIGHT_CHROMIUM_EXECUTABLE_PATH'];

export const ADVICE =
  'No browser for the tests: install Chromium or Chrome, or set CHROMIUM_PATH to the program file of one, and try again.';

/**
 * A Chromium that really starts: in an environment variable, in Playwright's cache, or in the system.
 *
 * @returns {Promise<Browser | undefined>}
 * @throws {Error} if an environment variable names a file that is not one
 */
export async function findBrowser() {
  for (const name of VARIABLES) {
    const path = process.env[name];
    if (!path) continue;
    const version = versionOf(path);
    if (version) return { path, from: name, version };
    throw new Error(`${name} is set to "${path}", which does not start as a Chromium.`);
  }
  const downloaded = await playwrightPath();
  const candidates = [
    ...(downloaded ? [{ path: downloaded, from: "Playwright's cache" }] : []),
    ...systemPaths().map((path) => ({ path, from: 'the system' })),
  ];
  for (const candidate of candidates) {
    const version = versionOf(candidate.path);
    if (version) return { ...candidate, version };
  }
  return undefined;
}

/**
 * What the program calls itself, or nothing if it does not start: libraries may be missing, and Ubuntu's
 * `chromium-browser` is a script that only asks for a snap.
 *
 * @param {string} path
 */
function versionOf(path) {
  if (!existsSync(path)) return undefined;
  // There, `--version` would open a window.
  if (process.platform === 'win32') return 'version not asked';
  const { status, stdout } = spawnSync(path, ['--version'], { encoding: 'utf8', timeout: 30_000 });
  return status === 0 && /chrom|edge/i.test(stdout) ? stdout.trim() : undefined;
}

/** Where this Playwright would keep its Chromium: the full one, as a user has, not the headless shell. */
async function playwrightPath() {
  try {
    const { chromium } = await import('@playwright/test');
    return chromium.executablePath();
  } catch {
    return undefined; // it is not installed, or has no browser for this system
  }
}

/** @returns {string[]} where a system's browser would be, best first */
function systemPaths() {
  const env = process.env;
  switch (process.platform) {
    case 'darwin':
      return ['/Applications', join(env.HOME ?? '', 'Applications')].flatMap((folder) =>
        ['Chromium', 'Google Chrome', 'Microsoft Edge'].map((name) =>
          join(folder, `${name}.app/Contents/MacOS/${name}`),
        ),
      );
    case 'win32':
      return [env.PROGRAMFILES, env['PROGRAMFILES(X86)'], env.LOCALAPPDATA].flatMap((folder) =>
        folder
          ? [
              join(folder, 'Chromium/Application/chrome.exe'),
              join(folder, 'Google/Chrome/Application/chrome.exe'),
              join(folder, 'Microsoft/Edge/Application/msedge.exe'),
            ]
          : [],
      );
    default:
      return [
        'chromium',
        'chromium-browser',
        'google-chrome-stable',
        'google-chrome',
        'chrome',
        'microsoft-edge',
        'msedge',
      ].flatMap((name) => onPath(name));
  }
}

/**
 * @param {string} name
 * @returns {string[]} the files of that name in the folders of PATH
 */
function onPath(name) {
  return (process.env.PATH ?? '')
    .split(delimiter)
    .filter(Boolean)
    .map((folder) => join(folder, name))
    .filter((path) => existsSync(path));
}

/**
 * Finds a browser, or gets one: from Playwright, else from the system's package manager.
 *
 * @returns {Promise<Browser | undefined>}
 * @throws {Error} as `findBrowser` does
 */
export async function ensureBrowser() {
  const found = await findBrowser();
  if (found) return found;

  for await (const { what, commands } of installs()) {
    console.log(`No browser yet: trying ${what}.`);
    for (const command of commands) {
      console.log(`$ ${command.join(' ')}`);
      // A failure may be harmless (one package list of many out of reach): what counts is the browser.
      await run(command, {
        heartbeat: what,
        timeout: 300,
        // In a closed network each of Playwright's five tries would otherwise wait twice as long.
        env: { PLAYWRIGHT_DOWNLOAD_CONNECTION_TIMEOUT: '15000' },
      });
    }
    const browser = await findBrowser();
    if (browser) return browser;
  }
  return undefined;
}

/** @typedef {{ what: string, commands: string[][] }} Install */

/**
 * The ways to get a browser, in the order to try them; each is looked for only after the one before.
 *
 * @returns {AsyncGenerator<Install>}
 */
async function* installs() {
  const cli = fileURLToPath(new URL('../node_modules/@playwright/test/cli.js', import.meta.url));
  const playwright = [process.execPath, cli];
  yield {
    what: "Playwright's download",
    commands: [[...playwright, 'install', '--no-shell', '--no-remove', 'chromium']],
  };

  const admin = adminPrefix();
  // What was downloaded does not start, so it lacks libraries. Playwright knows their names for apt-get.
  if (admin && existsSync((await playwrightPath()) ?? '') && onPath('apt-get').length) {
    yield {
      what: 'the libraries that it lacks',
      commands: [[...playwright, 'install-deps', 'chromium']],
    };
  }

  yield* systemInstalls(admin);
}

/**
 * The package managers that there are on this system, and that we may use.
 *
 * @param {string[] | undefined} admin see `adminPrefix`
 * @returns {Install[]}
 */
function systemInstalls(admin) {
  const commands = process.platform === 'linux' ? linuxCommands(admin) : otherCommands();
  return Object.entries(commands)
    .filter(([manager]) => onPath(manager).length)
    .map(([manager, commands]) => ({ what: manager, commands }));
}

/**
 * @param {string[] | undefined} admin see `adminPrefix`
 * @returns {Record<string, string[][]>} the name of each package manager, and what to tell it
 */
function linuxCommands(admin) {
  if (!admin) return {};
  // A fresh machine may be updating itself: wait for that.
  const settings = ['env', 'DEBIAN_FRONTEND=noninteractive'];
  const apt = [...admin, ...settings, 'apt-get', '-q', '-o', 'DPkg::Lock::Timeout=60'];
  return {
    'apt-get': [
      [...apt, 'update'],
      [...apt, 'install', '-y', '--no-install-recommends', 'chromium'],
    ],
    dnf: [[...admin, 'dnf', 'install', '-y', 'chromium']],
    pacman: [[...admin, 'pacman', '-Sy', '--noconfirm', '--needed', 'chromium']],
    apk: [[...admin, 'apk', 'add', '--no-cache', 'chromium']],
    zypper: [[...admin, 'zypper', '--non-interactive', 'install', 'chromium']],
  };
}

/** @returns {ReturnType<typeof linuxCommands>} */
function otherCommands() {
  const agree = ['--accept-package-agreements', '--accept-source-agreements'];
  return {
    // Not its Chromium, which macOS calls damaged for want of a signature.
    brew: [['brew', 'install', '--cask', 'google-chrome']],
    'winget.exe': [['winget', 'install', '--exact', '--id', 'Google.Chrome', '--silent', ...agree]],
  };
}

/**
 * What to put before a command that only the administrator may run; nothing if that would ask for a password,
 * for which a test run must not wait.
 */
function adminPrefix() {
  if (process.getuid?.() === 0) return [];
  return spawnSync('sudo', ['-n', 'true']).status === 0 ? ['sudo', '-n'] : undefined;
}
