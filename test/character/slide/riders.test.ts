import {
  Bone,
  Float32BufferAttribute,
  InstancedMesh,
  Matrix4,
  Mesh,
  type Object3D,
  PlaneGeometry,
  Skeleton,
  SkinnedMesh,
  Uint16BufferAttribute,
  Vector3,
} from 'three';
import { describe, expect, it } from 'vitest';
import { tries } from '../../support/soak.js';
import { listen } from '../../support/world/events.js';
import { block, Box, Cylinder, ground } from '../../support/world/scenes.js';
import type { Solid } from '../../support/world/Solid.js';
import { World } from '../../support/world/World.js';
import { WorldWalker, type WalkerOptions } from '../../support/world/WorldWalker.js';

type Place = readonly [number, number, number];

interface Ride {
  platform: () => Solid;
  /** Where the platform is after so many seconds. */
  drive: (platform: Solid, time: number) => void;
  /** Where the rider is put, in the world. */
  foot: Place;
}

const top = 0.1;
const lift: Ride = {
  platform: () => new Box(1.5, top, 1.5, 'lift'),
  drive: ({ object }, time) => object.position.set(0, 1.2 * Math.sin(1.3 * time), 0),
  foot: [0.3, top + 0.02, 0.2],
};
const turntable: Ride = {
  platform: () => new Cylinder(2, top, 'turntable'),
  drive: ({ object }, time) => object.rotation.set(0, time, 0),
  foot: [1.1, top + 0.02, 0],
};
const swing: Ride = {
  platform: () => new Box(1, top, 1, 'swing'),
  drive: ({ object }, time) => {
    const angle = 0.4 * Math.sin(1.5 * time);
    object.position.set(4 * Math.sin(angle), 4 - 4 * Math.cos(angle), 0);
  },
  foot: [0.2, top + 0.02, -0.1],
};
const RIDES: [string, Ride][] = [
  ['a lift', lift],
  ['a turntable', turntable],
  ['a swing', swing],
];

function riding({ platform, drive, foot }: Ride, options: WalkerOptions = {}) {
  const solid = platform();
  const walker = new WorldWalker(new World(ground(-9), solid), {
    foot,
    resolution: 16,
    drive: (time) => drive(solid, time),
    ...options,
  });
  const onPlatform = (foot: Vector3) => solid.object.worldToLocal(foot.clone());
  return { walker, solid, onPlatform };
}

describe.each(RIDES)('riding %s', (_, ride) => {
  it.each([
    [20, 0, 60],
    [60, 0, 60],
    [60, 2, tries(10, 60)],
    [144, 0, tries(10, 60)],
    [144, 3, tries(5, 60)],
  ])('should not slip by 1 cm at %i Hz, fields %i late, in %i s', (rate, latency, seconds) => {
    const { walker, onPlatform } = riding(ride, { rate, latency });
    walker.settle(1);
    const from = onPlatform(walker.drawn);
    let slip = 0;
    walker.run(seconds, () => {
      slip = Math.max(slip, onPlatform(walker.drawn).distanceTo(from));
    });
    const end = onPlatform(walker.drawn).distanceTo(from);
    expect(end, `in the end: ${walker.story}`).toBeLessThan(0.01);
    expect(slip, 'at the worst, as drawn').toBeLessThan(0.01);
    expect(walker.character.grounded).toBe(true);
    expect(walker.worstDrawn, walker.worstAt).toBeLessThan(0.01);
    expect(walker.crossings, walker.crossedAt).toBe(0);
  });

  it('should be able to walk about on it', () => {
    const { walker, onPlatform } = riding(ride);
    walker.settle(1);
    const from = onPlatform(walker.drawn);
    for (const sign of [1, -1]) walker.walk(0, sign).run(0.5);
    walker.walk(0).run(0.2);
    const off = onPlatform(walker.drawn).sub(from);
    // There and back in the world's axes, while a turntable turns on.
    expect(Math.abs(off.y)).toBeLessThan(0.01);
    expect(off.length()).toBeLessThan(_ === 'a turntable' ? 0.6 : 0.05);
    expect(walker.character.grounded).toBe(true);
  });
});

/** How a thing that bends, or an instance, is moved with a solid that stands for its surface. */
type Bending = (solid: Solid) => { shown: Object3D; follow: () => void };

const patch = () => new PlaneGeometry(3, 3, 12, 12).rotateX(-Math.PI / 2).translate(0, top, 0);

