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
import { boxOf, facesOfBox } from './boxFaces.js';
import { faultOf } from './faultOf.js';
import { isComputed } from './isRigid.js';
import { isSolid, type Solidity, solidityOf, type TransparentPolicy } from './isSolid.js';
import { isLevel, levelShown } from './levelShown.js';
import { movesVertices } from './materialKind.js';
import type { SceneIndex } from './SceneIndex.js';
import type { SceneNode } from './SceneNode.js';
import { isPlain } from './verticesOf.js';

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
  /** What see-through things are. Default 'ignore'. */
  readonly transparent?: TransparentPolicy;
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
 * Tells what the cubemap may see of a scene: one set of rules for what is drawn and for what is looked at between draws.
 * It asks only those that its index holds to be near, so its cost does not grow with what is far.
 */
export class SceneWalk {
  readonly #index: SceneIndex;
  readonly #listener: WalkListener;
  #rules!: SelectionRules;
  #center!: Vector3;
  #far = 0;

  constructor(index: SceneIndex, listener: WalkListener) {
    this.#index = index;
    this.#listener = listener;
  }

  /**
   * Refreshes the world matrices of what is near as the scene's next render would, then tells of it. Allocates nothing
   * where nothing came or went.
   *
   * @param center world space
   * @param far metres
   * @param scan whether to look at a part of what is far as well, for what has moved: once a frame
   */
  walk(scene: Object3D, center: Vector3, far: number, rules: SelectionRules, scan: boolean): void {
    this.#rules = rules;
    this.#center = center;
    this.#far = far;
    this.#index.update(scene, center, far, scan);
    const { near, call } = this.#index;
    for (let i = 0; i < near.length; i++) this.#consider(near[i]!, call);
  }

  #consider(node: SceneNode, call: number): void {
    const { object } = node;
    if (!this.#shows(node, call)) {
      // A wall that nobody sees: made solid by name, alone.
      if (object.userData.collider === true && this.#showsButFor(node, call))
        this.#considerIfMesh(node);
      return;
    }
    if (object.userData.sensor === true) this.#considerSensor(node);
    else this.#considerIfMesh(node);
  }

  #considerIfMesh(node: SceneNode): void {
    const { object } = node;
    if ((object as Mesh).isMesh && object.layers.test(this.#rules.layers)) this.#considerMesh(node);
  }

  /** As the renderer sees it: an invisible object hides what is below it. So do our own rules. */
  #shows(node: SceneNode, call: number): boolean {
    if (node.asked === call) return node.shows;
    node.asked = call;
    const { object } = node;
    node.shows =
      object.visible && object.userData.collider !== false && this.#showsButFor(node, call);
    return node.shows;
  }

  /** The same, whatever it says itself. */
  #showsButFor({ object, parent }: SceneNode, call: number): boolean {
    return (
      !this.#rules.excluded.has(object) &&
      (parent === null || (this.#shows(parent, call) && this.#isShownBy(parent.object, object)))
    );
  }

  /** Of several levels an `LOD` shows one. */
  #isShownBy(parent: Object3D, child: Object3D): boolean {
    if (!(parent as LOD).isLOD) return true;
    const shown = levelShown(parent as LOD, this.#center);
    return shown === null || child === shown || !isLevel(parent as LOD, child);
  }

  #considerMesh(node: SceneNode): void {
    const mesh = node.object as Mesh;
    const { material } = mesh;
    const none = (material ?? null) === null;
    // Without any it is told of below.
    if (!none && !anySolid(material, solidityOf(mesh, this.#rules.transparent))) return;
    let faces = mesh.frustumCulled ? this.#facesTouched(node) : ALL_FACES;
    if (faces === 0) return;
    // The bounds tell that it is near; of which faces shaders move it into they tell nothing.
    if (!none && (mayMoveVertices(material) || isComputed(mesh))) faces = ALL_FACES;
    if (this.#rules.filter?.(mesh) === false) return;
    const fault = faultOf(mesh);
    if (fault !== null) {
      this.#rules.faulty?.(mesh, fault);
      return;
    }
    if (mesh.frustumCulled && isPlain(mesh)) {
      const box = boxOf(mesh.geometry);
      if (box !== null) faces &= facesOfBox(box, mesh.matrixWorld, this.#center, this.#far);
    }
    if (faces !== 0) this.#listener.solid(mesh, faces);
  }

  /** It needs no material: only where its geometry is matters. */
  #considerSensor(node: SceneNode): void {
    const object = node.object as Mesh;
    if (!object.geometry?.attributes?.position || !object.layers.test(this.#rules.layers)) return;
    if (this.#facesTouched(node) !== 0) this.#listener.sensor(object);
  }

  /** A bit for each face whose pyramid the mesh's bounding sphere touches; 0 if it is out of reach, all if it has none. */
  #facesTouched(node: SceneNode): number {
    this.#index.sphereOf(node, sphere);
    if (sphere.radius === Infinity) return ALL_FACES;
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

function anySolid(material: Material | Material[], solidity: Solidity): boolean {
  if (!Array.isArray(material)) return isSolid(material, solidity);
  for (let i = 0; i < material.length; i++) if (isSolid(material[i], solidity)) return true;
  return false;
}

function mayMoveVertices(material: Material | Material[]): boolean {
  if (!Array.isArray(material)) return movesVertices(material);
  for (let i = 0; i < material.length; i++) {
    const each = material[i];
    if (each && movesVertices(each)) return true;
  }
  return false;
}
