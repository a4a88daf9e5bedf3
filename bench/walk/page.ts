import { loadWalkLevel, type WalkLevel } from './level.js';
import { Walk, type WalkResult, type WalkSettings } from './Walk.js';
import { CubeWalker, type CubeWalkerOptions } from './CubeWalker.js';
import { MeshBvhWalker } from '../rivals/MeshBvhWalker.js';
import { OctreeWalker } from '../rivals/OctreeWalker.js';
import { RapierWalker, ready as rapierReady } from '../rivals/RapierWalker.js';
import type { Walker } from '../rivals/Walker.js';

/** Who walks. */
export type Mover = 'cube' | 'mesh-bvh' | 'octree' | 'rapier';

export interface WalkCase extends CubeWalkerOptions, WalkSettings {
  mover: Mover;
  /** Url of a GLB file. */
  level: string;
  start?: [number, number, number];
}

export type Request =
  | { do: 'describe'; level: string; start?: [number, number, number] }
  | { do: 'begin'; walk: WalkCase }
  | { do: 'advance'; frames: number }
  | { do: 'finish' };

const levels = new Map<string, Promise<WalkLevel>>();
let walk: Walk | null = null;
let walker: Walker | null = null;
let between: () => Promise<void> | void = () => undefined;

/** The page's side of `session.mjs`: a walk is begun, advanced in portions, and finished. */
export default async function answer(request: Request): Promise<unknown> {
  switch (request.do) {
    case 'describe': {
      const { triangles, start } = await levelOf(request.level, request.start);
      return { triangles, start: start.toArray(), isolated: crossOriginIsolated };
    }
    case 'begin':
      return begin(request.walk);
    case 'advance':
      return advance(request.frames);
    case 'finish':
      return finish();
  }
}

async function begin(settings: WalkCase): Promise<void> {
  const level = await levelOf(settings.level, settings.start);
  await rapierReady();
  walker = await makeWalker(settings, level);
  const { mover, latency, backend = 'WebGL2' } = settings;
  const settle = () => (walker as CubeWalker).between();
  between = () => undefined;
  if (mover === 'cube' && latency === 'real') between = nextFrame;
  else if (mover === 'cube' && backend !== 'WebGL2') between = settle;
  walk = new Walk(level, walker, settings);
}

async function advance(frames: number): Promise<boolean> {
  for (let i = 0; i < frames && !walk!.done; i++) {
    walk!.frame();
    await between();
  }
  return walk!.done;
}

async function finish(): Promise<WalkResult> {
  await walk!.rest(between);
  const result = walk!.finish();
  walker!.dispose();
  return result;
}

async function makeWalker(settings: WalkCase, level: WalkLevel): Promise<Walker> {
  switch (settings.mover) {
    case 'cube':
      return CubeWalker.create(level.scene, settings);
    case 'mesh-bvh':
      return new MeshBvhWalker(level.geometry);
    case 'octree':
      return new OctreeWalker(level.geometry);
    case 'rapier':
      return RapierWalker.create(level.geometry);
  }
}

function levelOf(url: string, start?: [number, number, number]): Promise<WalkLevel> {
  let level = levels.get(url);
  if (level === undefined) levels.set(url, (level = loadWalkLevel(url, start)));
  return level;
}

const nextFrame = () => new Promise<void>((resolve) => requestAnimationFrame(() => resolve()));
