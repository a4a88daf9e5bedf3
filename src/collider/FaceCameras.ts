import { ArrayCamera, Matrix4, PerspectiveCamera, Vector3, Vector4 } from 'three';
import { tileOf } from '../cube/atlas.js';
import { faceRotation } from '../cube/faceMatrices.js';

/**
 * The six cameras of a cubemap as one `ArrayCamera`, each with its tile of the atlas for a viewport: one `render()`
 * draws all faces. Camera `i` shows layer `i` alone, so a mesh is drawn only in the faces it touches.
 *
 * The projections are three's own (a renderer may patch them for a reversed depth buffer) and equal (1)-(8) together
 * with the exact rotations given here; a test compares them.
 */
export class FaceCameras extends ArrayCamera {
  readonly #rotation: Matrix4[] = [];

  /** @param near metres. @param far metres. */
  constructor(resolution: number, near: number, far: number) {
    const faces: PerspectiveCamera[] = [];
    for (let face = 0; face < 6; face++) {
      const camera = new PerspectiveCamera(90, 1, near, far);
      const { column, row } = tileOf(face);
      camera.viewport = new Vector4(column * resolution, row * resolution, resolution, resolution);
      camera.matrixAutoUpdate = false;
      camera.matrixWorldAutoUpdate = false;
      camera.layers.set(face);
      faces.push(camera);
    }
    super(faces);
    for (let face = 0; face < 6; face++) this.#rotation.push(faceRotation(face, new Matrix4()));
    this.matrixAutoUpdate = false;
    this.matrixWorldAutoUpdate = false;
    this.layers.enableAll();
    this.moveTo(new Vector3());
  }

  /** Lets all six see as far as `far`, metres. */
  reach(far: number): void {
    for (const camera of this.cameras) {
      if (camera.far === far) continue;
      camera.far = far;
      camera.updateProjectionMatrix();
    }
  }

  /** Puts all six at `center`, world space. */
  moveTo(center: Vector3): void {
    for (let face = 0; face < 6; face++) {
      const camera = this.cameras[face]!;
      camera.matrixWorld.copy(this.#rotation[face]!).setPosition(center);
      // Written out: inverting by cofactors would round the centre's coordinates.
      camera.matrixWorldInverse.copy(this.#rotation[face]!).transpose();
      const e = camera.matrixWorldInverse.elements;
      for (let i = 0; i < 3; i++) {
        e[12 + i] = -(e[i]! * center.x + e[4 + i]! * center.y + e[8 + i]! * center.z);
      }
    }
    this.matrixWorld.makeTranslation(center);
    this.matrixWorldInverse.makeTranslation(-center.x, -center.y, -center.z);
  }
}
