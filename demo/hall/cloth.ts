import { type BufferGeometry, MathUtils, PlaneGeometry } from 'three';

/** A level grid in the XZ plane, seen from above. @param cell edge of its squares, metres */
export function cloth(width: number, depth: number, cell: number): PlaneGeometry {
  const plane = new PlaneGeometry(width, depth, Math.round(width / cell), Math.round(depth / cell));
  return plane.rotateX(-Math.PI / 2);
}

/** 1 in the middle of a strip from -half to half, 0 at its ends, smoothly down over `hem` metres. */
export function hemmed(x: number, half: number, hem: number): number {
  return MathUtils.smoothstep(half - Math.abs(x), 0, hem);
}

/** Lifts every vertex of a grid to the height over its place. */
export function lift(geometry: BufferGeometry, height: (x: number, z: number) => number): void {
  const { position } = geometry.attributes;
  for (let i = 0; i < position!.count; i++) {
    position!.setY(i, height(position!.getX(i), position!.getZ(i)));
  }
  geometry.computeVertexNormals();
}
