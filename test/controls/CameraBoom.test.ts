import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { CameraBoom } from '../../src/controls/CameraBoom.js';
import { bytesEach } from '../support/bytesEach.js';
import { BoomWalk, type BoomWalkOptions } from '../support/boomWalk.js';
import { dice } from '../support/fields.js';
import { block, ground, pole, wall } from '../support/world/scenes.js';
import { World } from '../support/world/World.js';
import { WorldCollider } from '../support/world/WorldCollider.js';

/** Two rooms with a door between and one to the outside, two columns, a chest; ceilings 2.4 m high. */
const house = () =>
  new World(
    ground(),
    block([-5, 0, -5.1], [5, 3, -5], 'north'),
    block([-5, 0, 5], [5, 3, 5.1], 'south'),
    block([-5.1, 0, -5], [-5, 3, 5], 'west'),
    block([5, 0, -5], [5.1, 3, -0.6], 'east'),
    block([5, 0, 0.6], [5.1, 3, 5], 'east, too'),
    block([-5, 0, -0.1], [-0.6, 3, 0.1], 'between'),
    block([0.6, 0, -0.1], [5, 3, 0.1], 'between, too'),
    block([-5, 2.4, -5], [5, 2.6, 5], 'ceiling'),
    block([2.5, 0, 2], [3.2, 1.2, 2.8], 'chest'),
    pole(-2, 2.5, 0.2),
    pole(2, -2.5, 0.3),
  );

/** Walks to and fro in it, looking all around, up and down. */
function stroll(seconds: number, seed: number, options: BoomWalkOptions = {}): BoomWalk {
  const roll = dice(seed);
  const walk = new BoomWalk(house(), { foot: [0, 0.02, 2.5], ...options });
  let until = 0;
  let turning = 0;
  let heading = 0;
  return walk.run(seconds, (time, velocity) => {
    if (time >= until) {
      until += roll(0.3, 1.5);
      turning = roll(-3, 3);
      heading = roll(0, 2 * Math.PI);
    }
    walk.controls.yaw += turning / walk.rate;
    walk.controls.pitch = 0.6 * Math.sin(0.7 * time);
    velocity.set(4 * Math.sin(heading), 0, 4 * Math.cos(heading));
  });
}

/** Stands in the middle of nothing but a floor, a wall behind. */
function before(distance: number, options: BoomWalkOptions = {}): BoomWalk {
  return new BoomWalk(new World(ground(), wall(0, distance, Math.PI / 2)), options).run(2);
}

