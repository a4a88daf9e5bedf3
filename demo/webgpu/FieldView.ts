import type { CubeCollider } from 'three-cube-collider';
import type { ColliderView } from '../rendering.js';

/** Where each face lies in the cross, tiles from the left and from the top: +X, -X, +Y, -Y, +Z, -Z. */
const TILES = [
  [2, 1],
  [0, 1],
  [1, 0],
  [1, 2],
  [3, 1],
  [1, 1],
] as const;

/**
 * The newest field unfolded into a cross, bright where something is near. `CubeColliderHelper` draws the like on WebGL
 * without reading anything back.
 */
export class FieldView implements ColliderView {
  visible = true;
  readonly #canvas = document.createElement('canvas');
  #image: ImageData | null = null;
  #serial = -1;

  #collider: CubeCollider;

  constructor(collider: CubeCollider) {
    this.#collider = collider;
    this.#canvas.className = 'field-view';
    this.#canvas.setAttribute('role', 'img');
    this.#canvas.setAttribute('aria-label', 'What the collider sees');
    document.body.append(this.#canvas);
  }

  show(collider: CubeCollider): void {
    this.#collider = collider;
    this.#serial = -1;
  }

  render(): void {
    const { field } = this.#collider;
    this.#canvas.hidden = !this.visible;
    if (!this.visible || field === null || field.serial === this.#serial) return;
    this.#serial = field.serial;
    const { resolution: size, distance, normal, front, far } = field;
    const width = 4 * size;
    if (this.#canvas.width !== width) {
      this.#canvas.width = width;
      this.#canvas.height = 3 * size;
      this.#image = null;
    }
    const context = this.#canvas.getContext('2d')!;
    this.#image ??= context.createImageData(width, 3 * size);
    const { data } = this.#image;
    for (let texel = 0; texel < field.count; texel++) {
      const face = Math.floor(texel / (size * size));
      const row = Math.floor(texel / size) % size;
      const [column, line] = TILES[face]!;
      // Rows count upward.
      const y = line * size + size - 1 - row;
      const to = 4 * (y * width + column * size + (texel % size));
      const near = Math.max(0, 1 - distance[texel]! / far);
      const light = near === 0 ? 0.12 : 0.25 + 0.75 * near;
      const up = 0.5 + 0.5 * normal[3 * texel + 1]!;
      data[to] = 255 * light * (front[texel] === 0 ? 1 : 0.55 + 0.2 * up);
      data[to + 1] = 255 * light * (front[texel] === 0 ? 0.3 : 0.75 + 0.25 * up);
      data[to + 2] = 255 * light * (front[texel] === 0 ? 0.3 : 0.9 - 0.25 * up);
      data[to + 3] = 235;
    }
    context.putImageData(this.#image, 0, 0);
  }
}
