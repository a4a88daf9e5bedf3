import {
  BoxGeometry,
  CylinderGeometry,
  DoubleSide,
  Mesh,
  MeshBasicMaterial,
  Raycaster,
  Vector3,
} from 'three';
import { describe, expect, it } from 'vitest';
import { seeded } from '../e2e/support/axisScenes.js';
import { SurfaceField } from '../src/field/SurfaceField.js';
import { randomWorld } from './support/world/randomWorld.js';
import { Ball, Box, corner, Cylinder, ground, Plane, ramp, wall } from './support/world/scenes.js';
import type { Solid } from './support/world/Solid.js';
import { World } from './support/world/World.js';
import { WorldCollider } from './support/world/WorldCollider.js';

const random = seeded(11);
const between = (low: number, high: number) => low + (high - low) * random();
const somewhere = (reach: number) =>
  new Vector3(between(-reach, reach), between(-reach, reach), between(-reach, reach));
const UP = new Vector3(0, 1, 0);

const SOLIDS: [string, () => Solid][] = [
  ['box', () => new Box(0.4, 0.7, 0.2)],
  ['plate', () => new Box(0.6, 0.005, 0.9)],
  ['cylinder', () => new Cylinder(0.3, 0.8)],
  ['ball', () => new Ball(0.5)],
  ['plane', () => new Plane()],
];

/** Points of the surface, by rays from all around and from inside. */
function surfacePoints(solid: Solid, count: number): Vector3[] {
  const points: Vector3[] = [];
  while (points.length < count) {
    const o = somewhere(2);
    const d = somewhere(1).normalize();
    const t = solid.cast(o.x, o.y, o.z, d.x, d.y, d.z);
    if (t < Infinity) points.push(o.addScaledVector(d, t));
  }
  return points;
}

