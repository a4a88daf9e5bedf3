import { ArrayCamera, Matrix4, PerspectiveCamera, Vector3, Vector4 } from 'three';
import { ATLAS_ROWS, tileOf } from '../cube/atlas.js';
import { faceRotation } from '../cube/faceMatrices.js';

/** As many cubemaps as one render can draw: their faces take a layer each, and layers have 32 bits. */
export const MOST_CUBEMAPS = 5;

/**
 * The six cameras of a cubemap as one `ArrayCamera`, each with its tile of the atlas for a viewport: one `render()`
 * draws all faces. Camera `i` shows layer `i` alone, so a mesh is drawn only in the faces it touches. Those of up to five
 * cubemaps one above the other are one `ArrayCamera` too: of cubemap `k`, camera `i` shows layer `6·k + i`.
 *
 * The projections are three's own (a renderer may patch them for a reversed depth buffer) and equal (1)-(8) together
 * with the exact rotations given here; a test compares them.
 */
export class FaceCameras extends ArrayCamera {
  readonly #rotation: Matrix4[] = [];
  readonly #resolution: number;

  /**
   * @param near metres
   * @param far metres
   * @param cubemaps how many, up to five; always that many cameras, as programs depend on it
   */
  constructor(resolution: number, near: number, far: number, cubemaps = 1) {
    const faces: PerspectiveCamera[] = [];
    for (let i = 0; i < 6 * cubemaps; i++) {
      const camera = new PerspectiveCamera(90, 1, near, far);
      camera.viewport = new Vector4(0, 0, resolution, resolution);
      camera.matrixAutoUpdate = false;
      camera.matrixWorldAutoUpdate = false;
      camera.layers.set(i);
      faces.push(camera);
    }
    super(faces);
    this.#resolution = resolution;
    for (let face = 0; face < 6; face++) this.#rotation.push(faceRotation(face, new Matrix4()));
    this.matrixAutoUpdate = false;
    this.matrixWorldAutoUpdate = false;
    this.layers.enableAll();
    this.drawInto(0);
    for (let i = 0; i < cubemaps; i++) this.#place(i, ORIGIN);
  }

  /** Whose tiles they draw into, from which cubemap of the atlas on. */
  drawInto(first: number): void {
    const resolution = this.#resolution;
    for (let i = 0; i < this.cameras.length; i++) {
      const { column, row } = tileOf(i % 6);
      const rows = ATLAS_ROWS * (first + Math.floor(i / 6)) + row;
      const { viewport } = this.cameras[i]!;
      viewport!.set(column * resolution, rows * resolution, resolution, resolution);
    }
  }

  /** Lets all see as far as `far`, metres. */
  reach(far: number): void {
    for (const camera of this.cameras) {
      if (camera.far === far) continue;
      camera.far = far;
      camera.updateProjectionMatrix();
    }
  }

  /** Puts each six at a centre, world space; those without one stay where they are. */
  moveTo(centers: readonly Vector3[]): void {
    for (let i = 0; i < centers.length; i++) this.#place(i, centers[i]!);
  }

  #place(cubemap: number, center: Vector3): void {
    for (let face = 0; face < 6; face++) {
      const camera = this.cameras[6 * cubemap + face]!;
      camera.matrixWorld.copy(this.#rotation[face]!).setPosition(center);
      // Written out: inverting by cofactors would round the centre's coordinates.
      camera.matrixWorldInverse.copy(this.#rotation[face]!).transpose();
      const e = camera.matrixWorldInverse.elements;
      for (let i = 0; i < 3; i++) {
        e[12 + i] = -(e[i]! * center.x + e[4 + i]! * center.y + e[8 + i]! * center.z);
      }
    }
    if (cubemap > 0) return;
    this.matrixWorld.makeTranslation(center);
    this.matrixWorldInverse.makeTranslation(-center.x, -center.y, -center.z);
  }
}

const ORIGIN = /* @__PURE__ */ new Vector3();
