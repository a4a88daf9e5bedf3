import {
  BoxGeometry,
  Group,
  Layers,
  Mesh,
  MeshBasicMaterial,
  Object3D,
  Scene,
  Sphere,
  Vector3,
} from 'three';
import { SceneIndex } from '../../src/collider/SceneIndex.js';
import { Selection } from '../../src/collider/Selection.js';
import { Survey } from '../../src/collider/Survey.js';

const FAR = 2.2;
/** Metres between two meshes: some twenty are within reach. */
const APART = 1.15;

/** A scene of boxes in groups of fifty, walked through: surveys every frame, a selection every fourth. */
export default function many({ objects, rounds }: { objects: number; rounds: number }) {
  const scene = new Scene();
  const geometry = new BoxGeometry(0.5, 0.5, 0.5);
  const material = new MeshBasicMaterial();
  const edge = Math.ceil(Math.sqrt(objects));
  let group = new Group();
  for (let i = 0; i < objects; i++) {
    if (i % 50 === 0) scene.add((group = new Group()));
    const mesh = new Mesh(geometry, material);
    mesh.position.set(APART * (i % edge), 0, APART * Math.floor(i / edge));
    group.add(mesh);
  }
  const rules = { layers: new Layers(), filter: null, excluded: new Set<Object3D>() };
  const index = new SceneIndex();
  const selection = new Selection(index);
  const looker = new Survey(index);
  const center = new Vector3((APART * edge) / 2, 0, (APART * edge) / 2);
  const select = () => {
    selection.select(scene, center, FAR, rules, (source) => source);
    looker.note(selection.proxies, center, FAR);
  };
  let start = performance.now();
  select();
  const first = performance.now() - start;
  const times = { survey: [] as number[], select: [] as number[], walk: [] as number[] };
  for (let round = -400; round < rounds; round++) {
    // To and fro, at 3 m/s.
    center.x += Math.floor(round / 50) % 2 === 0 ? 0.05 : -0.05;
    start = performance.now();
    looker.look(scene, center, FAR, rules);
    if (round >= 0) times.survey.push(performance.now() - start);
    if (round % 4 !== 0) continue;
    start = performance.now();
    select();
    if (round >= 0) times.select.push(performance.now() - start);
    if (objects > 20_000 && round % 40 !== 0) continue;
    start = performance.now();
    scene.updateMatrixWorld();
    walk(scene, center);
    if (round >= 0) times.walk.push(performance.now() - start);
  }
  return { objects, near: selection.proxies.length, first, ...times };
}

const sphere = new Sphere();

/** The plain way: every object's matrix, every mesh's sphere. */
function walk(object: Object3D, center: Vector3): number {
  if (!object.visible) return 0;
  let near = 0;
  if ((object as Mesh).isMesh) {
    sphere.copy((object as Mesh).geometry.boundingSphere!).applyMatrix4(object.matrixWorld);
    if (sphere.center.distanceTo(center) < sphere.radius + FAR) near++;
  }
  for (const child of object.children) near += walk(child, center);
  return near;
}
