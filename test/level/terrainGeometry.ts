import { PlaneGeometry } from 'three';

/** Hills, 60 m by 60 m. */
export function terrainGeometry(seed: number): PlaneGeometry {
  const geometry = new PlaneGeometry(60, 60, 80, 80).rotateX(-Math.PI / 2);
  const { position } = geometry.attributes;
  for (let i = 0; i < position!.count; i++) {
    const [x, z] = [position!.getX(i), position!.getZ(i)];
    position!.setY(
      i,
      5 * Math.sin(x / 7 + seed) * Math.cos(z / 6 + 2 * seed) + 2 * Math.sin((x + z) / 3),
    );
  }
  return geometry;
}
