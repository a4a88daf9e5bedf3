// Every clip: poses sampled at equal times, kept where something moves.

import { JOINTS } from './skeleton.mjs';
import { Rig, planted } from './Rig.mjs';
import { RUN, SNEAK, WALK, stride } from './gait.mjs';

const rig = new Rig();
const wave = (phase, shift = 0) => Math.sin(2 * Math.PI * (phase + shift));
const mix = (a, b, t) => a + (b - a) * t;

/** A pose's arms, both alike: degrees forward, outward, of the elbow. */
function arms(forward, out, elbow, turnedIn = 0) {
  for (const [suffix, sign] of [
    ['L', 1],
    ['R', -1],
  ]) {
    rig.turn(`upperArm${suffix}`, -forward, -sign * turnedIn, sign * out);
    rig.turn(`lowerArm${suffix}`, -elbow, -sign * 12, 0);
    rig.turn(`hand${suffix}`, -8, 0, -sign * 6);
  }
}

/** Stands and breathes, shifts its weight, looks about; its feet stay where they are. */
function idle(t) {
  const breath = wave(2 * t);
  const weight = wave(t);
  rig.shift(0.014 * weight, -0.02 + 0.004 * breath - 0.004 * weight * weight, -0.004);
  rig.turn('hips', 1, 2 * weight, -1.4 * weight);
  rig.turn('spine', 0.5 - 0.6 * breath, 0, 1 * weight);
  rig.turn('chest', -1 - 1.4 * breath, -1.5 * weight, 0.8 * weight);
  // It looks left, and back, then right.
  const glance = wave(t, -0.08) * Math.abs(wave(t, -0.08));
  rig.turn('head', 0.5 + 1.6 * breath, 11 * glance, 3 * wave(t, 0.1));
  rig.turn('antenna', -3 + 3 * wave(2 * t, -0.2), 0, 5 * wave(t, -0.15));
  arms(2 + 1.5 * breath, 9 + 1.2 * breath, 15 + 2 * breath, 4);
  for (const sign of [1, -1])
    rig.place(sign, planted(sign, 0.115, { x: 0.115, splay: 9, knees: 9 }));
}

/** Down on its heels, ready. */
function crouch(t) {
  const breath = wave(2 * t);
  rig.shift(0.006 * wave(t), -0.48 + 0.006 * breath, -0.13);
  rig.turn('hips', 26, 0, 0);
  rig.turn('spine', 20 - breath, 0, 0);
  rig.turn('chest', 16 - 1.2 * breath, 0, 0);
  rig.turn('head', -54 + 2 * breath, 9 * wave(t, -0.08), 0);
  rig.turn('antenna', -88 + 3 * wave(2 * t, -0.2), 0, 4 * wave(t));
  arms(36 + 2 * breath, 18, 58, 14);
  for (const sign of [1, -1]) {
    const ahead = sign > 0 ? 0.2 : 0.02;
    const pitch = sign > 0 ? 0 : 26;
    rig.place(sign, planted(sign, ahead, { pitch, x: 0.13, splay: 12, knees: 34 }));
  }
}

/** From the push of the toes to the top of the leap. */
function jump(t) {
  const rise = Math.sin((Math.PI / 2) * Math.min(1, t * 1.25));
  rig.shift(0, mix(-0.02, 0.02, rise), 0);
  rig.turn('hips', mix(10, 3, rise));
  rig.turn('spine', mix(5, -4, rise));
  rig.turn('chest', mix(6, -6, rise));
  rig.turn('head', mix(-14, -6, rise));
  rig.turn('antenna', mix(-4, 24, Math.sin(Math.PI * t * 0.8)));
  arms(mix(-38, 62, rise), mix(16, 38, rise), mix(18, 44, rise), 0);
  // One knee comes up, the other leg trails.
  const lead = {
    ankle: [0.1, mix(0.215, 0.4, rise), mix(-0.06, 0.1, rise)],
    pitch: mix(50, 16, rise),
  };
  const trail = {
    ankle: [-0.1, mix(0.22, 0.26, rise), mix(-0.1, -0.2, rise)],
    pitch: mix(50, 58, rise),
  };
  rig.place(1, { ...lead, toes: 4 });
  rig.place(-1, { ...trail, toes: 0 });
}

/** Hangs in the air, arms out, legs treading a little. */
function fall(t) {
  const tread = wave(t);
  rig.shift(0, 0.01, 0);
  rig.turn('hips', 6, 3 * tread, 2 * tread);
  rig.turn('spine', 3);
  rig.turn('chest', -3, -4 * tread, 0);
  rig.turn('head', 12, 0, -2 * tread);
  rig.turn('antenna', 20 + 10 * wave(2 * t), 0, 6 * tread);
  for (const [suffix, sign] of [
    ['L', 1],
    ['R', -1],
  ]) {
    const flap = wave(2 * t, sign > 0 ? 0 : 0.12);
    rig.turn(`upperArm${suffix}`, -14 - 6 * sign * tread, 0, sign * (72 + 9 * flap));
    rig.turn(`lowerArm${suffix}`, -22, -sign * 12, sign * 22);
    rig.turn(`hand${suffix}`, -6, 0, sign * 14);
  }
  rig.place(1, { ankle: [0.13, 0.3 + 0.03 * tread, 0.12 - 0.03 * tread], pitch: 18, knees: 10 });
  rig.place(-1, { ankle: [-0.13, 0.22 - 0.03 * tread, -0.1 + 0.03 * tread], pitch: 38, knees: 10 });
}

