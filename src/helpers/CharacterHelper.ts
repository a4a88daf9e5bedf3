import { Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import type { CharacterController } from '../character/CharacterController.js';
import { capsuleHull, capsuleLines } from './capsuleShape.js';
import { HELPER_COLORS } from './colors.js';
import { makeGhost } from './makeGhost.js';

/** What the helper reads of a character. */
export type ViewableBody = Pick<
  CharacterController,
  'body' | 'position' | 'up' | 'skin' | 'ready' | 'grounded' | 'squeezed'
>;

const Y = /* @__PURE__ */ new Vector3(0, 1, 0);

/**
 * Shows a character's body: the capsule that collides, lower while it crouches, and around it, fainter, the gap it keeps
 * to everything (`skin`). Its colour tells whether it stands, is in the air, or is held; see `HELPER_COLORS`.
 *
 * ```js
 * const helper = new CharacterHelper( character );
 * scene.add( helper );
 *
 * helper.update(); // each frame, after character.update( … )
 * ```
 *
 * Add it to the scene itself: it is placed in world space.
 */
export class CharacterHelper extends Group {
  override readonly type = 'CharacterHelper';

  readonly #lines = capsuleLines();
  readonly #gap = capsuleLines();
  readonly #hull = capsuleHull();
  /** What is seen, what something hides, the gap, and the fill. */
  readonly #materials = [
    new LineBasicMaterial(),
    new LineBasicMaterial({ transparent: true, opacity: 0.3, depthTest: false, depthWrite: false }),
    new LineBasicMaterial({ transparent: true, opacity: 0.35, depthWrite: false }),
    new MeshBasicMaterial({ transparent: true, opacity: 0.12, depthWrite: false }),
  ] as const;
  #color = -1;
  #radius = 0;
  #height = 0;
  #skin = 0;

  /** @param character whose body to show; may be exchanged at any time */
  constructor(public character: ViewableBody) {
    super();
    const [seen, hidden, gap, fill] = this.#materials;
    for (const material of this.#materials) {
      material.fog = false;
      material.toneMapped = false;
    }
    this.add(
      makeGhost(new LineSegments(this.#lines.geometry, seen)),
      makeGhost(new LineSegments(this.#lines.geometry, hidden)),
      makeGhost(new LineSegments(this.#gap.geometry, gap)),
      makeGhost(new Mesh(this.#hull.geometry, fill)),
    );
    makeGhost(this);
  }

  /** Follows the body; call it once a frame. Does nothing while not `visible`. */
  update(): void {
    if (!this.visible) return;
    const { body, position, up, skin } = this.character;
    this.position.copy(position);
    this.quaternion.setFromUnitVectors(Y, up as Vector3);
    const { radius, height } = body;
    if (radius !== this.#radius || height !== this.#height || skin !== this.#skin) {
      this.#radius = radius;
      this.#height = height;
      this.#skin = skin;
      this.#lines.fit(radius, 0, height);
      this.#hull.fit(radius, 0, height);
      this.#gap.fit(radius + skin, -skin, height + skin);
    }
    this.#paint(this.#state());
  }

  /** Frees what it has on the GPU, and takes it out of the scene. */
  override dispose(): void {
    this.removeFromParent();
    for (const { geometry } of [this.#lines, this.#gap, this.#hull]) geometry.dispose();
    for (const material of this.#materials) material.dispose();
  }

  #state(): number {
    const { ready, grounded, squeezed } = this.character;
    if (!ready || squeezed) return HELPER_COLORS.held;
    return grounded ? HELPER_COLORS.grounded : HELPER_COLORS.airborne;
  }

  #paint(color: number): void {
    if (color === this.#color) return;
    this.#color = color;
    for (const material of this.#materials) material.color.setHex(color);
  }
}
