import { BoxGeometry, type BufferGeometry, Mesh, MeshStandardMaterial, type Object3D } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';

/** Metres of the level's textures' pictures. */
export const TEXTURE_SIZE = 2;

/** A material of the level, by name: one's own to change. */
export type Materials = (name: string) => MeshStandardMaterial;

/** The level's materials by name, without the colours that it paints on its vertices. */
export function materialsOf(level: Object3D): Materials {
  const known = new Map<string, MeshStandardMaterial>();
  level.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const { material } = object as Mesh;
    if (material instanceof MeshStandardMaterial) known.set(material.name, material);
  });
  return (name) => {
    const made = known.get(name)?.clone() ?? new MeshStandardMaterial();
    made.vertexColors = false;
    made.aoMap = null;
    return made;
  };
}

/** One mesh of parts with a material each, that throws shadows and takes them. */
export function assemble(name: string, parts: [BufferGeometry, MeshStandardMaterial][]): Mesh {
  const geometry = mergeGeometries(
    parts.map(([part]) => part),
    true,
  );
  const mesh = new Mesh(
    geometry,
    parts.map(([, material]) => material),
  );
  mesh.name = name;
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

export const merge = (...parts: BufferGeometry[]) => mergeGeometries(parts);

/** A box whose top is at y = 0, with the middle at (x, z) and the level's textures' scale. */
export function slab(width: number, height: number, depth: number, x: number, z = 0): BoxGeometry {
  const box = new BoxGeometry(width, height, depth);
  const { uv } = box.attributes;
  const sizes = [
    [depth, height],
    [depth, height],
    [width, depth],
    [width, depth],
    [width, height],
    [width, height],
  ];
  for (let i = 0; i < uv!.count; i++) {
    const [u, v] = sizes[Math.floor(i / 4)]!;
    uv!.setXY(i, (uv!.getX(i) * u!) / TEXTURE_SIZE, (uv!.getY(i) * v!) / TEXTURE_SIZE);
  }
  box.translate(x, -height / 2, z);
  return box;
}

/** Repeats a texture that many times along each of its edges. */
export function stretch(geometry: BufferGeometry, u: number, v: number): void {
  const { uv } = geometry.attributes;
  for (let i = 0; i < uv!.count; i++) uv!.setXY(i, uv!.getX(i) * u, uv!.getY(i) * v);
}
