import { Skeleton, type SkinnedMesh } from 'three/webgpu';
import type { ObjectProxy } from '../collider/objectProxy.js';

interface OwnSkeleton extends Skeleton {
  /** How many it was made for. */
  readonly count: number;
}

/** Of each skeleton, one for all cubemaps. */
const skeletons = new WeakMap<Skeleton, OwnSkeleton>();

const nothing = () => {};

/**
 * Gives the proxy of a skinned mesh bone matrices of its own, as its bones are now. three updates a skeleton once a
 * frame: done for us, before the user has posed it, the user's picture would show the pose of the frame before; and
 * posed anew in the same frame, it would not be drawn so for us.
 */
export function giveOwnSkeleton(proxy: ObjectProxy): void {
  const { isSkinnedMesh, skeleton } = proxy.source as Partial<SkinnedMesh>;
  if (isSkinnedMesh !== true || !skeleton) return;
  let own = skeletons.get(skeleton);
  if (own === undefined || own.count !== skeleton.bones.length) {
    skeletons.set(skeleton, (own = createOwnSkeleton(skeleton)));
  }
  const posed = proxy as unknown as { skeleton: Skeleton };
  if (posed.skeleton !== own) posed.skeleton = own;
  Skeleton.prototype.update.call(own);
}

/** Bones and their inverses are the user's, live. */
function createOwnSkeleton(source: Skeleton): OwnSkeleton {
  const own = <T>(value: T) => ({ value, writable: true, enumerable: true, configurable: true });
  return Object.create(source, {
    count: own(source.bones.length),
    boneMatrices: own(new Float32Array(16 * source.bones.length)),
    boneTexture: own(null),
    previousBoneMatrices: own(null),
    previousBoneTexture: own(null),
    // Not by three.
    update: own(nothing),
  }) as OwnSkeleton;
}
