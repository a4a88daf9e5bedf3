import { Vector3, WebGLRenderer } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { CubeCollider } from 'three-cube-collider';

/** Faces of 32 texels drawn once, twice and four times as fine; the last as many texels drawn, but all of them read. */
const CASES = [
  { resolution: 32, supersample: 1 },
  { resolution: 32, supersample: 2 },
  { resolution: 32, supersample: 4 },
  { resolution: 128, supersample: 1 },
] as const;

/** One case, and the milliseconds of each of its updates: select, draw, reduce, read at once, decode. */
export interface SupersampleResult {
  resolution: number;
  supersample: number;
  times: number[];
}

/** Draws and reads the demo's level from many places with each case in turn. */
export default async function supersample({
  rounds,
}: {
  rounds: number;
}): Promise<SupersampleResult[]> {
  const renderer = new WebGLRenderer();
  const { scene } = await new GLTFLoader().loadAsync('/level.glb');
  const colliders = CASES.map((options) => new CubeCollider({ ...options, readback: 'sync' }));
  const results: SupersampleResult[] = CASES.map((options) => ({ ...options, times: [] }));
  const place = new Vector3();
  for (let round = -10; round < rounds; round++) {
    // By the golden angle: evenly over the plaza, at the height of a body's middle.
    const angle = round * 2.399963;
    const away = 8 * Math.sqrt(Math.abs(round) / rounds);
    place.set(away * Math.cos(angle), 0.9, away * Math.sin(angle));
    colliders.forEach((collider, i) => {
      collider.position.copy(place);
      const start = performance.now();
      collider.update(renderer, scene);
      // The first ones compile and upload.
      if (round >= 0) results[i]!.times.push(performance.now() - start);
    });
  }
  for (const collider of colliders) collider.dispose();
  renderer.dispose();
  renderer.forceContextLoss();
  return results;
}
