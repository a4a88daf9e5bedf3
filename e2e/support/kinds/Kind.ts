import {
  type BufferGeometry,
  DoubleSide,
  MeshStandardMaterial,
  type Object3D,
  TorusKnotGeometry,
  type WebGLRenderer,
} from 'three';
import type { Shown } from '../drawnTriangles.js';

/** One kind of object, somewhere near its own origin and about 0.5 m in size. */
export interface Kind {
  readonly object: Object3D;
  /** What it shows now. */
  shown(): readonly Shown[];
  /** Makes it show something else, by the means of its kind. */
  change(): void;
}

/** @param glb a model, for kinds that are loaded */
export type MakeKind = (
  renderer: WebGLRenderer,
  glb: Uint8Array<ArrayBuffer> | null,
) => Kind | Promise<Kind>;

export const plain = new MeshStandardMaterial({ side: DoubleSide });

/** Something with no symmetry to hide behind: 480 triangles, indexed, 16 bits. */
export function lump(): BufferGeometry {
  return new TorusKnotGeometry(0.24, 0.09, 30, 8, 2, 3);
}

/** Writes each of a geometry's places anew. */
export function reshape(
  geometry: BufferGeometry,
  shape: (x: number, y: number, z: number) => [number, number, number],
): void {
  const position = geometry.attributes.position!;
  for (let i = 0; i < position.count; i++) {
    position.setXYZ(i, ...shape(position.getX(i), position.getY(i), position.getZ(i)));
  }
}
