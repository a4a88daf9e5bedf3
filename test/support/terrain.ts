import { BufferAttribute, BufferGeometry } from 'three';

/**
 * A hilly square of `cells`² × 2 triangles, `size` metres wide, around the origin.
 *
 * @param shuffle a source of random numbers to put the triangles out of order with
 */
export function terrain(cells: number, size: number, shuffle?: () => number): BufferGeometry {
  const edge = cells + 1;
  const position = new Float32Array(3 * edge * edge);
  for (let i = 0, at = 0; i < edge; i++) {
    for (let j = 0; j < edge; j++) {
      const x = (j / cells - 0.5) * size;
      const z = (i / cells - 0.5) * size;
      position[at++] = x;
      position[at++] = Math.sin(0.5 * x) * Math.cos(0.4 * z) + 0.1 * Math.sin(5 * x);
      position[at++] = z;
    }
  }
  const index = new Uint32Array(6 * cells * cells);
  for (let i = 0, at = 0; i < cells; i++) {
    for (let j = 0; j < cells; j++) {
      const a = i * edge + j;
      index.set([a, a + edge, a + 1, a + 1, a + edge, a + edge + 1], at);
      at += 6;
    }
  }
  if (shuffle) shuffleTriangles(index, shuffle);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  return geometry.setIndex(new BufferAttribute(index, 1));
}

function shuffleTriangles(index: Uint32Array, random: () => number): void {
  for (let i = index.length / 3 - 1; i > 0; i--) {
    const j = Math.floor(random() * (i + 1));
    for (let k = 0; k < 3; k++) {
      const swapped = index[3 * i + k]!;
      index[3 * i + k] = index[3 * j + k]!;
      index[3 * j + k] = swapped;
    }
  }
}
