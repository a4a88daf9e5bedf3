import type { BufferGeometry } from 'three';
import { MeshBvhWalker } from '../rivals/MeshBvhWalker.js';
import { OctreeWalker } from '../rivals/OctreeWalker.js';
import { RapierWalker } from '../rivals/RapierWalker.js';
import type { Walker } from '../rivals/Walker.js';

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
