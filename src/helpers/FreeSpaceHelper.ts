import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
} from 'three';
import type { SurfaceField } from '../field/SurfaceField.js';
import { HELPER_COLORS } from './colors.js';
import { cubeQuads, freeBorder, type FreeBorder } from './freeBorder.js';
import { makeGhost } from './makeGhost.js';
import type { ViewableField } from './SurfelsHelper.js';

/**
 * Shows how far the newest field has seen: from its centre all is free up to the surfaces, and up to this blue net, which
 * hangs at the end of the reach and where something hides what is behind it. A character does not go beyond before
 * another field has looked there.
 *
 * ```js
 * const helper = new FreeSpaceHelper( collider );
 * scene.add( helper );
 *
 * helper.update(); // each frame, after character.update( … )
 * ```
 *
 * Add it to the scene itself: it is placed in world space. In the paper's mode there is no field, and nothing to show.
 */
export class FreeSpaceHelper extends Group {
  override readonly type = 'FreeSpaceHelper';

  readonly #film = new BufferGeometry();
  readonly #net = new BufferGeometry();
  readonly #filmMaterial = new MeshBasicMaterial({
    color: HELPER_COLORS.free,
    side: DoubleSide,
    transparent: true,
    opacity: 0.16,
    depthWrite: false,
    fog: false,
    toneMapped: false,
  });
  readonly #netMaterial = new LineBasicMaterial({
    color: HELPER_COLORS.free,
    transparent: true,
    opacity: 0.36,
    depthWrite: false,
    fog: false,
    toneMapped: false,
  });
  readonly #shown = new Group();
  #border: FreeBorder | null = null;
  #count = 0;
  /** Which field is shown. */
  #time = NaN;
  #serial = -1;

  /** @param collider whose field to show; may be exchanged at any time */
  constructor(public collider: ViewableField) {
    super();
    this.#shown.add(
      makeGhost(new Mesh(this.#film, this.#filmMaterial)),
      makeGhost(new LineSegments(this.#net, this.#netMaterial)),
    );
    this.#shown.visible = false;
    this.add(this.#shown);
    makeGhost(this);
  }

  /** Shows the newest field; call it once a frame. Costs next to nothing but for a new field, or while not `visible`. */
  update(): void {
    if (!this.visible) return;
    const { field } = this.collider;
    this.#shown.visible = field !== null;
    if (field === null || (field.serial === this.#serial && field.time === this.#time)) return;
    this.#serial = field.serial;
    this.#time = field.time;
    if (this.#count !== field.count) this.#make(field);
    this.#fill(field, this.#border!);
  }

  /** Frees what it has on the GPU, and takes it out of the scene. */
  override dispose(): void {
    this.removeFromParent();
    this.#film.dispose();
    this.#net.dispose();
    this.#filmMaterial.dispose();
    this.#netMaterial.dispose();
  }

  #make({ count, resolution }: SurfaceField): void {
    // Attributes of another size are new to the GPU.
    this.#film.dispose();
    this.#net.dispose();
    const quads = cubeQuads(resolution).length / 4;
    const triangles = new Uint32Array(6 * quads);
    const lines = new Uint32Array(4 * quads);
    this.#border = { triangles, lines, triangleEnd: 0, lineEnd: 0 };
    const position = new BufferAttribute(new Float32Array(3 * count), 3);
    this.#film.setAttribute('position', position).setIndex(new BufferAttribute(triangles, 1));
    this.#net.setAttribute('position', position).setIndex(new BufferAttribute(lines, 1));
    this.#count = count;
  }

  #fill(field: SurfaceField, border: FreeBorder): void {
    this.position.copy(field.center);
    const position = this.#film.getAttribute('position') as BufferAttribute;
    const { direction, distance, far } = field;
    for (let i = 0, k = 0; i < field.count; i++) {
      const d = Math.min(distance[i]!, far);
      for (const end = k + 3; k < end; k++) position.array[k] = d * direction[k]!;
    }
    freeBorder(field, border);
    position.needsUpdate = true;
    this.#film.index!.needsUpdate = true;
    this.#net.index!.needsUpdate = true;
    this.#film.setDrawRange(0, border.triangleEnd);
    this.#net.setDrawRange(0, border.lineEnd);
  }
}
