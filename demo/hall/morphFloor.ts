import {
  type BufferGeometry,
  Float32BufferAttribute,
  Mesh,
  type MeshStandardMaterial,
} from 'three';
import type { Materials } from '../pieces.js';
import { checkers } from './checkers.js';
import { cloth, hemmed, lift } from './cloth.js';
import type { Exhibit } from './Exhibit.js';

const [WIDTH, DEPTH] = [8, 6.4];
const CELL = 0.2;
/** Over the hall's floor, so that it hides it. */
const BASE = 0.015;

/** A hill in the middle, and rows of little ones, metres over the floor. */
const SHAPES = [
  (x: number, z: number) => {
    const away = Math.min(1, Math.hypot(x, z) / 2.8);
    return 0.45 * (1 + Math.cos(Math.PI * away));
  },
  (x: number, z: number) =>
    0.12 *
    hemmed(x, WIDTH / 2, 1) *
    hemmed(z, DEPTH / 2, 1) *
    (2 + Math.cos(2.6 * x) + Math.cos(2.6 * z)),
];

/** A floor that breathes between two shapes: morph targets and nothing else. */
export function createMorphFloor(material: Materials): Exhibit {
  const geometry = cloth(WIDTH, DEPTH, CELL);
  lift(geometry, () => BASE);
  geometry.morphTargetsRelative = true;
  const targets = SHAPES.map((shape) => differenceOf(geometry, shape));
  geometry.morphAttributes.position = targets.map(({ position }) => position);
  geometry.morphAttributes.normal = targets.map(({ normal }) => normal);

  const tiled: MeshStandardMaterial = material('plum');
  tiled.map = checkers('#a67c98', '#e6d3cf');
  tiled.map.repeat.set(WIDTH / 1.6, DEPTH / 1.6);
  tiled.color.set('white');
  const mesh = new Mesh(geometry, tiled);
  mesh.name = 'morph floor';
  mesh.castShadow = mesh.receiveShadow = true;
  return {
    object: mesh,
    update(time) {
      const swing = Math.cos(0.8 * time);
      mesh.morphTargetInfluences![0] = 0.5 - 0.5 * swing;
      mesh.morphTargetInfluences![1] = 0.5 + 0.5 * swing;
    },
  };
}

/** What a shape adds to each vertex and to its normal. */
function differenceOf(flat: BufferGeometry, shape: (x: number, z: number) => number) {
  const bent = flat.clone();
  lift(bent, (x, z) => BASE + shape(x, z));
  const less = (name: 'position' | 'normal') => {
    const from = flat.attributes[name]!.array;
    return new Float32BufferAttribute(
      bent.attributes[name]!.array.map((value, i) => value - from[i]!),
      3,
    );
  };
  return { position: less('position'), normal: less('normal') };
}
