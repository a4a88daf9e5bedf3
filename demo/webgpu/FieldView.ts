import type { CubeCollider } from 'three-cube-collider';
import { UnfoldedField } from 'three-cube-collider/helpers';
import type { ColliderView } from '../rendering.js';

/** The newest field unfolded, on a canvas over the picture: `CubeColliderHelper` draws with `WebGLRenderer` alone. */
export class FieldView implements ColliderView {
  readonly #canvas = document.createElement('canvas');
  readonly #unfolded: UnfoldedField;

  constructor(collider: CubeCollider) {
    this.#canvas.className = 'field-view';
    this.#canvas.setAttribute('role', 'img');
    this.#canvas.setAttribute('aria-label', 'What the collider sees');
    document.body.append(this.#canvas);
    this.#unfolded = new UnfoldedField(collider, this.#canvas);
  }

  get visible(): boolean {
    return this.#unfolded.visible;
  }

  set visible(visible: boolean) {
    this.#unfolded.visible = visible;
    this.#canvas.hidden = !visible;
  }

  show(collider: CubeCollider): void {
    this.#unfolded.collider = collider;
  }

  render(): void {
    this.#unfolded.update();
  }
}
