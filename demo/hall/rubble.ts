import {
  BatchedMesh,
  type BufferGeometry,
  Color,
  Group,
  IcosahedronGeometry,
  MathUtils,
  Mesh,
  MeshStandardMaterial,
  Object3D,
} from 'three';
import { type Materials, stretch } from '../pieces.js';
import { cloth, hemmed, lift } from './cloth.js';
import type { Exhibit } from './Exhibit.js';

const [WIDTH, DEPTH] = [8, 7];
/** Of the heap, metres. */
const HEIGHT = 1.4;
/** Between two stones, metres. */
const SPACING = 0.5;
const ROCKS = 4;

/** A heap of stones to climb from the west: one `BatchedMesh` of four kinds of stone over a mound of gravel. */
export function createRubble(material: Materials): Exhibit & { readonly stones: BatchedMesh } {
  const gravel = cloth(WIDTH, DEPTH, 0.25);
  stretch(gravel, WIDTH / 2, DEPTH / 2);
  lift(gravel, (x, z) => moundHeight(x, z) + 0.01);
  const earth = material('slab');
  earth.color.multiplyScalar(0.55);
  const mound = new Mesh(gravel, earth);
  mound.name = 'gravel';
  mound.receiveShadow = true;

  const rocks = Array.from({ length: ROCKS }, (_, i) => createRock(i));
  const vertices = rocks.reduce((sum, rock) => sum + rock.attributes.position!.count, 0);
  const [columns, rows] = [WIDTH / SPACING - 1, DEPTH / SPACING - 1];
  const stones = new BatchedMesh(
    columns * rows,
    vertices,
    0,
    new MeshStandardMaterial({ roughness: 0.95 }),
  );
  stones.name = 'rubble';
  stones.castShadow = stones.receiveShadow = true;
  const kinds = rocks.map((rock) => stones.addGeometry(rock));
  const random = MathUtils.seededRandom;
  random(23);
  const stone = new Object3D();
  const color = new Color();
  for (let i = 0; i < columns * rows; i++) {
    const x = ((i % columns) - (columns - 1) / 2) * SPACING + 0.2 * (random() - 0.5);
    const z = (Math.floor(i / columns) - (rows - 1) / 2) * SPACING + 0.2 * (random() - 0.5);
    const size = 0.24 + 0.14 * random();
    // Sunk in by about a half, so that what stands out is a step and not a wall.
    stone.position.set(x, moundHeight(x, z) - 0.1 * size, z);
    stone.rotation.set(0.5 * (random() - 0.5), 2 * Math.PI * random(), 0.5 * (random() - 0.5));
    stone.scale.set(size * 1.15, size * 0.62, size);
    stone.updateMatrix();
    const id = stones.addInstance(kinds[Math.floor(random() * ROCKS)]!);
    stones.setMatrixAt(id, stone.matrix);
    stones.setColorAt(id, color.setHSL(0.08 + 0.02 * random(), 0.16, 0.42 + 0.18 * random()));
  }
  stones.computeBoundingSphere();

  const heap = new Group();
  heap.name = 'heap';
  heap.add(mound, stones);
  return { object: heap, stones };
}

/** Up from the west to a level top. */
function moundHeight(x: number, z: number): number {
  const climb = MathUtils.smoothstep(x, -WIDTH / 2, 1.6);
  return HEIGHT * climb * hemmed(x, WIDTH / 2, 1.4) * hemmed(z, DEPTH / 2, 2.2);
}

/** A stone of flat faces, about 1 m in radius. */
function createRock(kind: number): BufferGeometry {
  const rock = new IcosahedronGeometry(1, 1);
  const { position } = rock.attributes;
  for (let i = 0; i < position!.count; i++) {
    const [x, y, z] = [position!.getX(i), position!.getY(i), position!.getZ(i)];
    // Of the place alone, so that faces keep sharing their corners.
    const bump =
      1 + 0.16 * Math.sin(3.1 * x + 1.7 * kind) * Math.cos(2.7 * z - kind) + 0.08 * Math.sin(5 * y);
    position!.setXYZ(i, bump * x, bump * y, bump * z);
  }
  rock.computeVertexNormals();
  return rock;
}
