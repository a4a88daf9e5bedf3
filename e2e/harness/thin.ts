import {
  BackSide,
  BoxGeometry,
  CylinderGeometry,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Raycaster,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { CubeCollider, type CubeColliderOptions } from 'three-cube-collider';
import { seededRandom, type ThinThing, thinThing } from '../support/thinThings.js';

export interface ThinCase {
  collider?: CubeColliderOptions;
  kind: 'pole' | 'rail';
  /** Metres, if not the kind's own. */
  width?: number;
  count: number;
  seed: number;
}

export interface ThinReport {
  format: string | null;
  /** Things that no texel saw, as text to try again with. */
  missed: string[];
  /** Texels that saw the thing; those whose own ray passes by or meets it elsewhere; of these, those with a point off it. */
  texels: number;
  beside: number;
  off: number;
  /** Texels that see it and name another object, or another instance. */
  strangers: number;
  /** Of the texels whose ray meets it: the largest difference, metres. */
  worst: number;
}

/** How far a texel's point may lie from what it saw, metres. */
const NEAR = 0.002;
const EXACT = 0.001;
/** Of the 300 instances, the thing's number: it takes more than a byte. */
const INSTANCE = 258;

/** One thin thing after another at seeded places around the centre: alone, or in a room whose walls are behind it. */
export default function thin(test: ThinCase): ThinReport {
  const renderer = new WebGLRenderer();
  const collider = new CubeCollider({ readback: 'sync', ...test.collider });
  const room = new Mesh(new BoxGeometry(3.4, 3.4, 3.4), new MeshBasicMaterial({ side: BackSide }));
  const material = new MeshBasicMaterial();
  const scene = new Scene();
  const random = seededRandom(test.seed);
  const ray = new Raycaster();
  const point = new Vector3();
  const direction = new Vector3();
  const report: ThinReport = {
    format: null,
    missed: [],
    texels: 0,
    beside: 0,
    off: 0,
    strangers: 0,
    worst: 0,
  };
  for (let i = 0; i < test.count; i++) {
    const thing = thinThing(test.kind, random, test.width);
    const mesh = meshOf(thing, material);
    collider.position.set(20 * random(), 20 * random(), 20 * random());
    room.position.copy(collider.position);
    mesh.position.add(collider.position);
    mesh.updateMatrixWorld();
    // Alone, before walls, and as one of several instances, before walls again.
    const drawn = i % 3 === 2 ? oneOfSeveral(mesh) : mesh;
    scene.children.length = 0;
    scene.add(drawn);
    if (i % 3 > 0) scene.add(room);
    collider.update(renderer, scene);
    const field = collider.field!;
    let seen = 0;
    for (let texel = 0; texel < field.count; texel++) {
      if (field.distance[texel] === Infinity) continue;
      const object = field.objects[field.object[texel]! - 1];
      if (i % 3 > 0 && object === room) continue;
      const instance = drawn === mesh ? 0 : INSTANCE;
      if (object !== drawn || field.instance[texel] !== instance) report.strangers++;
      field.point(texel, point);
      const offset = thing.distance(point.sub(mesh.position));
      if (Math.abs(offset) <= NEAR) seen++;
      report.texels++;
      direction.fromArray(field.direction, 3 * texel).normalize();
      ray.set(field.center, direction);
      const hit = ray.intersectObject(mesh, false)[0];
      const error = hit ? Math.abs(hit.distance - field.distance[texel]!) : Infinity;
      if (error <= EXACT) {
        report.worst = Math.max(report.worst, error);
        continue;
      }
      report.beside++;
      // The rasteriser's grid moves outlines by a part of a texel: a texel there may see what its ray just misses.
      if (Math.abs(offset) > NEAR) report.off++;
    }
    if (seen === 0) report.missed.push(JSON.stringify({ i, ...thing }));
    if (drawn !== mesh) (drawn as InstancedMesh).dispose();
    mesh.geometry.dispose();
  }
  report.format = collider.format;
  collider.dispose();
  renderer.dispose();
  return report;
}

function meshOf(thing: ThinThing, material: MeshBasicMaterial): Mesh {
  const { width, length, round } = thing;
  const geometry = round
    ? new CylinderGeometry(width / 2, width / 2, length, thing.sides)
    : new BoxGeometry(width, length, width);
  const mesh = new Mesh(geometry, material);
  mesh.position.copy(thing.middle);
  mesh.quaternion.copy(thing.turn);
  mesh.updateMatrixWorld();
  return mesh;
}

/** `mesh` as an instance among others, which are far away. */
function oneOfSeveral(mesh: Mesh): InstancedMesh {
  const instances = new InstancedMesh(mesh.geometry, mesh.material, 300);
  const elsewhere = new Matrix4().makeTranslation(0, -1000, 0);
  for (let i = 0; i < instances.count; i++) instances.setMatrixAt(i, elsewhere);
  instances.setMatrixAt(INSTANCE, mesh.matrixWorld);
  return instances;
}
