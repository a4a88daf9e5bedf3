import { loadWalkLevel } from '../../bench/walk/level.js';
import { Walk, type WalkResult, type WalkSettings } from '../../bench/walk/Walk.js';
import { CubeWalker, type CubeWalkerOptions } from '../../bench/walk/CubeWalker.js';

/** A walk over the demo's level as the comparison walks it, with its judge. */
export default async function walk(
  settings: WalkSettings & CubeWalkerOptions,
): Promise<WalkResult> {
  const level = await loadWalkLevel('/level.glb');
  const walker = await CubeWalker.create(level.scene, settings);
  const walk = new Walk(level, walker, settings);
  const between = () =>
    settings.latency === 'real'
      ? new Promise<void>((resolve) => requestAnimationFrame(() => resolve()))
      : walker.between();
  while (!walk.done) {
    walk.frame();
    await between();
  }
  await walk.rest(between, 3);
  const result = walk.finish();
  walker.dispose();
  return result;
}
