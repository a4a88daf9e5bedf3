import { Euler, Matrix4, Object3D, Quaternion, Vector3 } from 'three';
import { ANKLE, HEEL, HIP_WIDTH, JOINTS, SHIN, THIGH, TOE } from './skeleton.mjs';

const RADIANS = Math.PI / 180;

const ankleTarget = new Vector3();
const hip = new Vector3();
const way = new Vector3();
const pole = new Vector3();
const side = new Vector3();
const ahead = new Vector3();
const up = new Vector3();
const knee = new Vector3();
const basis = new Matrix4();
const turn = new Quaternion();
const euler = new Euler();

/**
 * The skeleton, to be posed: turns by degrees, and legs by where their feet are. Degrees about +X bend forward what
 * stands up and swing backward what hangs down.
 */
export class Rig {
  #joints = new Map();
  #root = new Object3D();

  constructor() {
    for (const { name, parent } of JOINTS) {
      const object = new Object3D();
      this.#joints.set(name, object);
      (this.#joints.get(parent) ?? this.#root).add(object);
    }
    this.reset();
  }

  joint(name) {
    return this.#joints.get(name);
  }

  /** Back to rest. */
  reset() {
    for (const { name, parent, at } of JOINTS) {
      const from = JOINTS.find((joint) => joint.name === parent)?.at ?? [0, 0, 0];
      const joint = this.joint(name);
      joint.position.set(...at.map((value, k) => value - from[k]));
      joint.quaternion.identity();
      joint.scale.set(1, 1, 1);
    }
  }

  /** Degrees about X, Y and Z, in the parent's frame, Y first, X last. */
  turn(name, x, y = 0, z = 0) {
    this.joint(name).quaternion.setFromEuler(
      euler.set(x * RADIANS, y * RADIANS, z * RADIANS, 'YXZ'),
    );
  }

  /** Moves the hips from where they rest, metres. */
  shift(x, y, z) {
    this.joint('hips').position.add(up.set(x, y, z));
  }

  /**
   * Bends a leg so that its foot is where it is told.
   *
   * @param sign 1 is left, -1 right
   * @param foot { ankle: [x, y, z] metres, pitch: the heel's lift, toes: their lift off the foot, splay: outward, degrees,
   *   knees: how far the knees point outward, degrees }
   * @returns how far the leg is stretched, 1 being straight; more is out of reach
   */
  place(sign, { ankle, pitch = 0, toes = 0, splay = 5, knees = 6 }) {
    const suffix = sign > 0 ? 'L' : 'R';
    const [upper, lower, foot] = ['upperLeg', 'lowerLeg', 'foot'].map((name) =>
      this.joint(name + suffix),
    );
    this.#root.updateMatrixWorld(true);
    hip.setFromMatrixPosition(upper.matrixWorld);
    ankleTarget.set(...ankle);
    way.subVectors(ankleTarget, hip);
    const stretch = way.length() / (THIGH + SHIN);
    const distance = Math.min(way.length(), (THIGH + SHIN) * 0.9999);
    way.normalize();
    const bend = Math.acos((THIGH ** 2 + distance ** 2 - SHIN ** 2) / (2 * THIGH * distance));
    pole.set(Math.sin(sign * knees * RADIANS), 0, Math.cos(knees * RADIANS));
    pole.addScaledVector(way, -pole.dot(way)).normalize();
    knee.copy(hip).addScaledVector(way, THIGH * Math.cos(bend));
    knee.addScaledVector(pole, THIGH * Math.sin(bend));
    this.#aim(upper, up.subVectors(hip, knee).normalize());
    this.#aim(lower, up.subVectors(knee, ankleTarget).normalize());
    turn.setFromEuler(euler.set(pitch * RADIANS, sign * splay * RADIANS, 0, 'YXZ'));
    this.#face(foot, turn);
    this.turn(`toes${suffix}`, -toes);
    return stretch;
  }

  /** Lets a joint's +Y point along `up` and its +Z toward `pole`, in the world. */
  #aim(joint, up) {
    side.crossVectors(up, pole).normalize();
    ahead.crossVectors(side, up);
    this.#face(joint, turn.setFromRotationMatrix(basis.makeBasis(side, up, ahead)));
  }

  #face(joint, world) {
    joint.parent.updateWorldMatrix(true, false);
    joint.parent.getWorldQuaternion(joint.quaternion).invert().multiply(world);
    joint.updateWorldMatrix(false, false);
  }
}

/**
 * A foot that touches the ground, for `Rig.place`: flat, on its toes (pitch > 0) or on its heel (pitch < 0).
 *
 * @param z of the point below the joint of the toes, were the foot flat
 */
export function planted(sign, z, { pitch = 0, x = HIP_WIDTH, splay = 5, knees }) {
  const [s, c] = [Math.sin(pitch * RADIANS), Math.cos(pitch * RADIANS)];
  // What it turns about, ahead of the ankle and above the sole.
  const [pivotAhead, pivotHeight] = pitch > 0 ? [TOE.ahead, TOE.height] : [-HEEL, 0.012];
  const back = (ANKLE - pivotHeight) * s - pivotAhead * c;
  const toes = Math.max(0, pitch);
  // How far that takes the ankle from where it is while the foot is flat.
  const forward = pivotAhead + back;
  const turn = splay * RADIANS;
  return {
    ankle: [
      sign * (x + forward * Math.sin(turn)),
      ankleAbove(pitch, toes),
      z - TOE.ahead * Math.cos(turn) + forward * Math.cos(turn),
    ],
    pitch,
    toes,
    splay,
    knees,
  };
}

/** Points of the sole's edge, ahead of the ankle and above the ground, while it stands flat; the last two are the toes'. */
const SOLE = [
  [-0.048, 0],
  [-0.099, 0.012],
  [TOE.ahead, 0],
  [0.162, 0],
  [0.213, 0.012],
];

/** How high the ankle is while the lowest point of its foot touches the ground, metres. */
export function ankleAbove(pitch, toes) {
  const lowest = SOLE.map(([ahead, height], i) => {
    if (i > 2) [ahead, height] = about([TOE.ahead, TOE.height], [ahead, height], -toes);
    return about([0, ANKLE], [ahead, height], pitch)[1];
  });
  return ANKLE - Math.min(...lowest);
}

/** [ahead, height] turned about another such point, degrees, toes down. */
function about([a, h], [ahead, height], degrees) {
  const [s, c] = [Math.sin(degrees * RADIANS), Math.cos(degrees * RADIANS)];
  return [a + (ahead - a) * c + (height - h) * s, h + (height - h) * c - (ahead - a) * s];
}
