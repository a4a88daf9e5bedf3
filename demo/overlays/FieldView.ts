import type { CubeCollider } from 'three-cube-collider';
import { UnfoldedField } from 'three-cube-collider/helpers';
import type { ColliderView } from '../rendering.js';

/** The newest field unfolded, on a canvas over the picture: as sharp as the screen, however coarse the picture is. */
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

  get size(): number {
    return this.#unfolded.size;
  }

  set size(size: number) {
    this.#unfolded.size = size;
    this.#canvas.style.width = `${size}px`;
  }

  show(collider: CubeCollider): void {
    this.#unfolded.collider = collider;
  }

  render(): void {
    this.#unfolded.update();
  }
}