describe('CameraBoom', () => {
  // As fine as the real collider draws, which keeps the nearest of 4 × 4 texels.
  it.each([
    [1, { resolution: 64 }],
    [2, { resolution: 64, rate: 30 }],
    [3, { resolution: 64, latency: 6 }],
    [4, { resolution: 64, latency: 0 }],
  ])('should let nothing come between head and camera, seed %i, %o', (seed, options) => {
    const walk = stroll(4, seed, options);
    expect(walk.hidden).toBe(0);
    expect(walk.cut).toBe(0);
    // It does not hide in the head for that.
    console.log(
      `    given ${((100 * walk.given) / walk.frames).toFixed(0)} % of what a ray has free`,
    );
    expect(walk.given / walk.frames).toBeGreaterThan(0.6);
  });

  it('should be all of its length in the open, and stop before a wall', () => {
    expect(before(9).lengths.at(-1)).toBeCloseTo(4, 2);
    const { lengths, least } = before(2);
    expect(lengths.at(-1)).toBeGreaterThan(1.75);
    expect(lengths.at(-1)).toBeLessThan(2);
    // The ball around the near plane keeps 50 mm, and a part of a texel.
    expect(least).toBeGreaterThan(0.045);
    expect(least).toBeLessThan(0.1);
  });

  it('should hold still where it stands, and draw no more', () => {
    const walk = before(2).run(1);
    const { draws } = walk.eye;
    const length = walk.lengths.at(-1)!;
    walk.run(2);
    expect(walk.eye.draws).toBe(draws);
    for (const each of walk.lengths.slice(-120)) expect(each).toBeCloseTo(length, 4);
  });

  it('should glide along a wall as its plane does, however coarse its texels', () => {
    const walk = before(2, { resolution: 16 });
    const lengths: number[] = [];
    for (let i = 0; i < 90; i++) {
      walk.controls.yaw = -0.6 + 0.005 * i;
      walk.run(1 / 60);
      lengths.push(walk.lengths.at(-1)!);
    }
    // The plane 2 m away, less the ball's radius, along the boom; it may let out more slowly, but never jumps.
    for (let i = 1; i < lengths.length; i++) {
      expect(Math.abs(lengths[i]! - lengths[i - 1]!)).toBeLessThan(0.03);
    }
  });

  it('should pull in at once before what comes, and let out slowly when it goes', () => {
    const door = block([-3, 0, 1.4], [3, 3, 1.5], 'door');
    const walk = new BoomWalk(new World(ground(), door));
    door.object.position.y -= 10;
    walk.run(2);
    expect(walk.lengths.at(-1)).toBeCloseTo(4, 2);
    door.object.position.y += 10;
    walk.run(0.2);
    expect(walk.lengths.at(-1)).toBeLessThan(1.5);
    door.object.position.y -= 10;
    walk.run(0.2);
    expect(walk.lengths.at(-1)).toBeLessThan(2.5);
    walk.run(2);
    expect(walk.lengths.at(-1)).toBeCloseTo(4, 2);
  });

  it('should stay in the head until it has seen something, and in first person draw nothing', () => {
    const walk = new BoomWalk(house(), { foot: [0, 0.02, 2.5] });
    walk.run(1 / 60);
    expect(walk.lengths[0]).toBeLessThan(0.01);
    walk.controls.view = 'first';
    walk.run(1);
    const { draws } = walk.eye;
    walk.run(1, (_, velocity) => velocity.set(2, 0, 0));
    expect(walk.eye.draws).toBe(draws);
    expect(walk.lengths.at(-1)).toBeLessThan(0.05);
    walk.controls.view = 'third';
    walk.run(2);
    expect(walk.lengths.at(-1)).toBeGreaterThan(1);
    expect(walk.hidden).toBe(0);
  });

  it('should see as far as the boom is long, unless it was told how far', () => {
    const walk = before(9);
    expect(walk.eye.far).toBe(5);
    walk.controls.distance = 7;
    walk.run(3);
    expect(walk.eye.far).toBe(8);
    expect(walk.lengths.at(-1)).toBeGreaterThan(6.9);
    const short = before(9, { far: 2, autoFar: false });
    expect(short.eye.far).toBe(2);
    expect(short.lengths.at(-1)).toBeLessThan(2.01);
    expect(short.lengths.at(-1)).toBeGreaterThan(1.8);
  });

  it('should leave out the avatar', () => {
    const eye = new WorldCollider(house());
    const avatar = house().root;
    new CameraBoom(eye).ignore(avatar);
    expect(eye.excluded).toEqual([avatar]);
  });

  it('should refuse what is no collider of surfaces', () => {
    expect(() => new CameraBoom({} as never)).toThrow(/CameraBoom: "collider"/);
    const axis = Object.assign(Object.create(new WorldCollider(house())), { output: 'axis' });
    expect(() => new CameraBoom(axis)).toThrow(TypeError);
  });

  it('should make no object when it is asked', () => {
    const walk = stroll(1, 1);
    const head = walk.character.position.clone().setY(1.6);
    const direction = new Vector3(0.1, 0.2, 1).normalize();
    const each = bytesEach(2000, () => walk.boom.reach(head, direction, 4, 0.14));
    // It looks at some 250 places: an object for each would be 12,000 bytes and more. What is left are numbers that V8 wraps.
    expect(each).toBeLessThan(1000);
  });
});
