import {
  BackSide,
  BoxGeometry,
  Mesh,
  MeshBasicMaterial,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { CharacterController, CubeCollider, type CubeColliderOptions } from 'three-cube-collider';

/** A character in a room whose context is lost, twice: once over many frames, once between two of them. */
export default async function contextLoss(options: CubeColliderOptions) {
  const renderer = new WebGLRenderer();
  const scene = new Scene();
  scene.add(new Mesh(new BoxGeometry(4, 2, 4), new MeshBasicMaterial({ side: BackSide })));
  const collider = new CubeCollider(options);
  const character = new CharacterController(collider);
  character.teleport(new Vector3(0, -0.99, 0));
  const canvas = renderer.domElement;
  const { loseContext, restoreContext } = renderer.getContext().getExtension('WEBGL_lose_context')!;
  const extension = renderer.getContext().getExtension('WEBGL_lose_context')!;
  const lose = () => happened('webglcontextlost', () => loseContext.call(extension));
  const restore = () => happened('webglcontextrestored', () => restoreContext.call(extension));
  const happened = (event: string, act: () => void) =>
    new Promise<void>((resolve) => {
      canvas.addEventListener(event, () => resolve(), { once: true });
      setTimeout(act);
    });
  const walk = async (frames: number) => {
    character.walk(new Vector3(0.3, 0, 0));
    for (let i = 0; i < frames; i++) {
      character.update(renderer, scene, 1 / 60);
      await new Promise((resolve) => setTimeout(resolve, 4));
    }
    return character.position.clone();
  };

  const began = await walk(120);
  await lose();
  const held = [await walk(10), await walk(10)];
  const readyWhileLost = character.ready;
  await restore();
  // A draw that got lost is waited for a while before the next, and read some frames later.
  const resumed = await walk(120);
  const drop = collider.stats.reads;
  const twice = lose();
  await twice;
  await restore();
  const again = await walk(120);
  const report = {
    began: began.x,
    heldStill: held[0]!.distanceTo(held[1]!),
    readyWhileLost,
    resumed: resumed.x - held[1]!.x,
    again: again.x - resumed.x,
    readsAfter: collider.stats.reads - drop,
    foot: again.y,
  };
  collider.dispose();
  renderer.dispose();
  return report;
}
