import { Scene, Vector3, type BufferGeometry, type Object3D } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { Judge } from '../rivals/Judge.js';
import { solidGeometry, solidMeshes } from '../rivals/solidGeometry.js';
import { Places, standBelow } from './Places.js';

/** A level as the walkers get it. */
export interface WalkLevel {
  /** As loaded, for those who draw. */
  scene: Scene;
  /** All that is solid in one world-space geometry, for those who build. */
  geometry: BufferGeometry;
  triangles: number;
  judge: Judge;
  /** Where walks begin: the foot, world, metres. */
  start: Vector3;
  /** Further places to begin at, for a seed. */
  places(seed: number): Places;
  /** Height of the lowest vertex. */
  lowest: number;
}

/**
 * Loads a GLB file.
 *
 * @param start where walks begin; by default at the node `spawn`, else at the first free place around the origin
 * @throws Error if there is no free place to start at
 */
export async function loadWalkLevel(
  url: string,
  start?: readonly [number, number, number],
): Promise<WalkLevel> {
  const { scene: root } = await new GLTFLoader().loadAsync(url);
  const scene = new Scene().add(root);
  scene.updateMatrixWorld(true);
  const geometry = solidGeometry(solidMeshes(scene));
  geometry.computeBoundingBox();
  const judge = new Judge(geometry);
  const begin = start ? new Vector3(...start) : startOf(root, judge);
  const { min, max } = geometry.boundingBox!;
  return {
    scene,
    geometry,
    triangles: geometry.index!.count / 3,
    judge,
    start: begin,
    places: (seed) => new Places(judge, begin, max.y + 1, seed),
    lowest: min.y,
  };
}

/** A foot that stands free: at the node `spawn`, or where a spiral around the origin first finds a floor with room. */
function startOf(root: Object3D, judge: Judge): Vector3 {
  const spawn = root.getObjectByName('spawn');
  if (spawn) {
    const eye = new Vector3().setFromMatrixPosition(spawn.matrixWorld);
    eye.y += 1;
    const foot = standBelow(judge, eye, 2);
    if (foot) return foot;
  }
  for (let i = 0; i < 4000; i++) {
    const turn = 2.4 * i; // the golden angle, about: no two rings alike
    const distance = 0.25 * Math.sqrt(i);
    const eye = new Vector3(distance * Math.cos(turn), 1.6, distance * Math.sin(turn));
    const foot = standBelow(judge, eye, 10);
    if (foot) return foot;
  }
  throw new Error('No free place with a floor around the origin: give one with --start x,y,z.');
}
