import { Object3D, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { seeded } from '../../../e2e/support/axisScenes.js';
import { tries } from '../../support/soak.js';
import { room } from '../../support/world/scenes.js';
import { World } from '../../support/world/World.js';
import { WorldWalker } from '../../support/world/WorldWalker.js';

const RATES = [20, 30, 60, 144];

/** One try: a run of some kind at the 1 cm plates around a room, turned anyhow. Says what went wrong, or nothing. */
function run(seed: number, how: 'walk' | 'move' | 'fall', latency: number): string | null {
  const random = seeded(seed);
  const between = (low: number, high: number) => low + (high - low) * random();
  const speed = 5 * 20 ** random();
  const half = [between(1.1, 6), between(1.1, how === 'fall' ? 6 : 2), between(1.1, 6)] as const;
  const pivot = new Object3D();
  // Upright rooms two times in three; the rest stand on an edge or a corner.
  pivot.quaternion.setFromAxisAngle(new Vector3(0, 1, 0), between(-Math.PI, Math.PI));
  if (random() < 1 / 3) {
    const tilt = new Vector3(between(-1, 1), 0, between(-1, 1)).normalize();
    pivot.quaternion.premultiply(new Quaternion().setFromAxisAngle(tilt, between(0, Math.PI)));
  }
  pivot.position.set(between(-50, 50), between(-50, 50), between(-50, 50));
  const world = new World();
  world.root.add(pivot);
  const solids = room(...half);
  for (const { object } of solids) pivot.add(object);
  world.add(...solids);
  const rate = RATES[Math.floor(4 * random())]!;
  const walker = new WorldWalker(world, {
    rate,
    latency,
    resolution: random() < 0.8 ? 16 : 32,
    judged: false,
    foot: [pivot.position.x, pivot.position.y - 0.9, pivot.position.z],
    character: how === 'fall' ? { gravity: 10 * speed, terminalSpeed: speed } : {},
  });
  const yaw = between(-Math.PI, Math.PI);
  const pitch = how === 'move' ? between(-1.5, 1.5) : 0;
  const flat = speed * Math.cos(pitch);
  const velocity = new Vector3(flat * Math.cos(yaw), speed * Math.sin(pitch), flat * Math.sin(yaw));
  if (how === 'walk') walker.walk(velocity.x, velocity.z);
  if (how === 'fall') walker.walk(velocity.x / 10, velocity.z / 10);
  const frames = Math.ceil(rate * (0.08 + 6 / speed)) + 3 * latency;
  const inRoom = new Vector3();
  for (let i = 0; i < frames; i++) {
    if (how === 'move') walker.character.move(velocity.clone().divideScalar(rate));
    walker.frame();
    for (const height of [0.35, 0.9, 1.45]) {
      inRoom.copy(walker.character.body.position);
      inRoom.y += height;
      pivot.worldToLocal(inRoom);
      const out = Math.max(
        Math.abs(inRoom.x) - half[0],
        Math.abs(inRoom.y) - half[1],
        Math.abs(inRoom.z) - half[2],
      );
      if (!(out < 0)) {
        return `seed ${seed}: ${how} at ${speed.toFixed(1)} m/s is ${out.toFixed(3)} m out, ${walker.story}`;
      }
    }
  }
  return null;
}

describe.each(['walk', 'move', 'fall'] as const)('a %s at 1 cm of wall and floor', (how) => {
  it.each([0, 1, 2, 3])('should never lead through, fields %i frames late', (latency) => {
    const failures: string[] = [];
    for (let i = 0; i < tries(25, 834); i++) {
      const failure = run(1000 * latency + i, how, latency);
      if (failure !== null) failures.push(failure);
    }
    expect(failures.slice(0, 5), `${failures.length} through`).toEqual([]);
  });
});
