import {
  Bone,
  type BufferGeometry,
  Color,
  Float32BufferAttribute,
  MeshStandardMaterial,
  PlaneGeometry,
  Skeleton,
  SkinnedMesh,
  Sphere,
  SphereGeometry,
  Uint16BufferAttribute,
  Vector3,
} from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import type { Exhibit } from './Exhibit.js';

/** Of the circle that it walks, of its body, and between its joints, metres. */
const RADIUS = 3.7;
const LENGTH = 6.4;
const JOINT = 0.4;
const HEIGHT = 0.95;
/** Half its width. */
const WIDTH = 0.85;
/** Metres from the tip of the tail to where the back is level: the way up. */
const TAIL = 2.8;
/** Radians a second along its circle: 0.4 m/s. */
const PACE = 0.11;
/** How far it sways and humps, metres. */
const SWAY = 0.16;
const HUMP = 0.05;

const COLORS = {
  band: new Color('#70aaa4'),
  stripe: new Color('#f2e3bf'),
  belly: new Color('#d88763'),
  foot: new Color('#3a3532'),
  eye: new Color('#fbf0d8'),
};

export interface Creature extends Exhibit {
  readonly object: SkinnedMesh;
  /** The joint nearest to that many metres from the tip of the tail. */
  joint(along: number): Bone;
}

/** A caterpillar as long as a car, that humps and sways on its way round: a skin on seventeen bones. */
export function createCreature(): Creature {
  const bones = Array.from({ length: Math.round(LENGTH / JOINT) + 1 }, (_, i) => {
    const bone = new Bone();
    bone.position.z = i * JOINT;
    bone.updateMatrixWorld();
    return bone;
  });
  const skeleton = new Skeleton(bones);
  const mesh = new SkinnedMesh(
    mergeGeometries([createBody(), ...createFeet(), ...createFace()]),
    new MeshStandardMaterial({ vertexColors: true, roughness: 0.75 }),
  );
  mesh.name = 'creature';
  mesh.castShadow = mesh.receiveShadow = true;
  mesh.bind(skeleton);
  mesh.add(...bones);
  const middle = LENGTH / 2 / RADIUS;
  mesh.boundingSphere = new Sphere(
    new Vector3(RADIUS * Math.cos(middle), HEIGHT / 2, RADIUS * Math.sin(middle)),
    LENGTH / 2 + 0.9,
  );
  const creature: Creature = {
    object: mesh,
    joint: (along) => bones[Math.round(along / JOINT)]!,
    update(time) {
      // Head first: angles grow toward the head, and a turn about +Y by a negative angle lets them grow in time.
      mesh.rotation.y = -PACE * time;
      bones.forEach((bone, i) => {
        const angle = (i * JOINT) / RADIUS;
        const wave = 1.5 * time - 0.75 * i;
        const away = RADIUS + SWAY * Math.sin(wave * 0.5);
        const up = HUMP * (1 - Math.cos(wave)) * Math.min(1, i / 5);
        bone.position.set(away * Math.cos(angle), up, away * Math.sin(angle));
        bone.rotation.y = -angle;
      });
    },
  };
  creature.update!(0);
  return creature;
}

/** How high its back is, `along` metres from the tip of its tail. */
function heightAt(along: number): number {
  const rising = Math.min(1, along / TAIL);
  return 0.06 + (HEIGHT - 0.06) * rising * (2 - rising) * 0.5 + (HEIGHT - 0.06) * 0.5 * rising;
}

