import type { BufferGeometry } from 'three';
import type { CubeCollider } from 'three-cube-collider';
import type { Walker } from '../../bench/rivals/Walker.js';

export type ContestantId = 'cube' | 'octree' | 'bvh' | 'rapier';
export type RivalId = Exclude<ContestantId, 'cube'>;

/** A rival, ready to walk. */
export interface Built {
  walker: Walker;
  /** Bytes that it keeps. */
  bytes: number;
}

export interface Contestant {
  name: string;
  /** What it answers from, in a word. */
  of: string;
  /** In plain words. */
  cannot: string;
}

export interface Rival extends Contestant {
  /** Longest frame that its own example lives through at once, seconds. */
  longest: number;
  /** Gap that it keeps to the ground, metres. */
  skin: number;
  /** Fetches its code, then builds it, of one geometry in world space. */
  build(geometry: BufferGeometry): Promise<Built>;
}

const HOLES = 'Cannot see what moves by skin, morph or shader, nor the hole in the fence;';

export const OURS: Contestant = {
  name: 'Cube collider',
  of: 'cubemap',
  cannot: 'Solid is what is drawn. Cannot push bodies, nor cast long rays.',
};

/** Each as its own example or guide drives it; its code comes when it is first asked for. */
export const RIVALS: Readonly<Record<RivalId, Rival>> = {
  octree: {
    name: 'Octree',
    of: 'tree',
    cannot: `${HOLES} what moves otherwise means building it anew.`,
    longest: 0.05,
    skin: 0,
    async build(geometry) {
      const { OctreeWalker } = await import('../../bench/rivals/OctreeWalker.js');
      const walker = new OctreeWalker(geometry);
      return { walker, bytes: walker.bytes };
    },
  },
  bvh: {
    name: 'three-mesh-bvh',
    of: 'tree',
    cannot: `${HOLES} skins and lifts only with a tree for each, refitted by you.`,
    longest: 0.1,
    skin: 0,
    async build(geometry) {
      const { MeshBvhWalker } = await import('../../bench/rivals/MeshBvhWalker.js');
      const walker = new MeshBvhWalker(geometry);
      return { walker, bytes: walker.bytes };
    },
  },
  rapier: {
    name: 'Rapier',
    of: 'world',
    cannot: `${HOLES} lifts only with a body for each, moved by you.`,
    longest: 0.1,
    skin: 0.01,
    async build(geometry) {
      const [{ RapierWalker }, { rapierMemory }] = await Promise.all([
        import('../../bench/rivals/RapierWalker.js'),
        import('../../bench/rivals/rapierMemory.js'),
      ]);
      const memory = await rapierMemory();
      const before = memory?.buffer.byteLength ?? 0;
      const walker = await RapierWalker.create(geometry);
      return { walker, bytes: memory === null ? NaN : memory.buffer.byteLength - before };
    },
  },
};

/** Of JavaScript's heap, as `npm run bench -- load` measures it for levels of this size. */
const OUR_HEAP = 4.5e6;
/** Of the finer picture: RGBA32F, RG32UI and depth. Of the atlas and two reads of it: as much colour and numbers. */
const FINE_TEXEL = 16 + 8 + 4;
const READ_TEXEL = 16 + 8 + 2 * (16 + 16);

/** Bytes that ours keeps, on the GPU too. */
export function ourBytes({ resolution, supersample }: CubeCollider): number {
  const texels = 6 * resolution * resolution;
  const fine = supersample > 1 ? texels * supersample ** 2 * FINE_TEXEL : 4 * texels;
  return OUR_HEAP + fine + texels * READ_TEXEL;
}
