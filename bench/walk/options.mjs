// @ts-check
import { existsSync, readFileSync } from 'node:fs';
import { basename, resolve } from 'node:path';
import { parseArgs } from 'node:util';

const OWN_LEVEL = 'public/level.glb';
const SHARED_LEVEL = '../shared/levels/collision-world.glb';

export const HELP = `npm run walk -- [options]

  --level file.glb      one level, may be repeated (default: the demo's, and ${SHARED_LEVEL} if it is there)
  --start x,y,z         where walks begin (default: the node "spawn", else a free place near the origin)
  --hz 20,30,60,144     frame rates
  --latency 0,1,2,3     frames that fields are held back; 0 reads 'sync'
  --real-async          one more walk that reads asynchronously as shipped, frame by frame (short: --async-steps)
  --async-steps 2000    its frames
  --backend WebGPU      ours on WebGPURenderer, or on its 'fallback', one frame late; may be repeated (default: WebGL2)
  --steps 20000         frames of each walk
  --seed 1              of the inputs and places
  --leg 4               seconds after which it goes on at another place (the first: --start)
  --no-rivals           without the others
  --resolution 32       texels per face edge of ours
  --collider '{…}'      further options of our collider, as JSON
  --character '{…}'     further options of our character, as JSON
  --json file           keep the results
  --trace file.csv      keep every frame's foot, ground and penetration
  --from file           tell the results of an earlier run instead of walking; of several, if repeated
  --markdown file       write the tables between its marks <!-- walk:begin --> and <!-- walk:end -->
  --marks walk          other marks
  --only cube,mesh-bvh  with --markdown: whom the tables tell of (default: all)
  --chart file.svg      draw the distributions of the penetrations`;

/** The command line of `npm run walk`. */
export function readOptions() {
  const { values } = parseArgs({
    options: {
      help: { type: 'boolean' },
      level: { type: 'string', multiple: true },
      start: { type: 'string' },
      hz: { type: 'string', default: '20,30,60,144' },
      latency: { type: 'string', default: '0,1,2,3' },
      'real-async': { type: 'boolean', default: false },
      'async-steps': { type: 'string', default: '2000' },
      backend: { type: 'string', multiple: true, default: ['WebGL2'] },
      steps: { type: 'string', default: '20000' },
      seed: { type: 'string', default: '1' },
      leg: { type: 'string', default: '4' },
      rivals: { type: 'boolean', default: true },
      resolution: { type: 'string' },
      collider: { type: 'string', default: '{}' },
      character: { type: 'string', default: '{}' },
      json: { type: 'string' },
      trace: { type: 'string' },
      from: { type: 'string', multiple: true },
      markdown: { type: 'string' },
      marks: { type: 'string', default: 'walk' },
      only: { type: 'string' },
      chart: { type: 'string' },
    },
    allowNegative: true,
  });
  if (values.help) {
    console.log(HELP);
    process.exit();
  }
  const resolution = values.resolution === undefined ? {} : { resolution: +values.resolution };
  return {
    ...values,
    levels: findLevels(values.level),
    start: values.start === undefined ? undefined : numbers('start', values.start, -Infinity),
    hz: numbers('hz', values.hz, 1),
    latency: numbers('latency', values.latency, 0),
    steps: numbers('steps', values.steps, 1)[0],
    asyncSteps: numbers('async-steps', values['async-steps'], 1)[0],
    seed: numbers('seed', values.seed, 0)[0],
    leg: numbers('leg', values.leg, 1)[0],
    collider: { ...JSON.parse(values.collider), ...resolution },
    character: JSON.parse(values.character),
  };
}

/**
 * The files that were asked for, else those there are by default; says which of these are missing.
 *
 * @param {string[] | undefined} asked
 */
export function findLevels(asked) {
  const files = (asked ?? [OWN_LEVEL, SHARED_LEVEL]).map((file) => resolve(file));
  return files.filter((file) => {
    if (existsSync(file)) return true;
    if (asked) throw new Error(`There is no level "${file}".`);
    console.error(`No ${basename(file)} here (${file}): its walks are left out.`);
    return false;
  });
}

/**
 * @param {string} name
 * @param {string} list numbers, with commas between
 * @param {number} least
 */
function numbers(name, list, least) {
  return list.split(',').map((text) => {
    const value = Number(text);
    if (text.trim() !== '' && Number.isFinite(value) && value >= least) return value;
    throw new Error(`--${name}: "${text}" is no number of ${least} or more.`);
  });
}

/** The versions of those who walk, for the record. */
export function versions() {
  const { devDependencies, version } = JSON.parse(readFileSync('package.json', 'utf8'));
  return {
    'three-cube-collider': version,
    three: devDependencies.three,
    'three-mesh-bvh': devDependencies['three-mesh-bvh'],
    '@dimforge/rapier3d-compat': devDependencies['@dimforge/rapier3d-compat'],
  };
}
