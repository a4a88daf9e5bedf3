// @ts-check
// A long walk on the demo's level, for what comes once in a hundred thousand frames: `npm run soak [-- --steps 200000
// --level file.glb --hz 60 --seed 7 --latency 0 --markdown docs/accuracy.md]`. Fails if anything went through.
import { basename } from 'node:path';
import { parseArgs } from 'node:util';
import { main } from '../../scripts/run.mjs';
import { findLevels, versions } from './options.mjs';
import { openSession, urlOf } from './session.mjs';
import { lateness, writeBetweenMarks } from './table.mjs';

await main(async () => {
  const { values } = parseArgs({
    options: {
      steps: { type: 'string', default: '200000' },
      level: { type: 'string', default: 'public/level.glb' },
      hz: { type: 'string', default: '60' },
      seed: { type: 'string', default: '7' },
      latency: { type: 'string', default: '0' },
      markdown: { type: 'string' },
    },
  });
  const files = findLevels([values.level]);
  const walk = {
    mover: 'cube',
    level: urlOf(0),
    hz: Number(values.hz),
    frames: Number(values.steps),
    seed: Number(values.seed),
    leg: 20,
    latency: Number(values.latency),
  };
  const session = await openSession(files);
  const begin = Date.now();
  const result = await session
    .walk(walk, `${basename(values.level)}, ${walk.hz} Hz, ${lateness(walk.latency)}`)
    .finally(() => session.close());

  const { penetration, counts } = result;
  const mm = (/** @type {number} */ metres) => `${(1000 * metres).toFixed(2)} mm`;
  const text = [
    '```',
    `${walk.frames} frames at ${walk.hz} Hz on ${basename(values.level)}, seed ${walk.seed}, ${lateness(walk.latency)}`,
    `penetration         p50 ${mm(penetration.p50)}, p99 ${mm(penetration.p99)}, max ${mm(penetration.max)}`,
    `deepest             at (${result.deepest.to.map((/** @type {number} */ x) => x.toFixed(3)).join(', ')}), frame ${result.deepest.frame}`,
    `surfaces crossed    ${result.crossed}`,
    `fell out            ${result.fellThrough} through a surface, ${result.fellOff} off the edge`,
    `not a number        ${result.nan}`,
    `walked              ${(result.distance / 1000).toFixed(2)} km`,
    `held, slowed        ${counts.held ?? '-'}, ${counts.slowed ?? '-'} of ${counts.steps ?? '-'} steps`,
    `cubemaps            ${counts.draws}, ${(counts.draws / walk.frames).toFixed(2)} a frame`,
    `gap at rest         ${mm(Math.min(...result.rest.gaps))} to ${mm(Math.max(...result.rest.gaps))}`,
    `took                ${Math.round((Date.now() - begin) / 60_000)} min, ${session.machine}`,
    `with                three-cube-collider ${versions()['three-cube-collider']}, three ${versions().three}`,
    '```',
  ].join('\n');
  console.log(text);
  if (values.markdown) await writeBetweenMarks(values.markdown, 'soak', text);
  if (result.crossed + result.nan > 0) {
    throw new Error(`It went through: ${JSON.stringify(result.firstCrossing)}`);
  }
});
