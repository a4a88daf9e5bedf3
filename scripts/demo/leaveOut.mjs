// @ts-check
import { rm } from 'node:fs/promises';
import { join, resolve } from 'node:path';

/**
 * Leaves out of the build a part of the public folder that none of its pages asks for.
 *
 * @param {string} path in the public folder
 * @returns {import('vite').Plugin}
 */
export function leaveOut(path) {
  let folder = '';
  return {
    name: 'leave-out',
    apply: 'build',
    configResolved({ root, build }) {
      folder = resolve(root, build.outDir);
    },
    closeBundle: () => rm(join(folder, path), { recursive: true, force: true }),
  };
}
