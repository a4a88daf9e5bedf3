import {
  BackSide,
  BoxGeometry,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  Scene,
  Vector3,
} from 'three';
import type { CubeCollider, CubeColliderOptions, SurfaceField } from 'three-cube-collider';
import { DrawnTriangles } from '../support/drawnTriangles.js';
import { deformedKinds } from '../support/kinds/deformedKinds.js';
import type { MakeKind } from '../support/kinds/Kind.js';
import { manyKinds } from '../support/kinds/manyKinds.js';
import { meshKinds } from '../support/kinds/meshKinds.js';
import { type Backend, createRendering, programsOf } from '../support/rendering.js';

const kinds: Record<string, MakeKind> = { ...meshKinds, ...deformedKinds, ...manyKinds };

export interface KindCase {
  name: string;
  /** A model, in base 64. */
  glb?: string;
  collider?: CubeColliderOptions;
  backend?: Backend;
}

export interface KindReport {
  /** Texels whose ray meets the object, over all draws; and texels in all. */
  texels: number;
  all: number;
  /** Of all texels: largest difference among those within a centimetre, metres. */
  worst: number;
  /** Of those that disagree: on an outline. */
  outlines: number;
  /** The others. */
  wrong: string[];
  /** Those that name another object or instance than what they saw. */
  strangers: string[];
  /** Draw calls and programs for the object alone. */
  draws: number;
  programs: number;
}

/** Metres: what counts as the same place. */
const SAME = 0.01;
const center = new Vector3(3, 1, -2);

const POSES: [place: number[], turn: number[], scale: number[]][] = [
  [
    [0.8, 0.1, 0.2],
    [0, 0, 0],
    [1, 1, 1],
  ],
  [
    [-0.3, 0.6, -0.7],
    [0.5, 1.1, -0.4],
    [1, 1, 1],
  ],
  [
    [0.2, -0.8, 0.5],
    [0.9, 0.2, 2],
    [1.5, 0.6, 1.1],
  ],
  [
    [-0.7, 0.2, 0.6],
    [-0.6, 0.3, 0.8],
    [-1, 1.2, 0.9],
  ],
];

/** One kind of object in a room, in four poses, each before and after it changed: every texel against its own ray. */
export default async function kind({
  name,
  glb,
  collider: options,
  backend,
}: KindCase): Promise<KindReport> {
  const rendering = await createRendering(backend);
  const { renderer } = rendering;
  const model = glb ? Uint8Array.from(atob(glb), (char) => char.charCodeAt(0)) : null;
  const made = await kinds[name]!(renderer, model);
  const before = programsOf(renderer);
  const scene = new Scene().add(made.object);
  const room = new Mesh(new BoxGeometry(3, 3, 3), new MeshBasicMaterial({ side: BackSide }));
  room.position.copy(center);
  const collider = rendering.collider({ far: 4, resolution: 16, readback: 'sync', ...options });
  collider.position.copy(center);
  const report: KindReport = {
    texels: 0,
    all: 0,
    worst: 0,
    outlines: 0,
    wrong: [],
    strangers: [],
    draws: 0,
    programs: 0,
  };
  for (const [i, [place, turn, scale]] of POSES.entries()) {
    const { object } = made;
    object.position.fromArray(place).add(center);
    object.rotation.set(turn[0]!, turn[1]!, turn[2]!);
    object.scale.fromArray(scale);
    if (i === 0) {
      await rendering.see(collider, scene);
      report.draws = collider.stats.drawCalls;
      // One is of the pass that keeps the nearest texels.
      const passes = collider.supersample > 1 || rendering.backend !== 'WebGL2' ? 1 : 0;
      report.programs = programsOf(renderer) - before - passes;
      scene.add(room);
    }
    for (let j = 0; j < 2; j++) {
      await rendering.see(collider, scene);
      const triangles = new DrawnTriangles([{ mesh: room }, ...made.shown()]);
      judge(collider, triangles, room, `pose ${i}, ${j === 0 ? 'placed' : 'changed'}`, report);
      // Then it has only moved.
      if (i % 2 === 1) break;
      if (j === 0) made.change();
    }
  }
  collider.dispose();
  renderer.dispose();
  return report;
}

/** Every texel of the newest field. */
function judge(
  collider: CubeCollider,
  triangles: DrawnTriangles,
  room: Object3D,
  when: string,
  report: KindReport,
): void {
  const field = collider.field!;
  const direction = new Vector3();
  for (let texel = 0; texel < field.count; texel++) {
    direction.fromArray(field.direction, 3 * texel).normalize();
    report.all++;
    const seen = field.distance[texel]!;
    const real = triangles.cast(field.center, direction, collider.near);
    const mesh = triangles.meshes[triangles.hit];
    if (mesh !== undefined && mesh !== room) report.texels++;
    const error = Math.abs(seen - real);
    const right = seen === real || error <= SAME;
    if (right && nameOf(field, texel) === nameOfHit(triangles)) {
      if (error > report.worst) report.worst = error;
      continue;
    }
    if (isOutline(collider, triangles, texel)) report.outlines++;
    else if (right) report.strangers.push(`${when}, texel ${texel}: ${nameOf(field, texel)}`);
    else report.wrong.push(`${when}, texel ${texel}: ${seen} for ${real}`);
  }
}

/**
 * Where rays less than a drawn texel apart meet other things, a rasteriser's grid decides which it is. The texel may
 * then be anything between the nearest and the farthest that such rays meet, by the name of one that they meet.
 */
function isOutline(
  { field, near, resolution, supersample }: CubeCollider,
  triangles: DrawnTriangles,
  texel: number,
): boolean {
  const direction = new Vector3().fromArray(field!.direction, 3 * texel).normalize();
  const side = new Vector3(direction.y, direction.z, direction.x).cross(direction).normalize();
  const other = new Vector3().crossVectors(direction, side);
  const names = new Set<string>();
  let nearest = Infinity;
  let farthest = 0;
  for (let i = 0; i < 24; i++) {
    const spread = (i < 8 ? 0.5 : 1) / (resolution * supersample);
    const angle = (i * Math.PI) / (i < 8 ? 4 : 8);
    const around = direction
      .clone()
      .addScaledVector(side, spread * Math.cos(angle))
      .addScaledVector(other, spread * Math.sin(angle))
      .normalize();
    const real = triangles.cast(field!.center, around, near);
    nearest = Math.min(nearest, real);
    farthest = Math.max(farthest, real);
    names.add(nameOfHit(triangles));
  }
  const seen = field!.distance[texel]!;
  const between = seen >= nearest - SAME && seen <= farthest + SAME;
  return between && names.has(nameOf(field!, texel));
}

function nameOf(field: SurfaceField, texel: number): string {
  const number = field.object[texel]!;
  return number === 0 ? '' : `${field.objects[number - 1]!.uuid} ${field.instance[texel]}`;
}

function nameOfHit({ hit, meshes, instances }: DrawnTriangles): string {
  return hit < 0 ? '' : `${meshes[hit]!.uuid} ${instances[hit]}`;
}
