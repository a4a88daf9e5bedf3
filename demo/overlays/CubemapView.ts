import type { WebGLRenderer } from 'three';
import type { CubeCollider } from 'three-cube-collider';
import { CubeColliderHelper } from 'three-cube-collider/helpers';
import type { ColliderView } from '../rendering.js';
import { hasMouse } from '../page.js';
import { FieldView } from './FieldView.js';

/** What a collider sees: its field, or the atlas itself in the paper's mode, of which six numbers come back alone. */
export class CubemapView implements ColliderView {
  visible = true;
  readonly #atlas: CubeColliderHelper;
  readonly #field: FieldView;
  #collider: CubeCollider;

  constructor(collider: CubeCollider) {
    this.#collider = collider;
    this.#atlas = new CubeColliderHelper(collider, { margin: 14 });
    this.#field = new FieldView(collider);
  }

  get size(): number {
    return this.#field.size;
  }

  set size(size: number) {
    this.#field.size = this.#atlas.size = size;
  }

  show(collider: CubeCollider): void {
    this.#collider = this.#atlas.collider = collider;
    this.#field.show(collider);
  }

  render(renderer: WebGLRenderer): void {
    // Where thumbs walk, the atlas' corner is theirs: the field's canvas then shows the paper's six maxima.
    const axis = this.#collider.output === 'axis' && hasMouse();
    const field = this.visible && !axis;
    if (this.#field.visible !== field) this.#field.visible = field;
    this.#field.render();
    if (this.visible && axis) this.#atlas.render(renderer);
  }
}
