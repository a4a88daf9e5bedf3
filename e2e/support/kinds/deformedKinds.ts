import {
  AnimationClip,
  AnimationMixer,
  Bone,
  type BufferGeometry,
  CapsuleGeometry,
  DetachedBindMode,
  Float32BufferAttribute,
  Group,
  Mesh,
  QuaternionKeyframeTrack,
  Skeleton,
  SkinnedMesh,
  Uint16BufferAttribute,
  VectorKeyframeTrack,
} from 'three';
import { type Kind, lump, type MakeKind, plain } from './Kind.js';

const BONES = 4;
const LENGTH = 0.6;

/** A limb along y, each of its vertices between two bones. */
function limb(): BufferGeometry {
  const geometry = new CapsuleGeometry(0.12, LENGTH, 4, 8, 10);
  const { count } = geometry.attributes.position!;
  const indices = new Uint16Array(4 * count);
  const weights = new Float32Array(4 * count);
  for (let i = 0; i < count; i++) {
    const along = (geometry.attributes.position!.getY(i) / LENGTH + 0.5) * (BONES - 1);
    const bone = Math.min(BONES - 2, Math.max(0, Math.floor(along)));
    const next = Math.min(1, Math.max(0, along - bone));
    indices.set([bone, bone + 1], 4 * i);
    weights.set([1 - next, next], 4 * i);
  }
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
  return geometry;
}

/** A limb that bends as its clip is played; bound where it was placed, away from the origin. */
function skin(detached: boolean, geometry = limb()): Kind {
  const bones = Array.from({ length: BONES }, (_, i) => {
    const bone = new Bone();
    bone.name = `bone${i}`;
    bone.position.y = i === 0 ? -LENGTH / 2 : LENGTH / (BONES - 1);
    return bone;
  });
  for (let i = 1; i < BONES; i++) bones[i - 1]!.add(bones[i]!);
  const mesh = new SkinnedMesh(geometry, plain);
  const object = new Group();
  // A detached skin's bones hang elsewhere, and only they say what becomes of it.
  if (detached) mesh.bindMode = DetachedBindMode;
  else mesh.add(bones[0]!);
  object.add(mesh);
  const rig = detached ? bones[0]! : object;
  object.updateMatrixWorld();
  bones[0]!.updateMatrixWorld(true);
  mesh.bind(new Skeleton(bones));
  const turn = (name: string, angle: number) =>
    new QuaternionKeyframeTrack(
      `${name}.quaternion`,
      [0, 1],
      [0, 0, 0, 1, Math.sin(angle / 2), 0, 0, Math.cos(angle / 2)],
    );
  const clip = new AnimationClip('bend', 1, [
    turn('bone1', 1.2),
    turn('bone2', 1.5),
    new VectorKeyframeTrack('bone3.position', [0, 1], [0, 0.2, 0, 0.15, 0.3, 0]),
  ]);
  const mixer = new AnimationMixer(rig);
  mixer.clipAction(clip).play();
  const play = (seconds: number) => {
    mixer.update(seconds);
    // Bones that hang in no scene are the user's to update.
    if (detached) bones[0]!.updateMatrixWorld(true);
  };
  play(0.37);
  return { object, shown: () => [{ mesh }], change: () => play(0.51) };
}

/** Two targets: one wider, one bent aside. */
export function withTargets(geometry: BufferGeometry, relative: boolean): BufferGeometry {
  const { array } = geometry.attributes.position!;
  const base = relative ? 0 : 1;
  const wide = Float32Array.from(
    array,
    (value, i) => base * value + (i % 3 === 1 ? 0 : 0.6 * value),
  );
  const bent = Float32Array.from(array, (value, i) =>
    i % 3 === 0 ? base * value + 0.8 * array[i + 1]! : base * value,
  );
  geometry.morphAttributes.position = [wide, bent].map((to) => new Float32BufferAttribute(to, 3));
  geometry.morphTargetsRelative = relative;
  geometry.computeBoundingSphere();
  return geometry;
}

function morph(relative: boolean): Kind {
  const mesh = new Mesh(withTargets(lump(), relative), plain);
  mesh.morphTargetInfluences = [0.7, 0.2];
  return {
    object: mesh,
    shown: () => [{ mesh }],
    change: () => mesh.morphTargetInfluences!.splice(0, 2, 0.1, 0.8),
  };
}

/** What moves its vertices between draws, unseen by the processor. */
export const deformedKinds: Record<string, MakeKind> = {
  'SkinnedMesh, attached': () => skin(false),
  'SkinnedMesh, detached': () => skin(true),

  'SkinnedMesh with morph targets': () => {
    const kind = skin(false, withTargets(limb(), true));
    const [{ mesh }] = kind.shown() as [{ mesh: Mesh }];
    mesh.morphTargetInfluences = [0.4, 0.3];
    return {
      ...kind,
      change: () => {
        kind.change();
        mesh.morphTargetInfluences = [0, 0.6];
      },
    };
  },

  'Morph targets, relative': () => morph(true),
  'Morph targets, absolute': () => morph(false),
};
