import {
  BatchedMesh,
  BoxGeometry,
  type BufferGeometry,
  ConeGeometry,
  Euler,
  InstancedMesh,
  type Material,
  Matrix4,
  Mesh,
  PerspectiveCamera,
  Quaternion,
  Scene,
  SphereGeometry,
  Vector3,
} from 'three';
import type { Part } from '../drawnTriangles.js';
import { type Kind, type MakeKind, plain } from './Kind.js';
import { withTargets } from './deformedKinds.js';

/** Places in a ring, each turned and scaled otherwise, the third mirrored. */
function placeOf(i: number, of: number): Matrix4 {
  const angle = (2 * Math.PI * i) / of;
  return new Matrix4().compose(
    new Vector3(0.35 * Math.cos(angle), 0.05 * i, 0.35 * Math.sin(angle)),
    new Quaternion().setFromEuler(new Euler(i, 2 * i, 0.5 * i)),
    new Vector3(1 + 0.1 * i, 1, i === 2 ? -0.8 : 1),
  );
}

function instances(geometry: BufferGeometry, weights: number[][] | null): Kind {
  const count = 6;
  const mesh = new InstancedMesh(geometry, plain, count);
  const places = Array.from({ length: count }, (_, i) => placeOf(i, count));
  const put = () => {
    places.forEach((place, i) => mesh.setMatrixAt(i, place));
    mesh.instanceMatrix.needsUpdate = true;
    if (weights === null) return;
    const model = new Mesh(geometry);
    weights.forEach((weight, i) => {
      model.morphTargetInfluences = weight;
      mesh.setMorphAt(i, model);
    });
    mesh.morphTexture!.needsUpdate = true;
  };
  put();
  return {
    object: mesh,
    shown: () => {
      const parts = places.map((matrix, instance): Part => {
        const part = { instance, matrix };
        return weights ? { ...part, weights: weights[instance]! } : part;
      });
      return [{ mesh, parts: parts.slice(0, mesh.count) }];
    },
    change: () => {
      mesh.count = 5;
      // Out of the bounds that three found when it drew them first.
      places.forEach((place, i) => place.copy(placeOf(i + 2, 5)));
      places[1]!.setPosition(0.9, 0.3, 0.2);
      weights?.reverse();
      put();
    },
  };
}

/** Three geometries, seven instances, one of them deleted and one hidden. */
class Batch implements Kind {
  readonly object: BatchedMesh;
  readonly #geometries: BufferGeometry[];
  readonly #ids: number[];
  readonly #parts = new Map<number, Part>();

  constructor(indexed: boolean, material: Material = plain) {
    const made = [
      new BoxGeometry(0.3, 0.2, 0.2),
      new SphereGeometry(0.15, 10, 8),
      new ConeGeometry(0.15, 0.3, 9),
    ];
    this.#geometries = indexed ? made : made.map((geometry) => geometry.toNonIndexed());
    this.object = new BatchedMesh(9, 2000, 4000, material);
    this.#ids = this.#geometries.map((geometry) => this.object.addGeometry(geometry));
    for (let i = 0; i < 7; i++) this.#add(i % 3, placeOf(i, 7));
    this.#remove(1);
    this.object.setVisibleAt(4, false);
    this.#parts.delete(4);
  }

  shown() {
    return [{ mesh: this.object, parts: [...this.#parts.values()] }];
  }

  change(): void {
    this.object.setVisibleAt(0, false);
    this.#parts.delete(0);
    this.object.setVisibleAt(4, true);
    this.#put(4, 1, new Matrix4().makeTranslation(0.8, 0.4, -0.2));
    // The room that the deleted one left.
    if (!this.#parts.has(1)) this.#add(2, new Matrix4().makeTranslation(0, -0.3, 0.1));
    this.object.setGeometryIdAt(5, this.#ids[0]!);
    this.#put(5, 0, placeOf(5, 7));
  }

  #add(which: number, place: Matrix4): void {
    this.#put(this.object.addInstance(this.#ids[which]!), which, place);
  }

  #remove(instance: number): void {
    this.object.deleteInstance(instance);
    this.#parts.delete(instance);
  }

  #put(instance: number, which: number, matrix: Matrix4): void {
    this.object.setMatrixAt(instance, matrix);
    this.#parts.set(instance, { instance, matrix, geometry: this.#geometries[which]! });
  }
}

/** One object, many things. */
export const manyKinds: Record<string, MakeKind> = {
  InstancedMesh: () => instances(new SphereGeometry(0.15, 10, 8), null),

  'InstancedMesh with morph targets': () =>
    instances(
      withTargets(new BoxGeometry(0.25, 0.2, 0.2, 2, 2, 2), true),
      Array.from({ length: 6 }, (_, i) => [0.2 * i, 1 - 0.2 * i]),
    ),

  'BatchedMesh, never rendered': () => new Batch(true),

  'BatchedMesh, the user’s camera elsewhere': (renderer) => {
    const batch = new Batch(false);
    const camera = new PerspectiveCamera();
    camera.position.z = -9;
    // Looking away, and so culling all of it.
    renderer.render(new Scene().add(batch.object), camera);
    return batch;
  },
};
