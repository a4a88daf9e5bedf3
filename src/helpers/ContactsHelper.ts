import {
  BackSide,
  Color,
  Group,
  InstancedMesh,
  LatheGeometry,
  MeshBasicMaterial,
  Vector2,
} from 'three';
import type { CharacterController } from '../character/CharacterController.js';
import { facingOf, HELPER_COLORS } from './colors.js';
import { makeGhost } from './makeGhost.js';
import { placeAlong } from './placeAlong.js';

/** What the helper reads of a character. */
export type ViewableContacts = Pick<CharacterController, 'body' | 'contacts' | 'up' | 'slopeLimit'>;

/** Options of a `ContactsHelper`. */
export interface ContactsHelperOptions {
  /** Length of the arrows, metres. @default 0.5 */
  length?: number;
}

/** Most arrows at a time: as many contacts as a step looks at. */
const MOST = 48;
/** Width of the dark rim, metres, for arrows on any colour. */
const RIM = 0.008;
/** Of an arrow 1 long: foot, shaft, head; radius and height. */
const FOOT = [0.12, 0.03] as const;
const SHAFT = [0.028, 0.68] as const;
const HEAD = [0.11, 1] as const;
const COLORS = {
  floor: /* @__PURE__ */ new Color(HELPER_COLORS.floor),
  wall: /* @__PURE__ */ new Color(HELPER_COLORS.wall),
  ceiling: /* @__PURE__ */ new Color(HELPER_COLORS.ceiling),
};

/**
 * Shows what a character touches: for each of its contacts an arrow from the place on the surface along the normal, in
 * the colour of floor, wall or ceiling (`HELPER_COLORS`). It shines through everything, the avatar too.
 *
 * ```js
 * const helper = new ContactsHelper( character );
 * scene.add( helper );
 *
 * helper.update(); // each frame, after character.update( … )
 * ```
 *
 * Add it to the scene itself: it is placed in world space. With `AxisResponse` there are no contacts, and no arrows.
 */
export class ContactsHelper extends Group {
  override readonly type = 'ContactsHelper';
  /** Length of the arrows, metres. */
  length: number;

  readonly #arrows: InstancedMesh<LatheGeometry, MeshBasicMaterial>;
  readonly #rims: InstancedMesh<LatheGeometry, MeshBasicMaterial>;

  /** @param character whose contacts to show; may be exchanged at any time */
  constructor(
    public character: ViewableContacts,
    { length = 0.5 }: ContactsHelperOptions = {},
  ) {
    super();
    this.length = length;
    this.#rims = arrows(RIM / length, new MeshBasicMaterial({ color: 0x10161c, side: BackSide }));
    this.#rims.renderOrder = 1000;
    this.#arrows = arrows(0, new MeshBasicMaterial());
    this.#arrows.renderOrder = 1001;
    this.add(this.#rims, this.#arrows);
    makeGhost(this);
    for (let i = 0; i < MOST; i++) this.#arrows.setColorAt(i, COLORS.floor);
  }

  /** Shows the contacts of the last step; call it once a frame. Does nothing while not `visible`. */
  update(): void {
    if (!this.visible) return;
    const { contacts, body, up, slopeLimit } = this.character;
    this.position.copy(body.position);
    const matrices = this.#arrows.instanceMatrix.array;
    const flattest = Math.cos(slopeLimit);
    const shown = Math.min(MOST, contacts.length);
    for (let i = 0; i < shown; i++) {
      const { point, normal } = contacts[i]!;
      placeAlong(matrices, 16 * i, point, this.position, normal, this.length);
      this.#arrows.setColorAt(i, COLORS[facingOf(normal.dot(up), flattest)]);
    }
    // Those left over have no size.
    matrices.fill(0, 16 * shown);
    this.#rims.instanceMatrix.array.set(matrices);
    this.#rims.instanceMatrix.needsUpdate = true;
    this.#arrows.instanceMatrix.needsUpdate = true;
    this.#arrows.instanceColor!.needsUpdate = true;
    this.#rims.visible = this.#arrows.visible = shown > 0;
  }

  /** Frees what it has on the GPU, and takes it out of the scene. */
  override dispose(): void {
    this.removeFromParent();
    for (const mesh of [this.#rims, this.#arrows]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
      mesh.dispose();
    }
  }
}

/** Along Y, 1 long, and `rim` thicker all around. */
function arrows(
  rim: number,
  material: MeshBasicMaterial,
): InstancedMesh<LatheGeometry, MeshBasicMaterial> {
  // Where the cone's slope meets the rim, its tip is three times as far off as its side.
  const profile = [
    [0, -rim],
    [FOOT[0] + rim, -rim],
    [FOOT[0] + rim, FOOT[1] + rim],
    [SHAFT[0] + rim, FOOT[1] + rim],
    [SHAFT[0] + rim, SHAFT[1] - rim],
    [HEAD[0] + 2 * rim, SHAFT[1] - rim],
    [0, HEAD[1] + 3 * rim],
  ].map(([x, y]) => new Vector2(x, y));
  material.transparent = true;
  material.depthTest = material.depthWrite = material.fog = material.toneMapped = false;
  return makeGhost(new InstancedMesh(new LatheGeometry(profile, 16), material, MOST));
}
