import {
  type BufferGeometry,
  type Material,
  type Mesh,
  type Object3D,
  type SkinnedMesh,
  Sphere,
  type Vector3,
} from 'three';
import { Judge } from '../../bench/rivals/Judge.js';
import { SHAPE } from '../../bench/rivals/shape.js';
import { solidGeometry, solidMeshes } from '../../bench/rivals/solidGeometry.js';
import type { Hall } from '../hall/createHall.js';
import { drawnVertex } from '../hall/drawnVertex.js';

/** What only a shader moves stays within this of its own vertices, metres. */
const SHADERS = 0.6;
/** Free is who keeps this from everything; how far up a free place is looked for, and in what steps, metres. */
const FREE = 0.005;
const HIGHEST = 3;
const STEP = 0.05;

/** How deep a body is in what is drawn. */
export interface Penetration {
  /** Metres; negative is a gap. */
  depth: number;
  /** In what, if it does not stand still. */
  mesh: Mesh | null;
}

/**
 * The scene as rivals get it, and as a judge sees it who knows neither them nor cubemaps: by exact distances to the
 * triangles that are drawn at this moment, all but those that an alpha test cuts.
 */
export class Scenery {
  readonly #scene: Object3D;
  readonly #hall: Hall | null;
  readonly #movers: Object3D | null;
  readonly #ignored: Object3D;
  #still: Judge | null = null;
  #restless: Mesh[] = [];

  /** @param movers what moves as a whole @param ignored the avatar */
  constructor(scene: Object3D, hall: Hall | null, movers: Object3D | null, ignored: Object3D) {
    this.#scene = scene;
    this.#hall = hall;
    this.#movers = movers;
    this.#ignored = ignored;
    scene.updateMatrixWorld();
  }

  /**
   * What a rival is built of, once: everything solid that is neither posed nor a lift. Shaders are not known: what they
   * move lies where its vertices are, and what they cut out is there.
   */
  geometry(): BufferGeometry {
    return solidGeometry(this.#solid().filter((mesh) => !this.#moves(mesh)));
  }

  /** How deep a capsule that stands on `foot` is in what is drawn now. */
  penetration(foot: Vector3, height: number = SHAPE.height): Penetration {
    return this.#judges(foot, HIGHEST)
      .map(({ judge, mesh }) => ({ depth: judge.penetration(foot, SHAPE.radius, height), mesh }))
      .reduce((deepest, each) => (each.depth > deepest.depth ? each : deepest));
  }

  /** Lifts a foot out of what is drawn there, to the first free place above it; leaves it if there is none. */
  free(foot: Vector3): Vector3 {
    const judges = this.#judges(foot, HIGHEST + SHAPE.height);
    const free = foot.clone();
    for (let up = 0; up < HIGHEST; up += STEP) {
      free.y = foot.y + up;
      if (judges.every(({ judge }) => judge.penetration(free) < -FREE)) return free;
    }
    return foot;
  }

  /** One of all that stands still, and one of each thing near by that does not, as it is now. */
  #judges(foot: Vector3, reach: number): { judge: Judge; mesh: Mesh | null }[] {
    this.#still ??= this.#judgeStill();
    const place = drawnVertex(this.#hall);
    const near = this.#restless.filter((mesh) => isNear(mesh, foot, reach));
    for (const mesh of near) mesh.updateWorldMatrix(true, true);
    const moving = near.map((mesh) => ({ judge: new Judge(solidGeometry([mesh], place)), mesh }));
    return [{ judge: this.#still, mesh: null }, ...moving];
  }

  #judgeStill(): Judge {
    const all = this.#solid().filter((mesh) => !isCut(mesh));
    this.#restless = all.filter((mesh) => this.#moves(mesh) || this.#isShaded(mesh));
    const restless = new Set(this.#restless);
    return new Judge(solidGeometry(all.filter((mesh) => !restless.has(mesh))));
  }

  #solid(): Mesh[] {
    return solidMeshes(this.#scene, (object) => object !== this.#ignored);
  }

  #moves(mesh: Mesh): boolean {
    if ((mesh as Partial<SkinnedMesh>).isSkinnedMesh) return true;
    if (mesh.geometry.morphAttributes.position !== undefined) return true;
    for (let at: Object3D | null = mesh; at !== null; at = at.parent) {
      if (at === this.#movers) return true;
    }
    return false;
  }

  #isShaded(mesh: Mesh): boolean {
    return mesh === this.#hall?.waves.object || mesh === this.#hall?.wall.sheet;
  }
}

/** By an alpha test: there its triangles tell nothing. */
function isCut({ material }: Mesh): boolean {
  return ([material].flat() as Material[]).some(({ alphaTest }) => alphaTest > 0);
}

const sphere = new Sphere();

function isNear(mesh: Mesh, foot: Vector3, reach: number): boolean {
  const { geometry } = mesh;
  if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
  sphere.copy((mesh as Partial<SkinnedMesh>).boundingSphere ?? geometry.boundingSphere!);
  mesh.updateWorldMatrix(true, false);
  sphere.applyMatrix4(mesh.matrixWorld).radius += SHADERS + SHAPE.radius + reach;
  return sphere.containsPoint(foot);
}
