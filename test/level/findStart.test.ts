import {
  BoxGeometry,
  BufferAttribute,
  Group,
  Matrix4,
  Mesh,
  Object3D,
  Raycaster,
  SphereGeometry,
  Vector3,
} from 'three';
import { describe, expect, it } from 'vitest';
import { findStart, groundBelow, type Start } from '../../demo/level/findStart.js';
import { isSpawnName, spawnNode } from '../../demo/level/spawnNode.js';
import { STRIDE, collectTriangles } from '../../demo/level/triangles.js';
import { terrainGeometry } from './terrainGeometry.js';
import { moved, soupOf } from './soup.js';

type Box = [x: [number, number], y: [number, number], z: [number, number]];

function boxes(...list: Box[]): Group {
  const group = new Group();
  for (const [x, y, z] of list) {
    const mesh = new Mesh(new BoxGeometry(x[1] - x[0], y[1] - y[0], z[1] - z[0]));
    mesh.position.set((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, (z[0] + z[1]) / 2);
    group.add(mesh);
  }
  return group;
}

/** By three's raycaster: ground under the whole foot, and nothing in the body's way. */
function standsFreely(soup: Float32Array, start: Start): void {
  const mesh = new Mesh();
  mesh.geometry.setAttribute('position', new BufferAttribute(soup, 3));
  (mesh.material as { side?: number }).side = 2;
  const cast = (from: Vector3, to: Vector3, far: number) =>
    new Raycaster(from, to, 0, far).intersectObject(mesh)[0]?.distance;
  for (let i = 0; i < 8; i++) {
    const side = new Vector3(Math.cos((i * Math.PI) / 4), 0, Math.sin((i * Math.PI) / 4));
    const rim = start.position
      .clone()
      .addScaledVector(side, 0.2)
      .setY(start.position.y + 0.5);
    expect(cast(rim, new Vector3(0, -1, 0), 1)).toBeGreaterThan(0.1);
    for (const height of [0.6, 1.2, 1.7]) {
      const middle = start.position.clone().setY(start.position.y + height);
      expect(cast(middle, side, 0.35)).toBeUndefined();
    }
  }
  expect(
    cast(start.position.clone().setY(start.position.y + 0.5), new Vector3(0, 1, 0), 1.3),
  ).toBeUndefined();
}

const start = (soup: Float32Array) => {
  const found = findStart(soup);
  expect(found).not.toBeNull();
  standsFreely(soup, found!);
  return found!;
};

describe('where a walk begins', () => {
  it('should be on the ground of a yard, not on its wall nor under its table', () => {
    const { position } = start(
      collectTriangles(
        boxes(
          [
            [-10, 10],
            [-0.5, 0],
            [-10, 10],
          ],
          [
            [-2, 2],
            [1, 1.1],
            [-2, 2],
          ],
          [
            [-10, 10],
            [0, 4],
            [-10.5, -10],
          ],
          [
            [-10, 10],
            [0, 4],
            [10, 10.5],
          ],
        ),
      ),
    );
    expect(position.y).toBeCloseTo(0.03, 5);
    expect(Math.hypot(position.x, position.z)).toBeLessThan(6);
  });

  it('should be in a closed room where nothing is under the sky but its roof', () => {
    const { position } = start(
      collectTriangles(
        boxes(
          [
            [-12, 12],
            [-0.2, 0],
            [-9, 9],
          ],
          [
            [-12, 12],
            [3, 3.2],
            [-9, 9],
          ],
          ...([-12, 12] as const).map((x): Box => [
            [x - 0.1, x + 0.1],
            [0, 3],
            [-9, 9],
          ]),
          ...([-9, 9] as const).map((z): Box => [
            [-12, 12],
            [0, 3],
            [z - 0.1, z + 0.1],
          ]),
        ),
      ),
    );
    expect(position.y).toBeCloseTo(0.03, 5);
  });

  it('should keep out of pillars, and look where there is room', () => {
    const walls: Box[] = [];
    for (let x = -8; x <= 8; x += 2)
      for (let z = -8; z <= 8; z += 2)
        walls.push([
          [x - 0.3, x + 0.3],
          [0, 5],
          [z - 0.3, z + 0.3],
        ]);
    start(
      collectTriangles(
        boxes(
          [
            [-9, 9],
            [-1, 0],
            [-9, 9],
          ],
          ...walls,
        ),
      ),
    );
    // A lane: along it, not into its walls.
    const { yaw } = start(
      collectTriangles(
        boxes(
          [
            [-2, 2],
            [-1, 0],
            [-30, 30],
          ],
          [
            [-2.2, -2],
            [0, 5],
            [-30, 30],
          ],
          [
            [2, 2.2],
            [0, 5],
            [-30, 30],
          ],
        ),
      ),
    );
    expect(Math.abs(Math.sin(yaw))).toBeLessThan(0.2);
  });

  it('should be on the slope of a terrain that can be stood on', () => {
    for (const seed of [1, 2, 3])
      start(collectTriangles(new Group().add(new Mesh(terrainGeometry(seed)))));
  });

  it('should be found in the demo’s level, wherever it lies', async () => {
    const level = await soupOf('public/level.glb');
    start(level);
    const far = start(moved(level, new Matrix4().makeTranslation(3000, -500, 40)));
    expect(far.position.x).toBeGreaterThan(2900);
  });

  it('should not be found on a ball, in a crack, or in nothing', () => {
    expect(
      findStart(collectTriangles(new Group().add(new Mesh(new SphereGeometry(0.8))))),
    ).toBeNull();
    expect(
      findStart(
        collectTriangles(
          boxes(
            [
              [-9, 9],
              [0, 1],
              [-9, 9],
            ],
            [
              [-9, 9],
              [2, 3],
              [-9, 9],
            ],
            [
              [-9, 9],
              [3.4, 3.6],
              [0, 0.1],
            ],
          ),
        ) ?? new Float32Array(),
      )?.position.y,
    ).toBeGreaterThan(2.9);
    expect(findStart(new Float32Array(0))).toBeNull();
  });
});

describe('a node that says where', () => {
  it('should be known by its name', () => {
    for (const name of [
      'spawn',
      'Spawn',
      'SpawnPoint',
      'spawn_point_01',
      'start',
      'PlayerStart',
      'player',
      'info_player_start',
      'Start.001',
    ])
      expect(isSpawnName(name), name).toBe(true);
    for (const name of [
      'staircase',
      'start_button',
      'restart-sign',
      'players',
      'respawner',
      'multiplayer',
      'spawn_crate',
      '',
    ])
      expect(isSpawnName(name), name).toBe(false);
  });

  it('should tell its place and where it looks, by its name in the file too', () => {
    const root = new Group();
    const node = new Object3D();
    node.name = 'spawn001';
    node.userData.name = 'spawn.001';
    node.position.set(1, 2, 3);
    node.rotation.y = 0.7;
    root.add(node).updateMatrixWorld(true);
    const found = spawnNode(root)!;
    expect(found.position.toArray()).toEqual([1, 2, 3]);
    expect(found.yaw).toBeCloseTo(0.7, 10);
    expect(spawnNode(new Group())).toBeNull();
  });

  it('should be put on the ground below it, not on a roof above', () => {
    const soup = collectTriangles(
      boxes(
        [
          [-5, 5],
          [-1, 0],
          [-5, 5],
        ],
        [
          [-5, 5],
          [4, 5],
          [-5, 5],
        ],
      ),
    );
    expect(groundBelow(soup, new Vector3(0, 1.7, 0))).toBeCloseTo(0, 5);
    expect(groundBelow(soup, new Vector3(0, 9, 0))).toBeCloseTo(5, 5);
    expect(groundBelow(soup, new Vector3(9, 1, 0))).toBeNull();
    expect(soup.length % STRIDE).toBe(0);
  });
});
