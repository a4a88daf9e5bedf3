import {
  BoxGeometry,
  Group,
  Matrix4,
  Mesh,
  PlaneGeometry,
  TorusKnotGeometry,
  Vector3,
} from 'three';
import { beforeAll, describe, expect, it } from 'vitest';
import { guessScale } from '../../demo/level/guessScale.js';
import { boundsOf, guessUp, turnOf, type Up, UPS } from '../../demo/level/orientation.js';
import { collectTriangles } from '../../demo/level/triangles.js';
import { moved, soupOf } from './soup.js';

const Z_UP = new Matrix4().makeRotationX(Math.PI / 2);

/** Boxes given by their sizes and middles. */
function boxes(...list: [size: number[], middle: number[]][]): Group {
  const group = new Group();
  for (const [size, middle] of list) {
    const mesh = new Mesh(new BoxGeometry(...(size as [number, number, number])));
    mesh.position.fromArray(middle);
    group.add(mesh);
  }
  return group;
}

describe('which way is up', () => {
  let level: Float32Array;
  beforeAll(async () => {
    level = await soupOf('public/level.glb');
  });

  const closed = {
    'a room': boxes(
      [
        [8, 0.2, 6],
        [0, 0, 0],
      ],
      [
        [8, 3, 0.2],
        [0, 1.5, 3],
      ],
      [
        [0.2, 3, 6],
        [4, 1.5, 0],
      ],
    ),
    'a yard with pillars': boxes(
      [
        [30, 1, 30],
        [0, 0, 0],
      ],
      [
        [1, 6, 1],
        [5, 3, 5],
      ],
      [
        [1, 6, 1],
        [-5, 3, 5],
      ],
    ),
  };
  const upright = {
    ...closed,
    'a tower': boxes(
      [
        [5, 30, 0.3],
        [0, 15, 2.5],
      ],
      [
        [5, 30, 0.3],
        [0, 15, -2.5],
      ],
      [
        [0.3, 30, 5],
        [2.5, 15, 0],
      ],
      [
        [5, 0.3, 5],
        [0, 0, 0],
      ],
    ),
    'a figure': new Group().add(new Mesh(new TorusKnotGeometry(1, 0.3))),
  };

  it.each(Object.entries(upright))('should leave %s as glTF has it', (_, group) => {
    expect(guessUp(collectTriangles(group))).toBe('+Y');
  });

  it.each(Object.entries(closed))('should find %s of a Z-up tool', (_, group) => {
    expect(guessUp(moved(collectTriangles(group), Z_UP))).toBe('+Z');
  });

  it('should tell the demo’s own level, and a bare floor, either way', () => {
    const floor = moved(
      new Float32Array([...collectTriangles(new Group().add(new Mesh(new PlaneGeometry(9, 9))))]),
      new Matrix4().makeRotationX(-Math.PI / 2),
    );
    for (const soup of [level, floor]) {
      expect(guessUp(soup)).toBe('+Y');
      expect(guessUp(moved(soup, Z_UP))).toBe('+Z');
    }
  });

  it('should say +Y where there is nothing', () => {
    expect(guessUp(new Float32Array(0))).toBe('+Y');
  });

  it.each(UPS)('should turn %s to +Y, and keep lengths', (up: Up) => {
    const sign = up.startsWith('-') ? -1 : 1;
    const axis = new Vector3()
      .setComponent('XYZ'.indexOf(up[1]!), sign)
      .applyQuaternion(turnOf(up));
    expect(axis.distanceTo(new Vector3(0, 1, 0))).toBeLessThan(1e-12);
  });
});

describe('how large', () => {
  it.each([
    ['a room', [5, 2.5, 4], 1],
    ['a house', [12, 9, 15], 1],
    ['a city', [400, 200, 400], 1],
    ['a valley', [2000, 150, 2000], 1],
    ['a tower', [8, 60, 8], 1],
    ['a floor', [20, 0, 20], 1],
    ['a castle in centimetres', [1500, 1000, 1500], 0.01],
    ['a hall in millimetres', [30_000, 6000, 20_000], 0.001],
    ['a toy', [0.1, 0.04, 0.1], 100],
    ['nothing', [0, 0, 0], 1],
    ['no number', [NaN, 1, 1], 1],
  ])('should take %s of %j for %d metres a unit', (_, [x, y, z], scale) => {
    expect(guessScale({ x: x!, y: y!, z: z! })).toBe(scale);
  });

  it('should make of a speck and of a galaxy something to walk in', () => {
    for (const size of [1e-6, 1e9]) {
      const scaled = size * guessScale({ x: size, y: size / 4, z: size });
      expect(scaled).toBeGreaterThan(10);
      expect(scaled).toBeLessThan(100);
    }
  });

  it('should find the demo’s level in centimetres', async () => {
    const level = await soupOf('public/level.glb');
    const size = boundsOf(level).getSize(new Vector3());
    expect(guessScale(size)).toBe(1);
    expect(guessScale(size.multiplyScalar(100))).toBe(0.01);
  });
});