describe('the analytic worlds that judge', () => {
  it.each(SOLIDS)('should meet a %s by rays where its surface is', (_, make) => {
    const solid = make();
    const nearest = new Vector3();
    for (const point of surfacePoints(solid, 300)) {
      // On the surface: a little outward along the normal is outside by as much.
      const d = somewhere(1).normalize();
      const o = point.clone().addScaledVector(d, -0.001);
      const t = solid.cast(o.x, o.y, o.z, d.x, d.y, d.z);
      expect(Math.abs(t - 0.001)).toBeLessThan(0.0011);
      const n = new Vector3(solid.nx, solid.ny, solid.nz);
      expect(n.length()).toBeCloseTo(1, 9);
      const at = o.clone().addScaledVector(d, t).addScaledVector(n, 1e-4);
      solid.nearest(at.x, at.y, at.z);
      nearest.set(solid.nx, solid.ny, solid.nz);
      expect(nearest.distanceTo(at)).toBeCloseTo(1e-4, 7);
    }
  });

  it.each(SOLIDS)('should never be nearer to a %s than the surface is', (_, make) => {
    const solid = make();
    const surface = surfacePoints(solid, 500);
    const onSegment = new Vector3();
    for (let i = 0; i < 60; i++) {
      const from = somewhere(1.5);
      const to = somewhere(1.5);
      const exact = solid.distance(from.x, from.y, from.z, to.x, to.y, to.z);
      let least = Infinity;
      for (let k = 0; k <= 50; k++) {
        onSegment.lerpVectors(from, to, k / 50);
        solid.nearest(onSegment.x, onSegment.y, onSegment.z);
        least = Math.min(least, onSegment.distanceTo(new Vector3(solid.nx, solid.ny, solid.nz)));
      }
      expect(exact).toBeLessThanOrEqual(least + 1e-9);
      expect(exact).toBeGreaterThan(least - 0.03);
      const axis = to.clone().sub(from);
      for (const point of surface) {
        const t = Math.min(1, Math.max(0, point.clone().sub(from).dot(axis) / axis.lengthSq()));
        const far = point.distanceTo(onSegment.copy(from).addScaledVector(axis, t));
        expect(exact).toBeLessThanOrEqual(far + 1e-9);
      }
    }
  });

  it('should draw what three’s raycaster meets', () => {
    const solids = [
      new Box(0.5, 0.3, 0.2).at(1, 0.2, 0.1).turn({ yaw: 0.4, pitch: 0.3, roll: -0.2 }),
      new Cylinder(0.2, 0.9).at(-1, 0, 0.3).turn({ pitch: 0.5, yaw: 1 }),
    ];
    const world = new World(...solids);
    const material = new MeshBasicMaterial({ side: DoubleSide });
    const meshes = [
      new Mesh(new BoxGeometry(1, 0.6, 0.4), material),
      new Mesh(new CylinderGeometry(0.2, 0.2, 1.8, 512), material),
    ];
    world.root.rotation.set(0.3, 0.1, -0.7);
    world.refresh();
    meshes.forEach((mesh, i) => {
      mesh.matrixAutoUpdate = false;
      mesh.matrixWorld.copy(solids[i]!.object.matrixWorld);
    });
    const field = new SurfaceField(16, 4);
    const center = new Vector3(0.1, 0.2, 0.3);
    world.draw(field, center);
    const raycaster = new Raycaster();
    let seen = 0;
    for (let i = 0; i < field.count; i++) {
      const direction = new Vector3().fromArray(field.direction, 3 * i).normalize();
      raycaster.set(center, direction);
      const hit = raycaster.intersectObjects(meshes)[0];
      if (hit === undefined) {
        expect(field.distance[i]).toBe(Infinity);
        expect(field.object[i]).toBe(0);
        continue;
      }
      seen++;
      expect(field.distance[i]).toBeCloseTo(hit.distance, 3);
      expect(field.objects[field.object[i]! - 1]!).toBe(
        solids[meshes.indexOf(hit.object as (typeof meshes)[0])]!.object,
      );
      const normal = hit.face!.normal.clone().transformDirection(hit.object.matrixWorld);
      if (normal.dot(direction) > 0) normal.negate();
      expect(normal.dot(new Vector3().fromArray(field.normal, 3 * i))).toBeGreaterThan(0.9999);
      expect(field.front[i]).toBe(1);
    }
    expect(seen).toBeGreaterThan(100);
  });

  it('should judge a capsule by its exact depth', () => {
    const world = new World(ground(), wall(1.005));
    world.refresh();
    const judged = world.judge(new Vector3(0.7, 0.1, 3), UP, 0.35, 1.8, { depth: 0, solid: null });
    expect(judged.depth).toBeCloseTo(0.05, 12);
    expect(judged.solid!.object.name).toBe('wall');
    expect(world.judge(new Vector3(0, 0.1, 0), UP, 0.35, 1.8, judged).depth).toBeCloseTo(-0.1, 12);
    const slope = new World(ramp(Math.PI / 4));
    slope.refresh();
    const lift = 0.35 / Math.cos(Math.PI / 4) - 0.35;
    expect(slope.judge(new Vector3(0, lift, 0), UP, 0.35, 1.8, judged).depth).toBeCloseTo(0, 9);
  });

  it.each([10, 60, 90, 170])('should open a corner of %i° as wide as asked', (degrees) => {
    const angle = (degrees * Math.PI) / 180;
    const world = new World(corner(angle));
    world.refresh();
    const judged = world.judge(new Vector3(1, 0, 0), UP, 0.01, 1.8, { depth: 0, solid: null });
    expect(judged.depth - 0.01).toBeCloseTo(Math.max(-0.51, -Math.sin(angle / 2)), 9);
  });

  it('should tell of what moved, came and went since the last draw', () => {
    const box = new Box(0.5, 0.5, 0.5).at(1, 0, 0);
    const far = new Box(0.5, 0.5, 0.5).at(9, 0, 0);
    const world = new World(ground(), box, far);
    const collider = new WorldCollider(world);
    expect(collider.survey().changed).toBe(true);
    collider.update();
    expect(collider.survey()).toMatchObject({ moved: false, changed: false, deforms: false });
    far.object.position.x = 8;
    expect(collider.survey().moved).toBe(false);
    box.object.position.x = 1.1;
    expect(collider.survey().moved).toBe(true);
    collider.update();
    expect(collider.survey().moved).toBe(false);
    box.object.visible = false;
    expect(collider.survey()).toMatchObject({ moved: false, changed: true });
    collider.update();
    expect(collider.survey().changed).toBe(false);
    far.deforms = true;
    world.add(new Box(1, 1, 1, 'new'));
    expect(collider.survey()).toMatchObject({ changed: true, deforms: false });
  });

  it('should hold fields back by as many frames as asked, two at a time', () => {
    const collider = new WorldCollider(new World(ground()), { latency: 3 });
    const serials = Array.from({ length: 9 }, () => {
      collider.tick();
      collider.update();
      return collider.field?.serial ?? 0;
    });
    expect(serials).toEqual([0, 0, 0, 1, 2, 2, 3, 4, 4]);
  });

  it('should draw a random yard in no time to speak of', () => {
    const world = randomWorld(seeded(5));
    world.refresh();
    const field = new SurfaceField(32, 1.8);
    for (let i = 0; i < 20; i++) world.draw(field, new Vector3(i / 3, 1, 0));
    expect(field.distance.some((distance) => distance < 1.8)).toBe(true);
  });
});
