import { Mesh, MeshBasicMaterial, PlaneGeometry } from 'three';

/** What the character stands on, 40 m wide, at height 0. */
export function floor(): Mesh {
  const geometry = new PlaneGeometry(40, 40).rotateX(-Math.PI / 2);
  return new Mesh(geometry, new MeshBasicMaterial());
}
