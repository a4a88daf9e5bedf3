import {
  type BufferGeometry,
  BoxGeometry,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Scene,
  Vector3,
} from 'three';
import { StaticGeometryGenerator } from 'three-mesh-bvh';

/** Walked at, m/s: not run, so that a step is a step. */
export const SPEED = 3;

/** A place to walk in for some seconds, straight on. */
export interface FeelCase {
  name: string;
  scene: Scene;
  /** The same in one mesh, world space. */
  geometry: BufferGeometry;
  /** Where it begins, over the floor. */
  from: Vector3;
  /** Wanted, m/s. */
  velocity: Vector3;
  seconds: number;
  /** Which way progress is measured, unit vector over ground, and how far that should lead, metres. */
  along: Vector3;
  ideal: number;
}

const RISE = 0.17;
const TREAD = 0.29;
const STEPS = 24;
/** Degrees. */
const SLOPES = [20, 40];
/** Between the way and the wall, degrees. */
const ANGLES = [10, 30, 50, 70];

const FORTH = new Vector3(1, 0, 0);

/** Every case, made anew. */
export function feelCases(): FeelCase[] {
  return [
    straight('flat ground', 2, [], -2),
    straight('stairs up', 2.5, stairs(), -1),
    straight('stairs down', 2.5, stairs(), 0.5 + STEPS * TREAD, true),
    straight('kerb, 0.15 m', 2, [block(0, 20, -10, 10, -1, 0.15)], -2),
    ...SLOPES.map((degrees) => slope(degrees)),
    ...ANGLES.map((degrees) => wallSlide(degrees)),
  ];
}

/** From `x` toward +X, or back. */
function straight(
  name: string,
  seconds: number,
  solids: Mesh[],
  x: number,
  back = false,
): FeelCase {
  const along = FORTH.clone().multiplyScalar(back ? -1 : 1);
  const velocity = along.clone().multiplyScalar(SPEED);
  const from = new Vector3(x, back ? STEPS * RISE : 0, 0);
  return make(name, solids, { from, velocity, seconds, along, ideal: SPEED * seconds });
}

function stairs(): Mesh[] {
  const steps = Array.from({ length: STEPS }, (_, i) =>
    block(i * TREAD, (i + 1) * TREAD, -3, 3, -1, (i + 1) * RISE),
  );
  return [...steps, block(STEPS * TREAD, STEPS * TREAD + 20, -3, 3, -1, STEPS * RISE)];
}

/** The wanted speed is one over ground: so far it should come. */
function slope(degrees: number): FeelCase {
  const angle = (degrees * Math.PI) / 180;
  const slab = block(0, 20, -5, 5, -0.2, 0);
  slab.geometry.rotateZ(angle);
  return straight(`ramp, ${degrees}°`, 2, [slab], -1);
}

/** Held against a wall: what is left of the wish along it is the ideal. */
function wallSlide(degrees: number): FeelCase {
  const angle = (degrees * Math.PI) / 180;
  const seconds = 2;
  const along = FORTH.clone();
  const velocity = new Vector3(Math.cos(angle), 0, Math.sin(angle)).multiplyScalar(SPEED);
  const from = new Vector3(-5, 0, 0);
  // Its near side touches the body, but for a centimetre.
  const wall = block(-20, 20, 0.36, 0.86, -1, 3);
  const ideal = SPEED * Math.cos(angle) * seconds;
  return make(`wall, at ${degrees}°`, [wall], { from, velocity, seconds, along, ideal });
}

function make(
  name: string,
  solids: Mesh[],
  rest: Omit<FeelCase, 'name' | 'scene' | 'geometry'>,
): FeelCase {
  const ground = new PlaneGeometry(60, 60).rotateX(-Math.PI / 2);
  const scene = new Scene().add(new Mesh(ground, new MeshBasicMaterial()), ...solids);
  scene.updateMatrixWorld();
  const generator = new StaticGeometryGenerator(scene);
  generator.attributes = ['position'];
  generator.useGroups = false;
  return { name, scene, geometry: generator.generate(), ...rest };
}

function block(
  minX: number,
  maxX: number,
  minZ: number,
  maxZ: number,
  minY: number,
  maxY: number,
): Mesh<BoxGeometry, MeshBasicMaterial> {
  const geometry = new BoxGeometry(maxX - minX, maxY - minY, maxZ - minZ);
  geometry.translate((minX + maxX) / 2, (minY + maxY) / 2, (minZ + maxZ) / 2);
  return new Mesh(geometry, new MeshBasicMaterial());
}
