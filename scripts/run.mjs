// @ts-check
import { spawn, spawnSync } from 'node:child_process';
import { basename, dirname } from 'node:path';
import { fileURLToPath } from 'node:url';

/** The repository; every command runs here, wherever it was called from. */
export const root = dirname(dirname(fileURLToPath(import.meta.url)));

const windows = process.platform === 'win32';

/**
 * Runs the main part of a script; what goes wrong is said in its own one line.
 *
 * @param {() => Promise<void>} body
 */
export async function main(body) {
  try {
    await body();
  } catch (error) {
    console.error(error instanceof Error ? error.message : error);
    process.exit(1);
  }
}

/** @param {number} since the result of an earlier `Date.now()` */
export const secondsSince = (since) => Math.round((Date.now() - since) / 1000);

/**
 * Runs a command to its end, its output streaming through.
 *
 * @param {string[]} command the program, then its arguments
 * @param {object} [options]
 * @param {NodeJS.ProcessEnv} [options.env] added to this process's own
 * @param {string} [options.heartbeat] what to say every ten seconds, for commands that say little themselves
 * @param {number} [options.timeout] seconds after which the command and its children are killed
 * @returns {Promise<boolean>} whether it ended with exit code 0
 */
export function run([program, ...args], { env, heartbeat, timeout } = {}) {
  const started = Date.now();
  const child = spawn(program, args, {
    cwd: root,
    env: { ...process.env, ...env },
    // Under a time limit nobody may be asked anything.
    stdio: [timeout ? 'ignore' : 'inherit', 'inherit', 'inherit'],
    // Node refuses to start a .cmd file, which npm and winget may be, without a shell.
    shell: windows && program !== process.execPath,
    // Its own process group, so that a time-out can end the grandchildren that do the work.
    detached: Boolean(timeout) && !windows,
  });
  const kill = () => {
    if (windows) spawnSync('taskkill', ['/pid', String(child.pid), '/t', '/f']);
    else if (child.pid) process.kill(-child.pid, 'SIGKILL');
  };
  const interrupted = () => {
    kill();
    process.exit(130);
  };
  // In its own group it does not hear Ctrl-C.
  if (timeout) process.on('SIGINT', interrupted).on('SIGTERM', interrupted);

  const beat = heartbeat
    ? setInterval(() => console.log(`… ${heartbeat}, ${secondsSince(started)} s`), 10_000)
    : undefined;
  const limit = timeout
    ? setTimeout(() => {
        console.log(`Gave up after ${timeout} s: ${[basename(program), ...args].join(' ')}`);
        kill();
      }, timeout * 1000)
    : undefined;

  return new Promise((resolve) => {
    /** @param {boolean} ok */
    const finish = (ok) => {
      clearInterval(beat);
      clearTimeout(limit);
      process.off('SIGINT', interrupted).off('SIGTERM', interrupted);
      resolve(ok);
    };
    child.on('error', (error) => {
      console.error(error.message);
      finish(false);
    });
    child.on('close', (code) => finish(code === 0));
  });
}

/**
 * The command line of npm. Under `npm start` and `npm test` that is the very npm in use, run by the very
 * Node in use.
 *
 * @param {string[]} args
 */
export function npm(...args) {
  const path = process.env.npm_execpath;
  return path && basename(path) === 'npm-cli.js'
    ? [process.execPath, path, ...args]
    : ['npm', ...args];
}
