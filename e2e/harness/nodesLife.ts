import {
  BackSide,
  BoxGeometry,
  Mesh,
  MeshStandardMaterial,
  Scene,
  SkinnedMesh,
  Vector3,
} from 'three';
import { positionLocal, uniform } from 'three/tsl';
import { ClippingGroup, MeshStandardNodeMaterial, WebGPURenderer } from 'three/webgpu';
import { CharacterController, CubeCollider } from 'three-cube-collider/webgpu';
import { deformedKinds } from '../support/kinds/deformedKinds.js';
import { type Backend, createRendering } from '../support/rendering.js';

async function rendererOn(backend: Backend): Promise<WebGPURenderer> {
  return (await createRendering(backend)).renderer as unknown as WebGPURenderer;
}

/** A room to walk in. */
function room(): Scene {
  const box = new Mesh(new BoxGeometry(4, 2, 4), new MeshStandardMaterial({ side: BackSide }));
  return new Scene().add(box);
}

/** What three counts for itself, over lives of colliders that see a bit of everything. */
async function rounds(backend: Backend) {
  const renderer = await rendererOn(backend);
  const scene = room();
  const moved = new MeshStandardNodeMaterial();
  moved.positionNode = positionLocal.mul(uniform(0.5));
  const group = new ClippingGroup();
  group.add(new Mesh(new BoxGeometry(), new MeshStandardMaterial()));
  const { object } = await deformedKinds['SkinnedMesh, attached']!(null as never, null);
  scene.add(new Mesh(new BoxGeometry(), moved), group, object);
  let skins = 0;
  object.traverse((each) => (skins += each instanceof SkinnedMesh ? 1 : 0));
  const count = () => ({ ...renderer.info.memory });
  const before = count();
  const counts: ReturnType<typeof count>[] = [];
  let during = before;
  let reads = 0;
  let built = 0;
  let builtLate = 0;
  renderer.debug.onNodeBuilderCreated = () => built++;
  for (let i = 0; i < 20; i++) {
    const collider = new CubeCollider({ resolution: 12, far: 3, supersample: i % 2 === 0 ? 1 : 2 });
    const compiled = i % 3 === 0;
    if (compiled) await collider.compile(renderer, scene);
    const then = built;
    await collider.updateAsync(renderer, scene);
    if (compiled) builtLate += built - then;
    if (i % 2 === 0) collider.update(renderer, scene);
    during = count();
    reads += collider.stats.reads;
    collider.dispose();
    counts.push(count());
  }
  renderer.dispose();
  return { before, during, first: counts[1]!, last: counts[19]!, reads, skins, built, builtLate };
}

/** Asked before the renderer is initialised, and after. */
async function early(backend: Backend) {
  const renderer = new WebGPURenderer({ forceWebGL: backend === 'fallback' });
  const scene = room();
  const collider = new CubeCollider();
  const character = new CharacterController(collider);
  character.teleport(new Vector3(0, -0.99, 0));
  character.walk(new Vector3(1, 0, 0));
  for (let i = 0; i < 10; i++) character.update(renderer, scene, 1 / 60);
  const held = character.position.x === 0 && !character.ready;
  await renderer.init();
  const walked = await start(character, renderer, scene);
  collider.dispose();
  renderer.dispose();
  return { held, walked };
}

/** A character whose renderer's device goes, and who gets another. */
async function loss({ backend, how }: { backend: Backend; how: 'told' | 'gone' }) {
  const scene = room();
  const renderer = await rendererOn(backend);
  const collider = new CubeCollider();
  const character = new CharacterController(collider);
  character.teleport(new Vector3(0, -0.99, 0));
  const began = await start(character, renderer, scene);
  const lost = new Promise<void>((resolve) => {
    renderer.domElement.addEventListener('webglcontextlost', () => resolve(), { once: true });
    const { device } = renderer.backend as unknown as { device?: GPUDevice };
    void device?.lost.then(() => resolve());
    if (how === 'told') resolve();
  });
  if (how === 'told') {
    renderer.onDeviceLost({ api: 'WebGPU', message: 'gone', reason: null, originalEvent: null });
  } else if (backend === 'WebGPU') {
    (renderer.backend as unknown as { device: GPUDevice }).device.destroy();
  } else {
    const gl = (renderer.backend as unknown as { gl: WebGL2RenderingContext }).gl;
    gl.getExtension('WEBGL_lose_context')!.loseContext();
  }
  await lost;
  const { position } = character;
  // What its last field vouches for it may still walk.
  for (let i = 0; i < 30 && (await walk(character, renderer, scene, 10)) !== 0; i++);
  const { x } = position;
  await walk(character, renderer, scene, 20);
  const still = position.x === x;
  const pending = await collider.updateAsync(renderer, scene);
  const other = await rendererOn(backend);
  const reads = collider.stats.reads;
  const resumed = await start(character, other, scene, 60, -1);
  const report = {
    began,
    still,
    pending,
    resumed,
    reads: collider.stats.reads - reads,
    foot: position.y,
  };
  collider.dispose();
  other.dispose();
  return report;
}

/** Metres along x, of some frames with one at least that moved it: the first are spent on programs. */
async function start(...[character, ...given]: Parameters<typeof walk>): Promise<number> {
  let way = 0;
  for (let i = 0; i < 20 && Math.abs(way) < 0.1; i++) way += await walk(character, ...given);
  return way;
}

/** Metres along x. */
async function walk(
  character: CharacterController,
  renderer: WebGPURenderer,
  scene: Scene,
  frames = 60,
  speed = 0.6,
): Promise<number> {
  const { x } = character.position;
  character.walk(new Vector3(speed, 0, 0));
  for (let i = 0; i < frames; i++) {
    character.update(renderer, scene, 1 / 60);
    await new Promise((resolve) => setTimeout(resolve, 8));
  }
  return character.position.x - x;
}

const cases = { rounds, early, loss };
export type LifeCases = typeof cases;

/** One of the above, and what was warned of meanwhile. */
export default async function nodesLife({ name, args }: { name: keyof LifeCases; args: never }) {
  const warnings: string[] = [];
  const { warn } = console;
  console.warn = (...words: unknown[]) => warnings.push(words.join(' '));
  const seen = await cases[name](args);
  console.warn = warn;
  return { ...seen, warnings };
}
