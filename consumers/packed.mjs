// @ts-check
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, renameSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { npm, root } from '../scripts/run.mjs';

/**
 * A folder with the package installed from its tarball, as `npm pack` makes it of the `dist/` that is there. three and
 * what else its users have is found in the repository's own `node_modules`, above it.
 *
 * @param {string} name of the folder, which is emptied
 * @returns {{ folder: string, tarball: string, installed: string }} the folder, the tarball, where it was unpacked
 */
export function packed(name) {
  if (!existsSync(join(root, 'dist/index.js'))) {
    throw new Error('There is no dist/; run "npm run build" first.');
  }
  const folder = join(root, '.cache/consumers', name);
  rmSync(folder, { recursive: true, force: true });
  const modules = join(folder, 'node_modules');
  mkdirSync(modules, { recursive: true });
  const [npmProgram = '', ...args] = npm('pack', '--ignore-scripts', '--pack-destination', folder);
  execFileSync(npmProgram, args, { cwd: root, stdio: 'ignore' });
  const tarball = readdirSync(folder).find((file) => file.endsWith('.tgz')) ?? '';
  execFileSync('tar', ['-xzf', join('..', tarball)], { cwd: modules });
  const installed = join(modules, 'three-cube-collider');
  renameSync(join(modules, 'package'), installed);
  return { folder, tarball: join(folder, tarball), installed };
}