/** Takes the landing with its knees and comes up again. */
function land(t) {
  const lowest = 0.28;
  const deep =
    t < lowest
      ? mix(0.18, 1, Math.sin((Math.PI / 2) * (t / lowest)))
      : 0.5 + 0.5 * Math.cos(Math.PI * Math.min(1, (t - lowest) / 0.62));
  rig.shift(0, -0.02 - 0.2 * deep, -0.05 * deep);
  rig.turn('hips', 1 + 15 * deep);
  rig.turn('spine', 1 + 10 * deep);
  rig.turn('chest', -1 + 8 * deep);
  rig.turn('head', 0.5 - 22 * deep);
  rig.turn('antenna', -3 - 34 * Math.sin(Math.PI * Math.min(1, t * 1.6)));
  arms(mix(2, -24, deep), mix(13, 42, deep), mix(15, 34, deep), 4);
  for (const sign of [1, -1])
    rig.place(sign, planted(sign, 0.115, { x: 0.125, splay: 10, knees: 9 + 8 * deep }));
}

/** Its eyes are shut for a moment, seconds from the clip's start. */
const BLINKS = [1.1, 3.35];
const BLINK = 0.07;

/** So many keys that touch-down and take-off each fall on one. */
const cycle = (name, gait, keys) => ({
  name,
  duration: gait.duration,
  keys,
  pose: (t) => stride(rig, t, gait),
});

const CLIPS = [
  { name: 'idle', duration: 4.2, keys: 30, pose: idle, blinks: BLINKS },
  cycle('walk', WALK, 32),
  cycle('run', RUN, 40),
  { name: 'jump', duration: 0.34, keys: 10, pose: jump },
  { name: 'fall', duration: 0.9, keys: 18, pose: fall },
  { name: 'land', duration: 0.36, keys: 18, pose: land },
  { name: 'crouch', duration: 3.6, keys: 20, pose: crouch, blinks: [1.9] },
  cycle('sneak', SNEAK, 28),
];

/** What feet hang on. */
const EXACT = /^hips|Leg|foot|toes/;
const same = (a, b) => Math.abs(a - b) < 1e-6;

/** @returns every clip: { name, tracks: [{ joint, path, times, values }] } */
export function clips() {
  return CLIPS.map(sample);
}

function sample({ name, duration, keys, pose, blinks }) {
  const times = Array.from({ length: keys + 1 }, (_, i) => (duration * i) / keys);
  const clocks = { 1: times, 2: times.filter((_, i) => i % 2 === 0), [keys]: [0, duration] };
  const turns = new Map(JOINTS.map((joint) => [joint.name, []]));
  const shifts = [];
  for (let i = 0; i <= keys; i++) {
    rig.reset();
    const stretch = pose(i / keys);
    if (stretch > 1) {
      throw new Error(`${name}: the leg is too short at ${i}/${keys}: ${stretch.toFixed(3)}.`);
    }
    for (const [joint, values] of turns) {
      const { x, y, z, w } = rig.joint(joint).quaternion;
      // The shorter way to the next key.
      const last = values.slice(-4);
      const sign =
        last.length > 0 && last[0] * x + last[1] * y + last[2] * z + last[3] * w < 0 ? -1 : 1;
      values.push(sign * x, sign * y, sign * z, sign * w);
    }
    shifts.push(...rig.joint('hips').position.toArray());
  }
  const tracks = [...turns]
    .filter(([, values]) => values.some((value, i) => !same(value, i % 4 === 3 ? 1 : 0)))
    .map(([joint, values]) => {
      // The two ends are enough for what only holds still, every other key for what need not be exact.
      const holds = values.every((value, i) => same(value, values[i % 4]));
      const few = holds ? keys : EXACT.test(joint) ? 1 : 2;
      return {
        joint,
        path: 'rotation',
        times: clocks[few],
        values: values.filter((_, i) => (i >> 2) % few === 0),
      };
    });
  tracks.push({ joint: 'hips', path: 'translation', times, values: shifts });
  if (blinks) tracks.push(blinking(blinks, duration));
  return { name, tracks };
}

function blinking(blinks, duration) {
  const keys = [
    [0, 1],
    ...blinks.flatMap((at) => [
      [at - BLINK, 1],
      [at, 0.08],
      [at + BLINK, 1],
    ]),
    [duration, 1],
  ];
  return {
    joint: 'eyes',
    path: 'scale',
    times: keys.map(([time]) => time),
    values: keys.flatMap(([, open]) => [1, open, 1]),
  };
}
