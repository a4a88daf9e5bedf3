import { Mesh, MeshBasicMaterial, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { CubeCollider } from 'three-cube-collider';
import { terrain } from '../../test/support/terrain.js';
import { seeded } from '../support/axisScenes.js';

/** Places the collider looks from: over the hills, at an edge, and beside it all. */
const PLACES = [
  [0, 1.2, 0],
  [7, 0.9, -5],
  [-19.5, 1, 3],
  [12, 1.5, 19],
  [0.3, 1.2, 0.1],
] as const;

/**
 * Fields of a huge mesh with what is near of it drawn alone, beside those of one that has to be drawn whole: its
 * geometry is edited before each draw, its places staying the same.
 */
export default async function huge({ shuffled, cells }: { shuffled: boolean; cells: number }) {
  const renderer = new WebGLRenderer();
  const camera = new PerspectiveCamera();
  const make = () => terrain(cells, 40, shuffled ? seeded(7) : undefined);
  const material = new MeshBasicMaterial();
  const parts = new Mesh(make(), material);
  const whole = new Mesh(make(), material);
  for (const mesh of [parts, whole]) mesh.rotation.y = 0.3;
  const partsScene = new Scene().add(parts);
  const wholeScene = new Scene().add(whole);
  const memory = renderer.info.memory.geometries;
  const a = new CubeCollider({ readback: 'sync', far: 2 });
  const b = new CubeCollider({ readback: 'sync', far: 2 });

  const triangles = (collider: CubeCollider, scene: Scene) => {
    renderer.info.autoReset = false;
    const before = renderer.info.render.triangles;
    let drawn = 0;
    const { render } = renderer;
    // The collider puts the counters back: they are read right after its own draw.
    renderer.render = (...args) => {
      const start = renderer.info.render.triangles;
      render.apply(renderer, args);
      drawn += renderer.info.render.triangles - start;
    };
    collider.update(renderer, scene);
    renderer.render = render;
    return { drawn, restored: renderer.info.render.triangles === before };
  };
  const compare = () => {
    let differing = 0;
    let hits = 0;
    const drawn = { parts: 0, whole: 0 };
    for (const [x, y, z] of PLACES) {
      a.position.set(x, y, z);
      b.position.set(x, y, z);
      drawn.parts = Math.max(drawn.parts, triangles(a, partsScene).drawn);
      whole.geometry.attributes.position!.needsUpdate = true;
      drawn.whole = Math.max(drawn.whole, triangles(b, wholeScene).drawn);
      const [one, other] = [a.field!, b.field!];
      for (let i = 0; i < one.distance.length; i++) {
        if (other.distance[i] !== Infinity) hits++;
        let same = one.distance[i] === other.distance[i] && one.front[i] === other.front[i];
        same &&= one.object[i] === other.object[i];
        for (let k = 3 * i; k < 3 * i + 3; k++) same &&= one.normal[k] === other.normal[k];
        if (!same) differing++;
      }
    }
    return { differing, hits, ...drawn };
  };
  const known = () => {
    for (let frame = 0; frame < 20_000; frame++) {
      a.survey(partsScene);
      if (frame % 50 === 49 && triangles(a, partsScene).drawn < (4 / 3) * cells * cells) return;
    }
    throw new Error('The runs were never found.');
  };

  a.position.set(...PLACES[0]);
  const first = triangles(a, partsScene);
  known();
  const indexed = compare();
  // A hill grows under the first place, and the old one is nowhere any more.
  for (const { geometry } of [parts, whole]) {
    const { position } = geometry.attributes;
    for (let i = 0; i < position!.count; i++) position!.setY(i, position!.getY(i) + 0.5);
    position!.needsUpdate = true;
    geometry.computeBoundingSphere();
  }
  a.position.set(...PLACES[0]);
  const atOnce = triangles(a, partsScene).drawn;
  known();
  const edited = compare();
  renderer.render(partsScene, camera);
  renderer.render(wholeScene, camera);
  a.dispose();
  b.dispose();
  const geometries = renderer.info.memory.geometries - memory;
  parts.geometry.dispose();
  whole.geometry.dispose();
  const left = renderer.info.memory.geometries - memory;
  renderer.dispose();
  return { first, indexed, atOnce, edited, geometries, left };
}
