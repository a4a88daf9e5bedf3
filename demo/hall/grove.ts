import {
  Color,
  Float32BufferAttribute,
  InstancedMesh,
  LatheGeometry,
  MathUtils,
  Object3D,
  Vector2,
} from 'three';
import { merge, type Materials, stretch } from '../pieces.js';
import type { Exhibit } from './Exhibit.js';

const [COLUMNS, ROWS] = [5, 4];
/** Between two trees, metres, and how far off that they may stand. */
const SPACING = 1.9;
const STRAY = 0.22;

/** Profiles of a trunk and of a crown: radius and height, metres. */
const TRUNK = [
  [0.17, -0.1],
  [0.13, 0.7],
];
const CROWN = [
  [0.06, 0.42],
  [0.38, 0.52],
  [0.5, 1.0],
  [0.47, 1.7],
  [0.36, 2.6],
  [0.2, 3.5],
  [0, 4.3],
];

/** Cypresses to wind one's way between: one `InstancedMesh`. */
export function createGrove(material: Materials): Exhibit & { readonly object: InstancedMesh } {
  const trunk = turned(TRUNK, 8, new Color('#8a6f55'));
  const crown = turned(CROWN, 14, new Color('white'));
  stretch(crown, 4, 4);
  const leaves = material('leaf');
  leaves.vertexColors = true;
  const trees = new InstancedMesh(merge(trunk, crown), leaves, COLUMNS * ROWS);
  trees.name = 'grove';
  trees.castShadow = trees.receiveShadow = true;
  const random = MathUtils.seededRandom;
  random(11);
  const tree = new Object3D();
  const tint = new Color();
  for (let i = 0; i < trees.count; i++) {
    const [column, row] = [i % COLUMNS, Math.floor(i / COLUMNS)];
    // Every other row stands in the gaps of the one before.
    const x = (column - (COLUMNS - 1) / 2 + (row % 2 ? 0.25 : -0.25)) * SPACING;
    const z = (row - (ROWS - 1) / 2) * SPACING;
    const size = 0.8 + 0.3 * random();
    tree.position.set(x + STRAY * (2 * random() - 1), 0, z + STRAY * (2 * random() - 1));
    tree.rotation.y = 2 * Math.PI * random();
    tree.scale.set(0.9 + 0.15 * random(), size, 0.9 + 0.15 * random());
    tree.updateMatrix();
    trees.setMatrixAt(i, tree.matrix);
    trees.setColorAt(i, tint.setHSL(0.24 + 0.06 * random(), 0.25, 0.72 + 0.2 * random()));
  }
  return { object: trees };
}

function turned(profile: number[][], segments: number, { r, g, b }: Color): LatheGeometry {
  const lathe = new LatheGeometry(
    profile.map(([x, y]) => new Vector2(x, y)),
    segments,
  );
  const { count } = lathe.attributes.position!;
  const colors = Array.from({ length: count }, () => [r, g, b]).flat();
  lathe.setAttribute('color', new Float32BufferAttribute(colors, 3));
  return lathe;
}
