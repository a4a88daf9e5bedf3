// Walking and running: where the feet are at each moment of a cycle, and what the body does above them.

import { ankleAbove, planted } from './Rig.mjs';

const wave = (phase, shift = 0) => Math.sin(2 * Math.PI * (phase + shift));
const ease = (t) => t * t * (3 - 2 * t);
const part = (t, from, to) => ease(Math.min(1, Math.max(0, (t - from) / (to - from))));

/**
 * Where a foot is, `phase` 0…1 from the moment it touches the ground. On the ground it goes back at the ground's speed.
 *
 * @param gait { speed: m/s, duration: of a cycle, seconds, duty: part of it that a foot is on the ground, reach: how far
 *   ahead it touches down, metres, width: of the track, half, lift: of the swinging foot, metres, heel: degrees that the
 *   toes are up at touch-down, push: degrees that the heel is up at take-off, heelOff: when in the stance it begins to
 *   rise, follow, retract: part of the ground's speed that it has just off the ground, and that once more before it
 *   meets it, tuck: degrees that the swinging heel is thrown up, knees: degrees that they point outward }
 */
export function footOf(sign, phase, gait) {
  const { speed, duration, duty, width, lift, heel, push, knees } = gait;
  const stance = (t) => {
    const pitch = -heel * (1 - part(t, 0, 0.3)) + push * part(t, gait.heelOff, 1.06);
    return planted(sign, gait.reach - speed * duration * duty * t, { pitch, x: width, knees });
  };
  if (phase <= duty) return stance(phase / duty);

  const t = (phase - duty) / (1 - duty);
  const [from, to] = [stance(1), stance(0)];
  // Leaves the ground, and meets it, at nearly the speed that it has there.
  const seconds = duration * (1 - duty);
  const tangent = -speed * seconds * gait.follow;
  const [h0, h1] = [1 - ease(t), ease(t)];
  const z =
    h0 * from.ankle[2] +
    h1 * to.ankle[2] +
    tangent * (t * (1 - t) ** 2 + t * t * (t - 1) * gait.retract);
  const pitch =
    from.pitch +
    (to.pitch - from.pitch) * part(t, 0.2, 1) +
    gait.tuck * Math.sin(Math.PI * t) * (1 - t);
  const toes = from.toes * (1 - part(t, 0, 0.4));
  // As high as its lowest point wants, whatever its turn; at both ends as it is on the ground.
  const over = (foot) => foot.ankle[1] - ankleAbove(foot.pitch, foot.toes);
  const ends = over(from) * (1 - part(t, 0, 0.2)) + over(to) * part(t, 0.8, 1);
  const rise = lift * Math.sin(Math.PI * t ** 0.8);
  return {
    ...to,
    ankle: [to.ankle[0], ankleAbove(pitch, toes) + ends + rise, z],
    pitch,
    toes,
  };
}

/**
 * Poses the rig at a moment of a cycle that begins when the left foot touches down.
 *
 * @returns how far the leg on the ground is stretched, 1 being straight
 */
export function stride(rig, phase, gait) {
  const { body, arms } = gait;
  const step = 2 * phase;
  rig.reset();
  // Up and down twice a cycle, side to side and round about once.
  rig.shift(
    body.sway * wave(phase, 0.25 - gait.duty / 2),
    -body.low - body.bob * wave(step, body.bobAt),
    body.back,
  );
  const yaw = body.yaw * wave(phase, 0.25);
  const roll = body.roll * wave(phase, 0.25 - gait.duty / 2);
  rig.turn('hips', body.lean * 0.45, -yaw, roll);
  const nod = body.nod * wave(step, body.bobAt + 0.1);
  rig.turn('spine', body.lean * 0.3 + nod, yaw * 0.9, -roll * 0.7);
  rig.turn('chest', body.lean * 0.25 + body.hunch, yaw * 1.1, -roll * 0.5);
  rig.turn('head', -body.lean * 0.8 - body.hunch - nod * 1.5, -yaw, roll * 0.2);
  rig.turn('antenna', body.antenna[0] + body.antenna[1] * wave(step, body.bobAt + 0.2), 0, -roll);
  let stretch = 0;
  for (const sign of [1, -1]) {
    const own = (phase + (sign > 0 ? 0 : 0.5)) % 1;
    const foot = footOf(sign, own, gait);
    const length = rig.place(sign, foot);
    if (own <= gait.duty) stretch = Math.max(stretch, length);
    swing(rig, sign, own, arms);
  }
  return stretch;
}

/** An arm goes forward while the leg of its side goes back. */
function swing(rig, sign, phase, { reach, forward, out, elbow, pump, twist }) {
  const suffix = sign > 0 ? 'L' : 'R';
  const back = wave(phase, 0.25);
  rig.turn(`upperArm${suffix}`, reach * back - forward, -sign * twist, sign * out);
  rig.turn(`lowerArm${suffix}`, -elbow + pump * wave(phase, 0.2), -sign * 12, 0);
  rig.turn(`hand${suffix}`, -8 - 6 * back, 0, -sign * 6);
}

/** At the speeds of `CharacterControls`: its defaults are 3 and 6 m/s. */
export const WALK = {
  speed: 3,
  duration: 0.56,
  duty: 15 / 32,
  reach: 0.44,
  width: 0.085,
  lift: 0.06,
  heel: 16,
  push: 52,
  follow: 0.5,
  retract: 1.9,
  tuck: 20,
  knees: 4,
  heelOff: 0.42,
  body: {
    low: 0.06,
    bob: 0.022,
    bobAt: 0.2,
    sway: 0.016,
    yaw: 9,
    roll: 3,
    lean: 6,
    hunch: 0,
    back: 0,
    nod: 1.5,
    antenna: [-4, 9],
  },
  arms: { reach: 30, forward: 2, out: 11, elbow: 28, pump: 14, twist: 0 },
};

export const RUN = {
  speed: 6,
  duration: 0.5,
  duty: 11 / 40,
  reach: 0.48,
  width: 0.07,
  lift: 0.2,
  heel: 6,
  push: 60,
  follow: 0.45,
  retract: 1,
  tuck: 75,
  knees: 3,
  heelOff: 0.3,
  body: {
    low: 0.1,
    bob: 0.035,
    bobAt: 0.05,
    sway: 0.01,
    yaw: 13,
    roll: 4,
    lean: 15,
    hunch: 0,
    back: 0,
    nod: 2,
    antenna: [-16, 14],
  },
  arms: { reach: 46, forward: 0, out: 13, elbow: 82, pump: 18, twist: 8 },
};

export const SNEAK = {
  speed: 3,
  duration: 0.4,
  duty: 13 / 28,
  reach: 0.34,
  width: 0.13,
  lift: 0.05,
  heel: 4,
  push: 34,
  follow: 0.45,
  retract: 1,
  tuck: 6,
  knees: 26,
  heelOff: 0.42,
  body: {
    low: 0.45,
    bob: 0.012,
    bobAt: 0.2,
    sway: 0.02,
    yaw: 8,
    roll: 3,
    lean: 54,
    hunch: 10,
    nod: 1,
    back: -0.12,
    antenna: [-88, 6],
  },
  arms: { reach: 22, forward: 44, out: 18, elbow: 62, pump: 8, twist: 10 },
};
