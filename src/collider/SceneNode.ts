import { type BufferGeometry, Camera, Object3D, SkinnedMesh } from 'three';

/** How an object's world matrix is kept: by three's own rules, as a skin, or by code of its own. */
const enum Upkeep {
  Plain,
  Skin,
  Own,
}

/** What a refreshed object means for those below it. */
const enum Below {
  /** They follow only if they changed themselves. */
  Free,
  /** Their parent moved: they follow. */
  Follow,
  /** They were seen to by an object above that has its own way. */
  Done,
}

/** What the collider keeps of one object of the user's scene, so that it need not walk there to know of it. */
export class SceneNode {
  readonly object: Object3D;
  parent: SceneNode | null;
  /** What was below it when it was looked at last, in the order of its children. */
  children: SceneNode[] = [];
  /** The object's parent, as it was found; another one means that it has gone. */
  foundUnder: Object3D | null;
  /** Where its bounding sphere is kept; -1 once it is gone. */
  slot = -1;
  /** Its place in the list of those that may hold others; -1 if it is not there. */
  holder = -1;
  /** Grows in the order in which objects were found: depth first. */
  order = 0;
  /** Is it watched in every call? */
  near = false;
  /** Calls in which it was last found in place, refreshed, taken over and asked whether it shows. */
  verified = 0;
  kept = 0;
  asked = 0;
  shows = false;
  /** What `Stillness` keeps: the call it last looked in, the object's last move and its parent's, and by what it was told. */
  settled = 0;
  moved = 0;
  above = 0;
  posed = false;
  /** Of whose bounding sphere, after which move, the object's was found. */
  geometry: BufferGeometry | null = null;
  noted = 0;
  #refreshed = 0;
  #below = Below.Free;
  readonly #upkeep: Upkeep;
  readonly #plain: boolean;
  /** Is there one above it that has its own way? */
  #led = false;

  constructor(object: Object3D, parent: SceneNode | null) {
    this.object = object;
    this.parent = parent;
    this.foundUnder = object.parent;
    this.#upkeep = upkeepOf(object);
    this.#plain =
      this.#upkeep === Upkeep.Plain && object.updateMatrix === Object3D.prototype.updateMatrix;
  }

  /** Does its world matrix follow from its parent's and from its own position, quaternion and scale alone? */
  isPosed(): boolean {
    const { object, parent } = this;
    this.#led = parent !== null && (parent.#led || parent.#upkeep === Upkeep.Own);
    return (
      this.#plain &&
      !this.#led &&
      object.matrixAutoUpdate &&
      object.matrixWorldAutoUpdate &&
      !object.pivot
    );
  }

  /**
   * Brings the object's world matrix up to date, and those above it, as the scene's own `updateMatrixWorld` would, but
   * not their other children's. As those have still to follow, `matrixWorldNeedsUpdate` stays set where there are any,
   * until the next render. Of an object with an `updateMatrixWorld` of its own that is called, and sees to all below.
   *
   * @param call number of the call: a second time in the same one it does nothing
   */
  refresh(call: number): Below {
    if (this.#refreshed === call) return this.#below;
    this.#refreshed = call;
    const above = this.parent === null ? Below.Free : this.parent.refresh(call);
    if (above === Below.Done) return (this.#below = Below.Done);
    const { object } = this;
    if (this.#upkeep === Upkeep.Own) {
      object.updateMatrixWorld(above === Below.Follow);
      return (this.#below = Below.Done);
    }
    if (object.matrixAutoUpdate) object.updateMatrix();
    this.#below = above;
    if (object.matrixWorldNeedsUpdate || above === Below.Follow) {
      this.#below = Below.Follow;
      if (object.matrixWorldAutoUpdate) {
        if (object.parent === null) object.matrixWorld.copy(object.matrix);
        else object.matrixWorld.multiplyMatrices(object.parent.matrixWorld, object.matrix);
      }
      if (object.children.length === 0) object.matrixWorldNeedsUpdate = false;
    }
    if (this.#upkeep === Upkeep.Skin) bind(object as SkinnedMesh);
    return this.#below;
  }
}

/** As `SkinnedMesh.updateMatrixWorld` ends. */
function bind(skin: SkinnedMesh): void {
  const from = skin.bindMode === 'detached' ? skin.bindMatrix : skin.matrixWorld;
  skin.bindMatrixInverse.copy(from).invert();
}

function upkeepOf(object: Object3D): Upkeep {
  const { updateMatrixWorld } = object;
  if (updateMatrixWorld === Object3D.prototype.updateMatrixWorld) return Upkeep.Plain;
  if (updateMatrixWorld === SkinnedMesh.prototype.updateMatrixWorld) return Upkeep.Skin;
  // Its inverse is the renderer's affair, and a camera may carry whole scenes.
  if (updateMatrixWorld === Camera.prototype.updateMatrixWorld) return Upkeep.Plain;
  return Upkeep.Own;
}