/** A tube with a flat top, from the tip of the tail to the neck, along +Z. */
function createBody(): BufferGeometry {
  const [around, rings] = [24, 64];
  const body = new PlaneGeometry(1, 1, around, rings);
  const { position } = body.attributes;
  const colors: number[] = [];
  for (let i = 0; i < position!.count; i++) {
    const turn = (i % (around + 1)) / around;
    const ring = Math.floor(i / (around + 1)) / rings;
    const along = ring * LENGTH;
    // The last ring closes the neck; the head hides it.
    const neck = ring === 1 ? 0 : Math.min(1, 4 * (1 - ring) + 0.55);
    const angle = -2 * Math.PI * turn;
    const flat = (value: number) => Math.sign(value) * Math.abs(value) ** 0.55;
    const half = heightAt(along) / 2;
    const wide = WIDTH * Math.min(1, 0.25 + 0.75 * Math.sqrt(along / TAIL));
    position!.setXYZ(
      i,
      neck * wide * flat(Math.sin(angle)),
      half - neck * half * flat(Math.cos(angle)) + 0.05,
      along,
    );
    const below = -Math.cos(angle) < -0.35;
    const striped = (along / JOINT) % 2 < 0.55;
    const color = below ? COLORS.belly : striped ? COLORS.stripe : COLORS.band;
    colors.push(color.r, color.g, color.b);
  }
  body.setAttribute('color', new Float32BufferAttribute(colors, 3));
  body.computeVertexNormals();
  return skinned(body);
}

/** Pairs of stubby feet, each on its own joint. */
function createFeet(): BufferGeometry[] {
  const feet: BufferGeometry[] = [];
  for (let along = 2; along < LENGTH - 0.6; along += 2 * JOINT) {
    for (const side of [-1, 1]) {
      const foot = new SphereGeometry(0.2, 12, 8).scale(1, 0.75, 0.9);
      foot.translate(side * (WIDTH - 0.04), 0.15, along);
      feet.push(skinned(painted(foot, COLORS.foot), along));
    }
  }
  return feet;
}

/** A round head with two eyes and two feelers. */
function createFace(): BufferGeometry[] {
  const at = LENGTH - 0.2;
  const head = new SphereGeometry(0.72, 28, 20).scale(1.05, 0.95, 0.85).translate(0, 0.82, at);
  const parts = [painted(head, COLORS.band)];
  for (const side of [-1, 1]) {
    const ball = new SphereGeometry(0.17, 16, 12).translate(side * 0.3, 1.08, at + 0.5);
    const pupil = new SphereGeometry(0.09, 12, 8).translate(side * 0.31, 1.1, at + 0.61);
    const cheek = new SphereGeometry(0.1, 12, 8).scale(1, 0.7, 0.4);
    cheek.rotateY(side * 0.65).translate(side * 0.45, 0.74, at + 0.53);
    const feeler = new SphereGeometry(0.05, 8, 8).scale(1, 6, 1).rotateZ(-side * 0.4);
    feeler.translate(side * 0.38, 1.62, at - 0.05);
    const knob = new SphereGeometry(0.11, 12, 8).translate(side * 0.5, 1.92, at - 0.05);
    parts.push(
      painted(ball, COLORS.eye),
      painted(pupil, COLORS.foot),
      painted(cheek, COLORS.belly),
      painted(feeler, COLORS.foot),
      painted(knob, COLORS.belly),
    );
  }
  return parts.map((part) => skinned(part, LENGTH - JOINT));
}

function painted(geometry: BufferGeometry, { r, g, b }: Color): BufferGeometry {
  const { count } = geometry.attributes.position!;
  const colors = Array.from({ length: count }, () => [r, g, b]).flat();
  return geometry.setAttribute('color', new Float32BufferAttribute(colors, 3));
}

/** Hangs every vertex on the two joints around it, or all of them on the joint at `along`. */
function skinned(geometry: BufferGeometry, along?: number): BufferGeometry {
  const { position } = geometry.attributes;
  const last = Math.round(LENGTH / JOINT);
  const joints: number[] = [];
  const weights: number[] = [];
  for (let i = 0; i < position!.count; i++) {
    const at = Math.min(last, Math.max(0, (along ?? position!.getZ(i)) / JOINT));
    const joint = along === undefined ? Math.min(last - 1, Math.floor(at)) : Math.round(at);
    const part = along === undefined ? at - joint : 0;
    joints.push(joint, Math.min(last, joint + 1), 0, 0);
    weights.push(1 - part, part, 0, 0);
  }
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(joints, 4));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
  return geometry;
}
