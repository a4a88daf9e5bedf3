import { CircleGeometry, Color, Group, InstancedMesh, MeshBasicMaterial, Vector3 } from 'three';
import type { CubeCollider } from '../collider/CubeCollider.js';
import { DEFAULTS } from '../defaults.js';
import type { SurfaceField } from '../field/SurfaceField.js';
import { facingOf, HELPER_COLORS } from './colors.js';
import { makeGhost } from './makeGhost.js';
import { texelDisc } from './texelDisc.js';

/** What the helper reads of a collider. */
export type ViewableField = Pick<CubeCollider, 'field'>;

/** Options of a `SurfelsHelper`. */
export interface SurfelsHelperOptions {
  /** Which way is up: unit vector, world axes. @default +Y */
  up?: Vector3;
  /** Steepest slope that is shown as floor, radians. @default 50°, a character's */
  slopeLimit?: number;
}

type Discs = InstancedMesh<CircleGeometry, MeshBasicMaterial>;

const COLORS = {
  floor: /* @__PURE__ */ new Color(HELPER_COLORS.floor),
  wall: /* @__PURE__ */ new Color(HELPER_COLORS.wall),
  ceiling: /* @__PURE__ */ new Color(HELPER_COLORS.ceiling),
  back: /* @__PURE__ */ new Color(HELPER_COLORS.back),
};

/**
 * Shows what came back from the GPU, and is all that a character collides with: for each texel of the newest field a disc
 * on the surface it saw, turned as that and as large as the texel there. Blue is floor, orange wall, pink ceiling, grey a
 * surface seen from behind (`HELPER_COLORS`).
 *
 * ```js
 * const helper = new SurfelsHelper( collider );
 * scene.add( helper );
 *
 * helper.update(); // each frame, after character.update( … )
 * ```
 *
 * They lie where things were when the field was drawn. Add it to the scene itself: it is placed in world space. In the
 * paper's mode there is no field, and nothing to show.
 */
export class SurfelsHelper extends Group {
  override readonly type = 'SurfelsHelper';
  /** Which way is up: unit vector, world axes. */
  readonly facingUp: Vector3;
  /** Steepest slope that is shown as floor, radians; a change shows with the next field. */
  slopeLimit: number;

  readonly #geometry = new CircleGeometry(1, 10);
  readonly #material = new MeshBasicMaterial({
    transparent: true,
    opacity: 0.72,
    depthWrite: false,
    fog: false,
    toneMapped: false,
    polygonOffset: true,
    polygonOffsetFactor: -2,
    polygonOffsetUnits: -8,
  });
  #discs: Discs | null = null;
  /** Which field the discs show. */
  #time = NaN;
  #serial = -1;

  /** @param collider whose field to show; may be exchanged at any time */
  constructor(
    public collider: ViewableField,
    {
      up = new Vector3(0, 1, 0),
      slopeLimit = DEFAULTS.character.slopeLimit,
    }: SurfelsHelperOptions = {},
  ) {
    super();
    this.facingUp = up.clone();
    this.slopeLimit = slopeLimit;
    makeGhost(this);
  }

  /** Shows the newest field; call it once a frame. Costs next to nothing but for a new field, or while not `visible`. */
  update(): void {
    if (!this.visible) return;
    const { field } = this.collider;
    if (this.#discs !== null) this.#discs.visible = field !== null;
    if (field === null || (field.serial === this.#serial && field.time === this.#time)) return;
    this.#serial = field.serial;
    this.#time = field.time;
    if (this.#discs?.count !== field.count) this.#make(field.count);
    this.#fill(this.#discs!, field);
  }

  /** Frees what it has on the GPU, and takes it out of the scene. */
  override dispose(): void {
    this.removeFromParent();
    this.#discs?.dispose();
    this.#geometry.dispose();
    this.#material.dispose();
  }

  #make(count: number): void {
    this.#discs?.removeFromParent();
    this.#discs?.dispose();
    this.#discs = makeGhost(new InstancedMesh(this.#geometry, this.#material, count));
    this.#discs.setColorAt(0, COLORS.floor);
    this.add(this.#discs);
  }

  #fill({ instanceMatrix, instanceColor }: Discs, field: SurfaceField): void {
    this.position.copy(field.center);
    const { array } = instanceMatrix;
    const { normal, front } = field;
    const { x, y, z } = this.facingUp;
    const flattest = Math.cos(this.slopeLimit);
    for (let texel = 0; texel < field.count; texel++) {
      texelDisc(field, texel, array, 16 * texel);
      const k = 3 * texel;
      const rise = normal[k]! * x + normal[k + 1]! * y + normal[k + 2]! * z;
      const facing = front[texel] === 1 ? facingOf(rise, flattest) : 'back';
      COLORS[facing].toArray(instanceColor!.array, k);
    }
    instanceMatrix.needsUpdate = true;
    instanceColor!.needsUpdate = true;
  }
}
