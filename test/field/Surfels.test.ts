import { Euler, Matrix4, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { GOES_ON, MIXED, PIECE } from '../../src/field/pieces.js';
import { STRIDE } from '../../src/field/layout.js';
import { finerDirection } from '../../src/cube/finerTexel.js';
import { SurfaceField, type SurfaceSampler } from '../../src/field/SurfaceField.js';
import { Surfels } from '../../src/field/Surfels.js';
import { cornersOf, dice, drawn, unionDistance, UPRIGHT } from '../support/fields.js';
import { randomWorld } from '../support/world/randomWorld.js';
import { Ball, Box, ground, Plane, room } from '../support/world/scenes.js';
import { World } from '../support/world/World.js';
import { WorldCollider } from '../support/world/WorldCollider.js';

const MILLIMETRE = 1e-3;

function surfelsOf(world: World, center: Vector3, options = {}, toBody = UPRIGHT): Surfels {
  const field = drawn(world, center, options);
  return new Surfels(field.resolution).fill(field, toBody).findAll();
}

function everyCorner(surfels: Surfels, object = 0): Vector3[] {
  const corners: Vector3[] = [];
  for (let i = 0; i < surfels.count; i++) {
    if (object === 0 || surfels.object[i] === object) corners.push(...cornersOf(surfels, i));
  }
  return corners;
}

describe('Surfels of a plane', () => {
  it.each([
    ['a floor', 0, 0],
    ['a slope', 0.5, 0.3],
    ['a wall', Math.PI / 2, 0.7],
  ])('should tile %s without gap (seed 21)', (_, pitch, yaw) => {
    const between = dice(21);
    const plane = new Plane().turn({ pitch, yaw });
    const world = new World(plane);
    const normal = new Vector3(0, 1, 0).applyEuler(plane.object.rotation);
    for (const resolution of [16, 32]) {
      const center = normal
        .clone()
        .multiplyScalar(0.9)
        .add(new Vector3(0.03, 0.01, -0.02));
      const surfels = surfelsOf(world, center, { resolution });
      for (let i = 0; i < 150; i++) {
        const point = new Vector3(between(-0.7, 0.7), 0, between(-0.7, 0.7))
          .applyEuler(plane.object.rotation)
          .add(center.clone().projectOnPlane(normal));
        expect(unionDistance(surfels, point), point.toArray().join()).toBeLessThan(1e-4);
      }
    }
  });

  it('should lie in the plane and be whole in its midst', () => {
    const surfels = surfelsOf(new World(ground()), new Vector3(0.03, 0.9, -0.02));
    for (const { y } of everyCorner(surfels)) expect(Math.abs(y)).toBeLessThan(1e-5);
    const below = surfels.ofTexel[3 * 32 * 32 + 16 * 32 + 16]!;
    expect(surfels.piece[PIECE * below + 7]).toBe(GOES_ON);
  });
});

/** Do three faces of the box come within a texel or two of the surfel's point? */
function nearVertex(box: Box, { data, origin }: Surfels, i: number): boolean {
  const o = STRIDE * i;
  const { x, y, z } = new Vector3(...data.subarray(o, o + 3)).add(origin).applyMatrix4(box.inverse);
  const rest = [box.hx - Math.abs(x), box.hy - Math.abs(y), box.hz - Math.abs(z)];
  return Math.max(...rest) < 0.1;
}

describe('Surfels of a box', () => {
  it('should end at its edges, away from its vertices (seed 22)', () => {
    const between = dice(22);
    for (let run = 0; run < 60; run++) {
      const [hx, hy, hz] = [between(0.1, 0.5), between(0.1, 0.5), between(0.1, 0.5)];
      const box = new Box(hx, hy, hz).turn({ yaw: between(-3, 3) });
      // Beside, above and before it: three faces are seen, none of them edge-on.
      const center = new Vector3(
        hx + between(0.3, 0.6),
        hy + between(0.3, 0.6),
        hz + between(0.3, 0.6),
      ).applyEuler(box.object.rotation);
      const surfels = surfelsOf(new World(box), center, { far: 3 });
      const say = `run ${run}`;
      for (let i = 0; i < surfels.count; i++) {
        if (nearVertex(box, surfels, i)) continue;
        for (const corner of cornersOf(surfels, i)) {
          const { x, y, z } = corner.applyMatrix4(box.inverse);
          expect(Math.max(x - hx, y - hy, z - hz), say).toBeLessThan(MILLIMETRE);
        }
      }
    }
  });

  it('should reach edges of which both faces are seen (seed 23)', () => {
    const between = dice(23);
    for (let run = 0; run < 20; run++) {
      const box = new Box(0.4, 0.4, 0.4).turn({ yaw: between(-3, 3) });
      const center = new Vector3(0.8, 0.8, 0.8).applyEuler(box.object.rotation);
      const surfels = surfelsOf(new World(box), center);
      for (const axis of ['x', 'y', 'z'] as const) {
        for (let i = 0; i < 10; i++) {
          const point = new Vector3(0.4, 0.4, 0.4);
          point[axis] = between(-0.1, 0.395);
          point.applyEuler(box.object.rotation);
          expect(unionDistance(surfels, point), `run ${run} ${axis}`).toBeLessThan(MILLIMETRE);
        }
      }
    }
  });

  it('should grow past the silhouette of what is stood on by 15 mm at most', () => {
    // From above, its sides are not seen.
    const world = new World(new Box(0.3, 0.3, 0.3).at(0, -1, 0));
    let most = 0;
    for (const { x, z } of everyCorner(surfelsOf(world, new Vector3()))) {
      most = Math.max(most, Math.abs(x) - 0.3, Math.abs(z) - 0.3);
    }
    expect(most).toBeLessThan(0.015 + 1e-5);
  });

  it('should never grow past a silhouette where it cannot be stood on', () => {
    // Turned on its side, what was a tread is a wall.
    const box = new Box(0.3, 0.3, 0.3).at(0, -1, 0);
    const quarter = new Quaternion().setFromEuler(new Euler(Math.PI / 2, 0, 0));
    const surfels = surfelsOf(new World(box), new Vector3(), {}, quarter);
    const back = quarter.clone().conjugate();
    expect(surfels.count).toBeGreaterThan(20);
    for (const corner of everyCorner(surfels)) {
      const { x, z } = corner.applyQuaternion(back);
      expect(Math.max(Math.abs(x), Math.abs(z)) - 0.3).toBeLessThan(1e-5);
    }
  });
});

describe('Surfels of a wall whose top is just above the eye', () => {
  const AWAY = 0.37;

  /**
   * The wall x <= -0.37, up to `height`, and another that stands on it, 2 cm back; the ray that meets the very edge slips
   * in and sees the top from inside.
   */
  function wall(height: number, front: boolean): SurfaceSampler {
    return (_, [x, y]) => {
      const distance = -AWAY / x;
      const above = y * distance - height;
      if (!(x < 0)) return null;
      if (above > 1e-6) return { distance: distance + 0.02 / -x, normal: [1, 0, 0] };
      if (above < -1e-6) return { distance, normal: [1, 0, 0] };
      return { distance: 0.997 * distance, normal: [0, -1, 0], front };
    };
  }

  /** Drawn finer, rays pass anywhere through their texels. */
  function anyRays(seed: number): Float32Array {
    const between = dice(seed);
    const directions = new Float32Array(3 * 6 * 32 * 32);
    for (let i = 0; i < 6 * 32 * 32; i++) {
      const place = Math.floor(between(0, 16));
      finerDirection(Math.floor(i / 1024), i % 32, (i >> 5) % 32, place, 32, 4, directions, 3 * i);
    }
    return directions;
  }

  it('should not jut out where a ray slips in between wall and top (seed 25)', () => {
    const directions = anyRays(25);
    const field = new SurfaceField(32, 1.8, directions);
    const surfels = new Surfels(32);
    const howFarOut = (height: number, front: boolean) => {
      surfels.fill(field.sample(wall(height, front), new Vector3()), UPRIGHT).findAll();
      return Math.max(...everyCorner(surfels).map(({ x }) => x + AWAY));
    };
    let asCeiling = 0;
    for (let i = 0; i < directions.length; i += 15) {
      const [x, y] = [directions[i]!, directions[i + 1]!];
      if (x > -0.3 || y < 0.03 || y > 0.3) continue;
      const height = (AWAY * y) / -x;
      expect(howFarOut(height, false), `height ${height}`).toBeLessThan(2 * MILLIMETRE);
      asCeiling = Math.max(asCeiling, howFarOut(height, true));
    }
    // The same seen from its front would be a narrow ceiling, and stays.
    expect(asCeiling).toBeGreaterThan(10 * MILLIMETRE);
  });

  it('should stay whole seen from inside', () => {
    // Backs of four walls that stand on a floor.
    const inside: SurfaceSampler = (_, [x, y, z]) => {
      const [wide, low] = [Math.max(Math.abs(x), Math.abs(z)), -y];
      if (0.9 * low > 0.5 * wide) return { distance: 0.5 / low, normal: [0, 1, 0] };
      const normal = [x, 0, z].map((n) => (Math.abs(n) === wide ? -Math.sign(n) : 0));
      return { distance: 0.9 / wide, normal: normal as [number, number, number], front: false };
    };
    const options = { resolution: 32, far: 1.8, center: new Vector3() };
    const field = SurfaceField.from(inside, options);
    const backs = field.front.reduce((sum, front, i) => {
      return sum + (front === 0 && field.distance[i]! < Infinity ? 1 : 0);
    }, 0);
    const surfels = new Surfels(32).fill(field, UPRIGHT);
    let kept = 0;
    for (let texel = 0; texel < field.count; texel++) {
      if (field.front[texel] === 0 && surfels.ofTexel[texel]! >= 0) kept++;
    }
    expect(kept).toBe(backs);
  });
});

describe('Surfels of curved ground', () => {
  it('should lie within 2 mm of a ball of radius 1 m, without gap (seed 24)', () => {
    const between = dice(24);
    const world = new World(new Ball(1));
    const surfels = surfelsOf(world, new Vector3(0.02, 1.9, 0.01));
    for (let i = 0; i < 300; i++) {
      const slope = between(0, 0.5);
      const yaw = between(-Math.PI, Math.PI);
      const point = new Vector3().setFromSphericalCoords(1, slope, yaw);
      expect(unionDistance(surfels, point), `slope ${slope}`).toBeLessThan(2 * MILLIMETRE);
    }
    for (const corner of everyCorner(surfels)) {
      if (corner.y < Math.cos(0.5) * corner.length()) continue;
      expect(Math.abs(corner.length() - 1)).toBeLessThan(2 * MILLIMETRE);
    }
  });
});

describe('carry', () => {
  const scene = () => {
    const box = new Box(0.3, 0.2, 0.4).at(0.7, 0.2, 0.1).turn({ yaw: 0.4 });
    const world = new World(ground(), box);
    return { box, world };
  };
  const frames: [string, Quaternion][] = [
    ['upright', UPRIGHT],
    ['under another up', new Quaternion().setFromEuler(new Euler(0.9, -0.4, 1.8))],
  ];

  it.each(frames)('should move what belongs to the object, and nothing else, %s', (_, toBody) => {
    const { box, world } = scene();
    const surfels = surfelsOf(world, new Vector3(0, 1, 0), {}, toBody);
    const id = surfels.objects.indexOf(box.object) + 1;
    const before = everyCorner(surfels, id);
    const floor = everyCorner(surfels, surfels.objects.indexOf(world.solids[0]!.object) + 1);
    expect(before.length).toBeGreaterThan(100);
    const was = box.object.matrixWorld.clone();
    // Twice: it starts from where it was drawn, not from where it was last.
    for (const turn of [0.3, 1.1]) {
      box.object.position.set(0.5 + turn, 0.4, -0.2);
      box.object.rotation.set(turn, 0.2, -turn);
      world.refresh();
      expect(surfels.carry(id, toBody)).toBe(true);
    }
    const since = was.invert().premultiply(box.object.matrixWorld);
    const back = toBody.clone().conjugate();
    const after = everyCorner(surfels, id);
    for (let i = 0; i < before.length; i++) {
      const expected = before[i]!.applyQuaternion(back).applyMatrix4(since);
      expect(after[i]!.applyQuaternion(back).distanceTo(expected)).toBeLessThan(1e-5);
    }
    const place = surfels.objects.indexOf(world.solids[0]!.object) + 1;
    for (const [i, corner] of everyCorner(surfels, place).entries()) {
      expect(corner.equals(floor[i]!)).toBe(true);
    }
    expect(surfels.moved[id]).toBe(1);
    expect(surfels.moved[place]).toBe(0);
  });

  it('should move surfels about their object far from the origin to a tenth of a millimetre', () => {
    const { box, world } = scene();
    world.root.position.set(5000, 100, -3000);
    const surfels = surfelsOf(world, new Vector3(5000, 101, -3000));
    const id = surfels.objects.indexOf(box.object) + 1;
    const ofBox = () => everyCorner(surfels, id).map((corner) => corner.applyMatrix4(box.inverse));
    const before = ofBox();
    box.object.rotation.y += 0.5;
    box.object.position.y += 0.3;
    world.refresh();
    expect(surfels.carry(id, UPRIGHT)).toBe(true);
    const after = ofBox();
    expect(before.length).toBeGreaterThan(100);
    for (let i = 0; i < before.length; i++) {
      expect(after[i]!.distanceTo(before[i]!)).toBeLessThan(1e-4);
    }
  });

  it('should say that the surfels of a scaled object no longer hold', () => {
    const { box, world } = scene();
    const surfels = surfelsOf(world, new Vector3(0, 1, 0));
    const id = surfels.objects.indexOf(box.object) + 1;
    const scaled = new Matrix4().makeScale(1, 1.1, 1).multiply(box.object.matrixWorld);
    expect(surfels.carry(id, UPRIGHT, scaled)).toBe(false);
    expect(surfels.carry(id, UPRIGHT, box.object.matrixWorld)).toBe(true);
  });
});

describe('Surfels that nobody has asked for yet', () => {
  const tilted = new Quaternion().setFromEuler(new Euler(0.9, -0.4, 1.8));

  it.each([
    ['upright', UPRIGHT],
    ['under another up', tilted],
  ])('should lie no farther than their block says, %s (seed 26)', (_, toBody) => {
    const between = dice(26);
    let flat = 0;
    let mixed = 0;
    for (let run = 0; run < 6; run++) {
      const yard = randomWorld(() => between(0, 1));
      const center = new Vector3(between(-8, 8), between(0.5, 1.2), between(-8, 8));
      for (const resolution of [16, 18, 32]) {
        const field = drawn(yard, center, { resolution });
        const surfels = new Surfels(resolution).fill(field, toBody);
        const { block, first, piece } = surfels;
        const said = block.slice();
        surfels.findAll();
        for (let b = 0; b < first.length - 1; b++) {
          const [x, y, z, extent, nx, ny, nz, kind] = said.subarray(PIECE * b, PIECE * (b + 1));
          const middle = new Vector3(x, y, z).add(surfels.origin);
          for (let i = first[b]!; i < first[b + 1]!; i++) {
            for (const corner of cornersOf(surfels, i)) {
              corner.sub(middle);
              expect(corner.length(), `run ${run}, block ${b}`).toBeLessThan(extent! + 1e-5);
              if (kind === MIXED) continue;
              const off = corner.dot(new Vector3(nx, ny, nz));
              expect(Math.abs(off), `run ${run}, block ${b}`).toBeLessThan(1e-4);
            }
            if (kind === MIXED) mixed++;
            else flat++;
            if (kind === GOES_ON) expect(piece[PIECE * i + 7]).toBe(GOES_ON);
          }
        }
      }
    }
    expect(flat).toBeGreaterThan(1000);
    expect(mixed).toBeGreaterThan(1000);
  });

  it.each([1, 2])(
    'should lie no farther than their block says at any time before it is made, supersample %i (seed 27)',
    (supersample) => {
      const between = dice(27);
      let smaller = 0;
      for (let run = 0; run < 3; run++) {
        const yard = randomWorld(() => between(0, 1));
        const toBody = run % 2 === 0 ? UPRIGHT : tilted;
        for (const resolution of [16, 18, 32]) {
          const collider = new WorldCollider(yard, { resolution, supersample });
          collider.position.set(between(-8, 8), between(0.5, 1.2), between(-8, 8));
          collider.update();
          const made = new Surfels(resolution).fill(collider.field!, toBody).findAll();
          const { block, first } = new Surfels(resolution).fill(collider.field!, toBody);
          const refined = new Surfels(resolution).fill(collider.field!, toBody);
          for (let b = 0; b < first.length - 1; b++) {
            const corners = [];
            for (let i = first[b]!; i < first[b + 1]!; i++) corners.push(...cornersOf(made, i));
            do {
              const [x, y, z, extent] = refined.block.subarray(PIECE * b, PIECE * b + 4);
              const middle = new Vector3(x, y, z).add(made.origin);
              for (const corner of corners) {
                const away = corner.distanceTo(middle);
                expect(away, `run ${run}, block ${b}`).toBeLessThan(extent! + 1e-5);
              }
            } while (refined.refine(b));
            if (refined.block[PIECE * b + 3]! < 0.9 * block[PIECE * b + 3]!) smaller++;
          }
          expect(refined.data).toEqual(made.data);
          expect(refined.piece).toEqual(made.piece);
        }
      }
      expect(smaller).toBeGreaterThan(300);
    },
  );

  it('should be carried along with their object as those that are there', () => {
    const box = new Box(0.3, 0.3, 0.3).at(0.5, 0.4, 0);
    const world = new World(ground(), box);
    const field = drawn(world, new Vector3(0, 1, 0), {});
    const late = new Surfels(32).fill(field, UPRIGHT);
    const early = new Surfels(32).fill(field, UPRIGHT).findAll();
    const id = early.objects.indexOf(box.object) + 1;
    box.object.position.set(0.7, 0.6, -0.2);
    world.refresh();
    for (const surfels of [late, early]) expect(surfels.carry(id, UPRIGHT)).toBe(true);
    late.findAll();
    expect(late.piece).toEqual(early.piece);
    expect(late.data).toEqual(early.data);
    expect(late.block).toEqual(early.block);
  });
});

describe('Surfels under another up', () => {
  it('should be the same, turned', () => {
    const world = new World(room(0.8, 0.7, 0.9));
    const center = new Vector3(0.1, -0.1, 0.05);
    const toBody = new Quaternion().setFromEuler(new Euler(0.9, -0.4, 1.8));
    const upright = surfelsOf(world, center);
    const turned = surfelsOf(world, center, {}, toBody);
    expect(turned.count).toBe(upright.count);
    expect(turned.link).toEqual(upright.link);
    const corners = everyCorner(turned);
    for (const [i, corner] of everyCorner(upright).entries()) {
      expect(corners[i]!.distanceTo(corner.applyQuaternion(toBody))).toBeLessThan(1e-5);
    }
  });
});
