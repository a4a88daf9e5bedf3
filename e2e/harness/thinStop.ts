import {
  BoxGeometry,
  CylinderGeometry,
  Line3,
  Mesh,
  MeshBasicMaterial,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { CharacterController, CubeCollider, type CubeColliderOptions } from 'three-cube-collider';
import { seededRandom } from '../support/thinThings.js';

export interface StopCase {
  collider?: CubeColliderOptions;
  kind: 'pole' | 'rail';
  count: number;
  seed: number;
}

export interface StopReport {
  /** Walks on which the body's middle line went into the thing. */
  through: string[];
  /** Deepest that the thing was in the capsule on each walk, metres; negative for a gap. */
  penetrations: number[];
}

/** Walks at one thin thing after another: an upright pole, or a level rail at a body's height, from any side. */
export default function thinStop(test: StopCase): StopReport {
  const renderer = new WebGLRenderer();
  const random = seededRandom(test.seed);
  const between = (low: number, high: number) => low + (high - low) * random();
  const floor = new Mesh(new BoxGeometry(8, 0.2, 8), new MeshBasicMaterial());
  const report: StopReport = { through: [], penetrations: [] };
  const pole = test.kind === 'pole';
  const width = pole ? 0.01 : 0.03;
  for (let i = 0; i < test.count; i++) {
    const collider = new CubeCollider({ readback: 'sync', ...test.collider });
    const character = new CharacterController(collider);
    const start = new Vector3(between(-1, 1), 0.02, between(-1, 1));
    const angle = between(0, 2 * Math.PI);
    const ahead = new Vector3(Math.cos(angle), 0, Math.sin(angle));
    const aside = new Vector3(-ahead.z, 0, ahead.x);
    const middle = start
      .clone()
      .addScaledVector(ahead, between(0.7, 1.2))
      .addScaledVector(aside, pole ? between(-0.25, 0.25) : 0);
    const height = pole ? 1 : between(0.5, 1.6);
    middle.y = height;
    const half = pole ? 1 : between(0.8, 2);
    // A rail lies across the way, more or less.
    const axis = pole
      ? new Vector3(0, 1, 0)
      : aside.clone().applyAxisAngle(new Vector3(0, 1, 0), between(-0.7, 0.7));
    const thing = new Mesh(
      new CylinderGeometry(width / 2, width / 2, 2 * half, 16),
      new MeshBasicMaterial(),
    );
    thing.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), axis);
    thing.position.copy(middle);
    floor.position.y = -0.1;
    const scene = new Scene().add(floor, thing);
    const line = new Line3(
      middle.clone().addScaledVector(axis, -half),
      middle.clone().addScaledVector(axis, half),
    );
    const speed = between(1, 6);
    character.teleport(start);
    character.walk(ahead.clone().multiplyScalar(speed));
    let nearest = Infinity;
    const { radius } = character.body;
    const bottom = new Vector3();
    const top = new Vector3();
    const body = new Line3(bottom, top);
    const frames = Math.ceil((60 * 2.4) / speed);
    for (let frame = 0; frame < frames; frame++) {
      character.update(renderer, scene, 1 / 60);
      const { position, height } = character.body;
      bottom.copy(position).setY(position.y + radius);
      top.copy(position).setY(position.y + height - radius);
      nearest = Math.min(nearest, gap(body, line));
    }
    report.penetrations.push(radius + width / 2 - nearest);
    if (nearest < width / 2) report.through.push(JSON.stringify({ i, nearest, speed }));
    character.dispose();
    collider.dispose();
    thing.geometry.dispose();
  }
  renderer.dispose();
  return report;
}

/** Distance between two segments, by halving one (the distance along it is convex). */
function gap(a: Line3, b: Line3): number {
  const p = new Vector3();
  const q = new Vector3();
  const at = (t: number) => p.copy(a.at(t, p)).distanceTo(b.closestPointToPoint(p, true, q));
  let low = 0;
  let high = 1;
  for (let i = 0; i < 50; i++) {
    const first = low + (high - low) / 3;
    const second = high - (high - low) / 3;
    if (at(first) < at(second)) high = second;
    else low = first;
  }
  return at((low + high) / 2);
}
