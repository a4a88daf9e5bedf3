import {
  Bone,
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

/** A unit cube on a skeleton of one bone. */
export function skinned(): SkinnedMesh {
  const geometry = new BoxGeometry();
  const first = Float32Array.from({ length: 4 * 24 }, (_, i) => (i % 4 === 0 ? 1 : 0));
  geometry.setAttribute('skinIndex', new BufferAttribute(new Uint8Array(4 * 24), 4));
  geometry.setAttribute('skinWeight', new BufferAttribute(first, 4));
  const mesh = new SkinnedMesh(geometry, new MeshBasicMaterial());
  const bone = new Bone();
  mesh.add(bone);
  mesh.bind(new Skeleton([bone]));
  return mesh;
}
