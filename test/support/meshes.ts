import {
  BoxGeometry,
  BufferAttribute,
  type Material,
  Mesh,
  MeshBasicMaterial,
  Skeleton,
  SkinnedMesh,
} from 'three';

/** A unit cube around its origin, of a plain material unless others are given. */
export function box(...material: Material[]): Mesh<BoxGeometry, Material | Material[]> {
  const worn = material.length > 1 ? material : (material[0] ?? new MeshBasicMaterial());
  return new Mesh<BoxGeometry, Material | Material[]>(new BoxGeometry(), worn);
}

/** A unit cube with weights for a skeleton without bones. */
export function skinned(): SkinnedMesh {
  const geometry = new BoxGeometry();
  const bones = new BufferAttribute(new Uint8Array(4 * 24), 4);
  geometry.setAttribute('skinIndex', bones);
  geometry.setAttribute('skinWeight', bones);
  const mesh = new SkinnedMesh(geometry, new MeshBasicMaterial());
  mesh.bind(new Skeleton([]));
  return mesh;
}