const skin: Bending = ({ object }) => {
  const geometry = patch();
  const { count } = geometry.attributes.position!;
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(new Uint16Array(4 * count), 4));
  const weights = Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
  const shown = new SkinnedMesh(geometry);
  const bone = new Bone();
  shown.add(bone);
  shown.bind(new Skeleton([bone]));
  return {
    shown,
    follow: () => {
      bone.position.copy(object.position);
      bone.quaternion.copy(object.quaternion);
    },
  };
};

const morph: Bending = ({ object }) => {
  const geometry = patch();
  const far = Float32Array.from({ length: 3 * geometry.attributes.position!.count }, () => 1);
  const along = [0, 1, 2].map((axis) => far.map((_, i) => (i % 3 === axis ? 1 : 0)));
  geometry.morphAttributes.position = along.map((moves) => new Float32BufferAttribute(moves, 3));
  geometry.morphTargetsRelative = true;
  const shown = new Mesh(geometry);
  return { shown, follow: () => object.position.toArray(shown.morphTargetInfluences) };
};

const instance: Bending = ({ object }) => {
  const shown = new InstancedMesh(patch(), undefined, 3);
  return {
    shown,
    follow: () =>
      // Draws of the analytic world say instance 0.
      shown.setMatrixAt(0, new Matrix4().compose(object.position, object.quaternion, object.scale)),
  };
};

describe.each([
  ['a skin that is a lift', lift, skin],
  ['a skin that is a turntable', turntable, skin],
  ['a morph that is a swing', swing, morph],
  ['an instance that is a swing', swing, instance],
  ['an instance that is a turntable', turntable, instance],
] as const)('riding %s', (_, ride, bending) => {
  it.each([
    [60, 0],
    [60, 2],
    [144, 3],
    [20, 0],
  ])('should not slip by 1 cm at %i Hz, fields %i late', (rate, latency) => {
    const solid = ride.platform();
    const { shown, follow } = bending(solid);
    solid.shown = shown;
    solid.deforms = true;
    const world = new World(ground(-9), solid);
    world.root.add(shown);
    const walker = new WorldWalker(world, {
      foot: ride.foot,
      resolution: 16,
      rate,
      latency,
      drive: (time) => {
        ride.drive(solid, time);
        follow();
      },
    });
    const onPlatform = () => solid.object.worldToLocal(walker.drawn.clone());
    walker.settle(1);
    const from = onPlatform();
    let slip = 0;
    walker.run(8, () => (slip = Math.max(slip, onPlatform().distanceTo(from))));
    expect(slip, walker.story).toBeLessThan(0.01);
    expect(walker.character.grounded).toBe(true);
    expect(walker.worstDrawn, walker.worstAt).toBeLessThan(0.01);
  });
});

describe('leaving a platform', () => {
  const steady: Ride = {
    platform: () => new Box(3, top, 3, 'sledge'),
    drive: ({ object }, time) => object.position.set(2 * time, 0, 0),
    foot: [0, top + 0.02, 0],
  };

  it.each([20, 60, 144])('should keep its velocity in a jump at %i Hz', (rate) => {
    const { walker, onPlatform } = riding(steady, { rate });
    walker.settle(0.5);
    const from = onPlatform(walker.drawn);
    expect(walker.character.jump()).toBe(true);
    walker.run(0.2);
    expect(walker.character.grounded).toBe(false);
    expect(walker.velocity.x).toBeGreaterThan(1.8);
    expect(walker.velocity.x).toBeLessThan(2.2);
    walker.run(1);
    expect(walker.character.grounded).toBe(true);
    expect(onPlatform(walker.drawn).distanceTo(from), walker.story).toBeLessThan(0.15);
  });

  it('should rise as high above a lift that goes down as above the floor', () => {
    for (const speed of [-2, -1, 1, 2]) {
      const { walker, onPlatform } = riding({
        platform: () => new Box(3, top, 3, 'lift'),
        drive: ({ object }, time) => object.position.set(0, speed * time, 0),
        foot: [0, top + 0.02, 0],
      });
      walker.settle(0.5);
      const from = onPlatform(walker.drawn).y;
      expect(walker.character.jump()).toBe(true);
      let rise = 0;
      walker.run(0.6, () => (rise = Math.max(rise, onPlatform(walker.drawn).y - from)));
      expect(rise, `${speed} m/s`).toBeGreaterThan(1.05);
      // Going down, at most what the jump is worth to one who stands beside.
      const most = speed < 0 ? (speed - Math.sqrt(44)) ** 2 / 40 + 0.05 : 1.2;
      expect(rise, `${speed} m/s`).toBeLessThan(most);
    }
  });

  it('should fall with a platform that falls away, and land on it', () => {
    const { walker, onPlatform } = riding({
      platform: () => new Box(2, top, 2, 'trapdoor'),
      drive: ({ object }, time) =>
        object.position.set(0, -Math.min(4, 15 * Math.max(0, time - 1) ** 2), 0),
      foot: [0, top + 0.02, 0],
    });
    walker.run(4);
    expect(onPlatform(walker.drawn).y).toBeCloseTo(top + 0.02, 1);
    expect(walker.worstDrawn, walker.worstAt).toBeLessThan(0.02);
    expect(walker.crossings, walker.crossedAt).toBe(0);
    expect(walker.character.grounded).toBe(true);
  });
});

