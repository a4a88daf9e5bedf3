// @ts-check
// npm run test:three -- VERSION [Playwright's arguments]: the browser tests on another release of three.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { main, npm, root, run } from './run.mjs';

const [version = '', ...args] = process.argv.slice(2);

await main(async () => {
  if (!/^\d+\.\d+\.\d+$/.test(version)) {
    throw new Error(
      'npm run test:three -- VERSION [specs …]; VERSION as 0.183.0, a release of three.',
    );
  }
  const folder = join(root, '.cache/three', version);
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'package.json'), '{ "private": true }');
  const three = join(folder, 'node_modules/three');
  if (installed(three) !== version) {
    const install = npm(
      'install',
      '--prefix',
      folder,
      '--no-audit',
      '--no-fund',
      `three@${version}`,
    );
    if (!(await run(install)) || installed(three) !== version) {
      throw new Error(`three ${version} could not be installed.`);
    }
  }
  console.log(`three ${version}`);
  const env = { THREE_VERSION: version, THREE_FOLDER: three };
  const tests = npm('run', 'test:e2e', '--', ...(args.length > 0 ? args : ['--grep', '@three']));
  if (!(await run(tests, { env }))) process.exitCode = 1;
});

/** The version in a folder; none if there is nothing. @param {string} folder */
function installed(folder) {
  try {
    return JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')).version;
  } catch {
    return undefined;
  }
}
