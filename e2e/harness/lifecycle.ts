import {
  BoxGeometry,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import { CubeCollider, type CubeColliderOptions } from 'three-cube-collider';
import { CubeColliderHelper } from 'three-cube-collider/helpers';

/** Counters of `renderer.info` before, during and after a collider's life. */
export default async function lifecycle(options: CubeColliderOptions) {
  const renderer = new WebGLRenderer();
  const scene = new Scene();
  scene.add(new Mesh(new BoxGeometry(2, 2, 2), new MeshStandardMaterial()));
  const camera = new PerspectiveCamera();
  renderer.render(scene, camera);
  const count = () => ({ ...renderer.info.memory, programs: renderer.info.programs!.length });
  const before = count();
  const collider = new CubeCollider(options);
  const helper = new CubeColliderHelper(collider);
  await collider.compile(renderer, scene);
  for (let i = 0; i < 3; i++) {
    collider.update(renderer, scene);
    renderer.render(scene, camera);
    helper.render(renderer);
  }
  await collider.updateAsync(renderer, scene);
  const during = count();
  helper.dispose();
  collider.dispose();
  renderer.render(scene, camera);
  const after = count();

  const warnings: string[] = [];
  const { warn } = console;
  console.warn = (...words: unknown[]) => warnings.push(words.join(' '));
  for (let i = 0; i < 3; i++) collider.update(renderer, scene);
  const fresh = new CubeCollider(options);
  for (let i = 0; i < 3; i++) {
    fresh.update(undefined as never, scene);
    fresh.update(renderer, undefined as never);
    fresh.position.x = NaN;
    fresh.update(renderer, scene);
    fresh.position.x = 0;
  }
  await fresh.updateAsync(renderer, scene);
  const recovered = fresh.stats.reads;
  fresh.dispose();
  console.warn = warn;
  renderer.dispose();
  return { before, during, after, warnings, recovered };
}
