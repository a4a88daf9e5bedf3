import {
  type Layers,
  type LOD,
  type Material,
  type Mesh,
  type Object3D,
  Sphere,
  type Vector3,
} from 'three';
import { FACES } from '../cube/faces.js';
import { faultOf } from './faultOf.js';
import { isSolid } from './isSolid.js';
import { isLevel, levelShown } from './levelShown.js';
import { worldSphere } from './worldSphere.js';

/** What decides whether an object is solid. */
export interface SelectionRules {
  /** Objects that share no layer with these are passed over. */
  readonly layers: Layers;
  /** Returning false makes an object (not what is below it) no obstacle. */
  readonly filter: ((object: Object3D) => boolean) | null;
  /** Left out with all below them: the character's own avatar. */
  readonly excluded: ReadonlySet<Object3D>;
  /** Told of each mesh that cannot be drawn, in every walk that comes near it. */
  readonly faulty?: (mesh: Mesh, fault: string) => void;
}

/** Who is told what a walk finds. */
export interface WalkListener {
  /** @param faces a bit for each face of the cubemap that the mesh may be seen in, never 0 */
  solid(mesh: Mesh, faces: number): void;
  /** An object with a geometry that reports and does not block. */
  sensor(object: Mesh): void;
}

const ALL_FACES = 0b111111;
const sphere = new Sphere();

/**
 * Walks the visible scene and tells what the cubemap may see of it: one set of rules for what is drawn and for what is
 * looked at between draws. It does not know which objects moved, so its cost grows with the number of objects (not with
 * their triangles).
 */
export class SceneWalk {
  readonly #listener: WalkListener;
  #rules!: SelectionRules;
  #center!: Vector3;
  #far = 0;

  constructor(listener: WalkListener) {
    this.#listener = listener;
  }

  /**
   * Refreshes the scene's world matrices as its next render would, then walks it. Allocates nothing.
   *
   * @param center world space
   * @param far metres
   */
  walk(scene: Object3D, center: Vector3, far: number, rules: SelectionRules): void {
    if (scene.matrixWorldAutoUpdate) scene.updateMatrixWorld();
    this.#rules = rules;
    this.#center = center;
    this.#far = far;
    this.#visit(scene);
  }

  /** Visible objects, as the renderer walks them: an invisible one hides what is below it. */
  #visit(object: Object3D): void {
    const { userData } = object;
    if (!object.visible || userData.collider === false) return;
    if (this.#rules.excluded.has(object)) return;
    if (userData.sensor === true) this.#considerSensor(object as Mesh);
    else if ((object as Mesh).isMesh && object.layers.test(this.#rules.layers))
      this.#considerMesh(object as Mesh);
    const { children } = object;
    if ((object as LOD).isLOD) this.#visitLevels(object as LOD);
    else for (let i = 0; i < children.length; i++) this.#visit(children[i]!);
  }

  #visitLevels(lod: LOD): void {
    const shown = levelShown(lod, this.#center);
    const { children } = lod;
    for (let i = 0; i < children.length; i++) {
      const child = children[i]!;
      if (shown === null || child === shown || !isLevel(lod, child)) this.#visit(child);
    }
  }

  #considerMesh(mesh: Mesh): void {
    // Without any it is told of below.
    if ((mesh.material ?? null) !== null && !anySolid(mesh.material)) return;
    const placed = mesh.frustumCulled && mesh.geometry?.attributes.position;
    const faces = placed ? this.#facesTouched(mesh) : ALL_FACES;
    if (faces === 0) return;
    if (this.#rules.filter?.(mesh) === false) return;
    const fault = faultOf(mesh);
    if (fault === null) this.#listener.solid(mesh, faces);
    else this.#rules.faulty?.(mesh, fault);
  }

  /** It needs no material: only where its geometry is matters. */
  #considerSensor(object: Mesh): void {
    if (!object.geometry?.attributes?.position || !object.layers.test(this.#rules.layers)) return;
    if (this.#facesTouched(object) !== 0) this.#listener.sensor(object);
  }

  /** A bit for each face whose pyramid the mesh's bounding sphere touches; 0 if it is out of reach, all if it has none. */
  #facesTouched(mesh: Mesh): number {
    if (!worldSphere(mesh, sphere)) return ALL_FACES;
    if (!(sphere.radius >= 0)) return 0;
    const x = sphere.center.x - this.#center.x;
    const y = sphere.center.y - this.#center.y;
    const z = sphere.center.z - this.#center.z;
    const reach = sphere.radius + this.#far;
    if (x * x + y * y + z * z > reach * reach) return 0;
    // The pyramid's planes stand at 45°: a point is inside where forward ± right >= 0 and forward ± up >= 0.
    const slack = -Math.SQRT2 * sphere.radius;
    let mask = 0;
    for (let face = 0; face < 6; face++) {
      const { forward, right, up } = FACES[face]!;
      const f = x * forward[0] + y * forward[1] + z * forward[2];
      const r = Math.abs(x * right[0] + y * right[1] + z * right[2]);
      const u = Math.abs(x * up[0] + y * up[1] + z * up[2]);
      if (f - r >= slack && f - u >= slack) mask |= 1 << face;
    }
    return mask;
  }
}

function anySolid(material: Material | Material[]): boolean {
  if (!Array.isArray(material)) return isSolid(material);
  for (let i = 0; i < material.length; i++) if (isSolid(material[i])) return true;
  return false;
}
