import { Mesh, MeshBasicMaterial, Scene, WebGLRenderer } from 'three';
import { CubeCollider } from 'three-cube-collider';
import { busyLoop } from '../../e2e/support/busyLoop.js';
import { seeded } from '../../e2e/support/axisScenes.js';
import { TriangleIndex } from '../../src/collider/TriangleIndex.js';
import { verticesOf } from '../../src/collider/verticesOf.js';
import { terrain } from '../../test/support/terrain.js';

/** Metres: a level as wide as a football field is long. */
const SIZE = 100;
/** As the collider has it, milliseconds. */
const SLICE = 1.5;
/** Meshes with fewer triangles are never indexed. */
const HUGE = 512;

/** Draws and reads one mesh of a level from many places: whole, while its triangles are found, and then what is near. */
export default function huge(options: {
  cells: number;
  shuffled: boolean;
  /** Draws of all triangles, before it is known where they are: seconds each, if there are millions. */
  whole: number;
  rounds: number;
}) {
  const { cells, shuffled, rounds } = options;
  const triangles = 2 * cells * cells;
  const renderer = new WebGLRenderer();
  const geometry = terrain(cells, SIZE, shuffled ? seeded(7) : undefined);
  const scene = new Scene().add(new Mesh(geometry, new MeshBasicMaterial()));
  const collider = new CubeCollider({ readback: 'sync', far: 1.8, supersample: 1 });
  let step = 0;
  const update = () => {
    // By the golden angle: evenly over the level.
    const angle = 2.399963 * step;
    const away = 0.4 * SIZE * Math.sqrt((step++ % 40) / 40);
    const x = away * Math.cos(angle);
    const z = away * Math.sin(angle);
    collider.position.set(x, Math.sin(0.5 * x) * Math.cos(0.4 * z) + 1, z);
    const start = performance.now();
    collider.update(renderer, scene);
    return performance.now() - start;
  };
  // Compiles and uploads.
  update();
  const whole: number[] = [];
  const slices: number[] = [];
  const control: number[] = [];
  let bytes = 0;
  if (triangles >= HUGE) {
    for (let i = 0; i < options.whole; i++) whole.push(update());
    // The same work once more, to know when it is over and what it takes.
    const busy = busyLoop(SLICE);
    const index = new TriangleIndex(geometry, verticesOf(geometry)!);
    while (!index.done) {
      const start = performance.now();
      index.work(start + SLICE);
      slices.push(performance.now() - start);
      control.push(busy());
    }
    bytes = index.bytes / triangles;
    for (let i = 0; i < 2 * slices.length + 100; i++) collider.survey(scene);
    for (let i = 0; i < 3; i++) update();
  }
  const draw: number[] = [];
  for (let round = 0; round < rounds; round++) draw.push(update());
  collider.dispose();
  renderer.dispose();
  renderer.forceContextLoss();
  return { triangles, shuffled, whole, slices, control, bytes, draw };
}
