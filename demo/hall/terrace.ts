import {
  type BoxGeometry,
  type BufferGeometry,
  Group,
  LatheGeometry,
  type Object3D,
  RingGeometry,
  Vector2,
} from 'three';
import { assemble, merge, type Materials, slab, stretch } from '../pieces.js';

/** Of the hall's floor above the plaza's, as high as the wall that it is reached over, metres. */
export const TERRACE_HEIGHT = 4.2;
/** From its middle to its east and west edges, and from its north edge to its south one. */
const [HALF, DEPTH] = [13, 27];
const [PARAPET, THICK] = [1.15, 0.36];
/** The way up: steps of 0.20 × 0.35 m. */
const STEPS = 21;
const [RISE, RUN, STAIR] = [TERRACE_HEIGHT / STEPS, 0.35, 3];
/** How far north the plaza's wall and its coping reach: the last step lies over them, metres. */
const WALL = 1.14;
/** Half the gate's clear width. */
const GATE = 1.6;

/** The floor under the exhibits, a stair up to it and a gate. Its origin is in the middle of its north edge. */
export function createTerrace(material: Materials): Object3D {
  const terrace = new Group();
  terrace.name = 'terrace';
  terrace.add(createFloor(material), createParapet(material), createStair(material));
  return terrace;
}

function createFloor(material: Materials): Object3D {
  const lawn = slab(9.8, 0.1, 8, -7.4, 5.2).translate(0, 0.02, 0);
  const path = new RingGeometry(2.4, 5, 96).rotateX(-Math.PI / 2).translate(-7.3, 0.008, 16.6);
  stretch(path, 5, 5);
  return assemble('terrace floor', [
    [slab(2 * HALF, 0.3, DEPTH, 0, DEPTH / 2), material('floor-paving')],
    [slab(2 * HALF - 0.2, 6, DEPTH - 0.2, 0, DEPTH / 2).translate(0, -0.3, 0), material('plaster')],
    [
      merge(
        slab(2 * HALF + 0.16, 0.22, DEPTH + 0.1, 0, DEPTH / 2 + 0.05).translate(0, -0.12, 0),
        rim(8, 6.4, 7.4, 5),
        rim(8.4, 7, 8, 13.4),
      ),
      material('nosing'),
    ],
    // A lawn under the trees, and the creature's own path.
    [merge(lawn, path), material('floor-grass')],
  ]);
}

/** Four kerbs around what lies in the floor. @param x of its middle, as z */
function rim(width: number, depth: number, x: number, z: number): BufferGeometry {
  const [wide, high] = [0.2, 0.05];
  return merge(
    ...[-1, 1].flatMap((side) => [
      slab(wide, high, depth + 2 * wide, x + (side * (width + wide)) / 2, z),
      slab(width, high, wide, x, z + (side * (depth + wide)) / 2),
    ]),
  ).translate(0, high, 0);
}

/** A wall around it, open at the gate, with a ball on every corner. */
function createParapet(material: Materials): Object3D {
  const out = HALF - THICK / 2;
  const [north, south] = [THICK / 2, DEPTH - THICK / 2];
  const arm = HALF - GATE - 0.5;
  const around = (height: number, thick: number): BufferGeometry =>
    merge(
      slab(thick, height, DEPTH, -out, DEPTH / 2),
      slab(thick, height, DEPTH, out, DEPTH / 2),
      slab(2 * HALF - 2 * THICK, height, thick, 0, south),
      ...[-1, 1].map((side) => slab(arm, height, thick, side * (HALF - arm / 2), north)),
    );
  const corners = [-out, out].flatMap((x) => [north, south].map((z) => [x, z] as const));
  const pillars = [-1, 1].map((side) => slab(0.6, 3.2, 0.6, side * (GATE + 0.3), north));
  const ball = [
    [0.16, 0],
    [0.26, 0.08],
    [0.31, 0.22],
    [0.29, 0.37],
    [0.21, 0.48],
    [0.1, 0.54],
    [0, 0.55],
  ].map(([x, y]) => new Vector2(x, y));
  return assemble('terrace walls', [
    [around(PARAPET, THICK).translate(0, PARAPET, 0), material('plaster')],
    [around(0.09, THICK + 0.14).translate(0, PARAPET + 0.08, 0), material('tile')],
    [
      merge(
        ...corners.map(([x, z]) => slab(0.7, 1.7, 0.7, x, z).translate(0, 1.6, 0)),
        ...pillars.map((pillar) => pillar.translate(0, 3.1, 0)),
      ),
      material('stone'),
    ],
    [
      merge(
        slab(2 * GATE + 1.4, 0.5, 0.62, 0, north).translate(0, 3.6, 0),
        ...corners.map(([x, z]) => slab(0.86, 0.12, 0.86, x, z).translate(0, 1.72, 0)),
      ),
      material('nosing'),
    ],
    [slab(2 * GATE + 1.7, 0.14, 0.9, 0, north).translate(0, 3.73, 0), material('tile')],
    [
      merge(...corners.map(([x, z]) => new LatheGeometry(ball, 24).translate(x, 1.72, z))),
      material('terracotta'),
    ],
  ]);
}

/** Straight up from the plaza over its wall, between two slanting sides. */
function createStair(material: Materials): Object3D {
  const end = 0.02;
  const steps: BufferGeometry[] = [];
  const edges: BufferGeometry[] = [];
  /** Of the dark stripe along each step's edge: its depth, and its height on the riser. */
  const [nose, drop] = [0.06, 0.05];
  for (let i = 0; i < STEPS; i++) {
    const front = -WALL - RUN * (STEPS - 1 - i);
    const back = i === STEPS - 1 ? end : front + RUN;
    const height = RISE * (i + 1);
    const top = height - TERRACE_HEIGHT;
    const box = (from: number, high: number) =>
      slab(STAIR, high, back - from, 0, (from + back) / 2);
    const edge = slab(STAIR, drop, nose, 0, front + nose / 2);
    edges.push(edge.translate(0, top, 0));
    steps.push(
      box(front + nose, drop).translate(0, top, 0),
      box(front, height + 0.1 - drop).translate(0, top - drop, 0),
    );
  }
  const length = RUN * (STEPS - 1) + WALL;
  const sides = (wide: number, high: number, above: number) =>
    merge(
      ...[-1, 1].map((side) => {
        const bar = slab(wide, high, length, side * (STAIR / 2 + 0.15), -length / 2);
        return slanted(bar, above);
      }),
    );
  return assemble('terrace stair', [
    [merge(...steps), material('slab')],
    [merge(...edges), material('dark')],
    // Down into the ground all along.
    [sides(0.3, TERRACE_HEIGHT + 1, 0.85), material('plaster')],
    [sides(0.42, 0.1, 0.93), material('tile')],
  ]);
}

/** Shears a bar so that it follows the steps, its top that much above their noses; level over the wall. */
function slanted(bar: BoxGeometry, above: number): BufferGeometry {
  const { position } = bar.attributes;
  for (let i = 0; i < position!.count; i++) {
    const along = Math.min(0, position!.getZ(i) + WALL);
    position!.setY(i, position!.getY(i) + above + along * (RISE / RUN));
  }
  bar.computeVertexNormals();
  return bar;
}