describe('a wall that moves into it', () => {
  it.each([1, 2, 3])('should push it along at %i m/s', (speed) => {
    for (const rate of [20, 60, 144]) {
      for (const latency of [0, 2]) {
        const pusher = new Box(0.05, 1.5, 2, 'pusher');
        const walker = new WorldWalker(new World(ground(), pusher), {
          rate,
          latency,
          resolution: 16,
          drive: (time) => pusher.at(-1.5 + speed * time, 1.5, 0),
        });
        walker.settle(0.3).run(2);
        const ahead = walker.foot.x - pusher.object.position.x - 0.05 - 0.35;
        expect(walker.crossings, walker.crossedAt).toBe(0);
        expect(walker.worstDrawn, walker.worstAt).toBeLessThan(0.01);
        expect(ahead, walker.story).toBeGreaterThan(-0.01);
        expect(ahead, walker.story).toBeLessThan(0.1 + speed / 20);
        expect(walker.character.grounded).toBe(true);
      }
    }
  });

  it('should push it from a turning door', () => {
    const door = new Box(0.6, 1, 0.03, 'door');
    const walker = new WorldWalker(new World(ground(), door), {
      foot: [0.8, 0.02, 0.6],
      drive: (time) => {
        const yaw = -Math.min(Math.PI / 2, 1.5 * time);
        door.at(0.6 * Math.cos(yaw), 1, -0.6 * Math.sin(yaw)).turn({ yaw });
      },
    });
    walker.run(3);
    expect(walker.crossings, walker.crossedAt).toBe(0);
    expect(walker.worstDrawn, walker.worstAt).toBeLessThan(0.01);
    expect(walker.foot.x, walker.story).toBeLessThan(0.5);
  });
});

describe('walls that close', () => {
  it.each([0, 2])(
    'should be told as squeezed, and never let it through, fields %i late',
    (latency) => {
      const walls = [-1, 1].map((side) => new Box(0.1, 1.5, 3, side < 0 ? 'left' : 'right'));
      const walker = new WorldWalker(new World(ground(), ...walls), {
        latency,
        resolution: 24,
        // From 1.2 m apart to 0.5, and open again after 4 s.
        drive: (time) => {
          const half =
            time < 4 ? Math.max(0.25, 0.6 - 0.25 * time) : Math.min(0.6, 0.25 * (time - 3));
          walls.forEach((each, i) => each.at((2 * i - 1) * (half + 0.1), 1.5, 0));
        },
      });
      const heard = listen(walker.character);
      walker.run(0.5);
      expect(walker.character.squeezed).toBe(false);
      walker.run(3);
      expect(walker.character.squeezed).toBe(true);
      expect(heard.squeeze.map(({ squeezed }) => squeezed)).toEqual([true]);
      expect(walker.crossings, walker.crossedAt).toBe(0);
      expect(Math.abs(walker.foot.x)).toBeLessThan(0.25);
      expect(Number.isFinite(walker.foot.length())).toBe(true);
      walker.run(3);
      expect(walker.character.squeezed).toBe(false);
      expect(heard.squeeze.map(({ squeezed }) => squeezed)).toEqual([true, false]);
      expect(walker.gap).toBeGreaterThan(0.005);
      expect(walker.foot.y).toBeGreaterThan(0);
    },
  );

  it('should tell of a press from above', () => {
    const press = block([-2, 0, -2], [2, 1, 2], 'press');
    const walker = new WorldWalker(new World(ground(), press), {
      drive: (time) => press.at(0, 0.5 + Math.max(1.5, 2.5 - 0.5 * time), 0),
    });
    const heard = listen(walker.character);
    walker.run(4);
    expect(heard.squeeze.map(({ squeezed }) => squeezed)).toEqual([true]);
    expect(walker.foot.y, walker.story).toBeGreaterThan(-0.01);
    expect(walker.crossings, walker.crossedAt).toBe(0);
  });
});
