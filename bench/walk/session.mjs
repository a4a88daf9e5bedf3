// @ts-check
import { createReadStream } from 'node:fs';
import { openPage } from '../page.mjs';

/** Frames between two signs of life. */
const PORTION = 250;
/** What a software GPU makes Chromium and three say. */
export const EXPECTED = /GPU stall|KHR_parallel_shader_compile/;
/** Milliseconds between two lines of progress where there is no terminal to rewrite one in. */
const QUIET = 15_000;

/**
 * A page with the project's modules in it, and levels from anywhere on the disk.
 *
 * @param {string[]} files GLB files; the page knows them by `urlOf`
 */
export async function openSession(files) {
  const { run, machine, close } = await openPage({
    plugins: [serveLevels(files)],
    onMessage(type, text) {
      if (['warning', 'error'].includes(type) && !EXPECTED.test(text)) {
        console.error(`\n[page] ${text}`);
      }
    },
  });
  /** @param {object} request see `page.ts` */
  const ask = (request) => run('/bench/walk/page.ts', request);

  return {
    /** What all of this ran on, in one line. */
    machine: `${machine}, Node ${process.versions.node}`,
    ask,
    /**
     * One walk, from begin to end.
     *
     * @param {Record<string, any>} walk a `WalkCase` of `page.ts`
     * @param {string} title what to call it while it goes on
     */
    async walk(walk, title) {
      const tell = progress(title, walk.frames);
      await ask({ do: 'begin', walk });
      for (let done = false, frames = 0; !done;) {
        done = await ask({ do: 'advance', frames: PORTION });
        tell((frames += PORTION));
      }
      const result = await ask({ do: 'finish' });
      tell(Infinity);
      return result;
    },
    close,
  };
}

/** @param {number} i place of a file among those the session was opened with */
export const urlOf = (i) => `/walk-level-${i}.glb`;

/**
 * Serves files from anywhere under names of their own.
 *
 * @param {string[]} files
 * @returns {import('vite').Plugin}
 */
export function serveLevels(files) {
  return {
    name: 'walk-levels',
    configureServer({ middlewares }) {
      files.forEach((file, i) => {
        middlewares.use(urlOf(i), (_, response) => {
          response.setHeader('Content-Type', 'model/gltf-binary');
          createReadStream(file).pipe(response);
        });
      });
    },
  };
}

/**
 * Tells on stderr how far a walk is: a line that is rewritten, or now and then a new one.
 *
 * @param {string} title
 * @param {number} frames
 */
function progress(title, frames) {
  const begin = Date.now();
  let told = begin;
  /** @param {number} done */
  return (done) => {
    const seconds = Math.round((Date.now() - begin) / 1000);
    const end = done === Infinity;
    const line = `${title}: ${end ? `done in ${seconds} s` : `${Math.min(done, frames)} of ${frames}, ${seconds} s`}`;
    if (process.stderr.isTTY) {
      process.stderr.write(`\r\x1b[K${line}${end ? '\n' : ''}`);
    } else if (end || Date.now() - told > QUIET) {
      told = Date.now();
      console.error(line);
    }
  };
}
