import { Matrix4, type Object3D } from 'three';
import type { SurfaceField } from '../field/SurfaceField.js';
import { isRigid } from './isRigid.js';
import type { ObjectProxy } from './objectProxy.js';

/**
 * What one draw shows, in the order of its numbers, with the world matrices of that moment. Draws overlap their reads,
 * so each read on its way has a table of its own, until the field takes it over.
 */
export class DrawnObjects {
  #count = 0;
  readonly #objects: Object3D[] = [];
  readonly #matrices: Matrix4[] = [];
  readonly #rigid: boolean[] = [];

  /**
   * Notes what has been drawn. Allocates only where there were never as many.
   *
   * @returns how many are not rigid
   */
  take(proxies: readonly ObjectProxy[]): number {
    const count = proxies.length;
    let deforming = 0;
    for (let i = 0; i < count; i++) {
      const { source, solidity } = proxies[i]!;
      this.#objects[i] = source;
      (this.#matrices[i] ??= new Matrix4()).copy(source.matrixWorld);
      const rigid = (this.#rigid[i] = isRigid(source, solidity));
      if (!rigid) deforming++;
    }
    this.#objects.length = count;
    this.#count = count;
    return deforming;
  }

  /** Hands the table over to the field of its draw, and is empty then. */
  handTo(field: SurfaceField): void {
    const objects = this.#objects;
    const count = this.#count;
    // Draw after draw shows the same objects: their list then stays as it is.
    let same = field.objects.length === count;
    for (let i = 0; same && i < count; i++) same = field.objects[i] === objects[i];
    if (!same) {
      field.clearObjects();
      for (let i = 0; i < count; i++) field.addObject(objects[i]!);
    }
    for (let i = 0; i < count; i++) {
      field.matrices[i]!.copy(this.#matrices[i]!);
      field.rigid[i] = this.#rigid[i]!;
    }
    this.clear();
  }

  /** Lets go of the user's objects. */
  clear(): void {
    this.#objects.fill(undefined as never);
    this.#count = 0;
  }
}
