import type { BufferGeometry } from 'three';
import { MeshBvhWalker } from '../walk/walkers/MeshBvhWalker.js';
import { OctreeWalker } from '../walk/walkers/OctreeWalker.js';
import { RapierWalker, ready } from '../walk/walkers/RapierWalker.js';
import type { Walker } from '../walk/walkers/Walker.js';

export interface Rival {
  name: 'Octree' | 'three-mesh-bvh' | 'Rapier';
  /** Of more triangles than these it takes over a minute to build. */
  most: number;
  /** Builds it of one geometry in world space. */
  create(geometry: BufferGeometry): Promise<Walker>;
}

/** Each as its own example drives it. */
export const RIVALS: readonly Rival[] = [
  { name: 'Octree', most: 200_000, create: async (geometry) => new OctreeWalker(geometry) },
  {
    name: 'three-mesh-bvh',
    most: Infinity,
    create: async (geometry) => new MeshBvhWalker(geometry),
  },
  { name: 'Rapier', most: Infinity, create: (geometry) => RapierWalker.create(geometry) },
];

let memory: Promise<WebAssembly.Memory | null> | null = null;

/** Rapier's WebAssembly, loaded; and its memory, or null where another has loaded it before. */
export function rapierMemory(): Promise<WebAssembly.Memory | null> {
  return (memory ??= loadRapier());
}

async function loadRapier(): Promise<WebAssembly.Memory | null> {
  const { instantiate } = WebAssembly;
  let found: WebAssembly.Memory | null = null;
  const watched = async (...args: Parameters<typeof instantiate>) => {
    const result = (await instantiate(...args)) as object;
    const { exports } =
      'instance' in result
        ? (result.instance as WebAssembly.Instance)
        : (result as WebAssembly.Instance);
    found ??= exports.memory instanceof WebAssembly.Memory ? exports.memory : null;
    return result;
  };
  WebAssembly.instantiate = watched as typeof instantiate;
  try {
    await ready();
  } finally {
    WebAssembly.instantiate = instantiate;
  }
  return found;
}
