import { BoxGeometry, Mesh, MeshBasicMaterial, Scene, Vector3, WebGLRenderer } from 'three';
import { CharacterController, CubeCollider } from 'three-cube-collider';

const COUNT = 8;
/** Where the first step begins, and where a climb begins before it, metres. */
const FIRST = 1.5;
const FRAME = 1 / 60;

/**
 * Climbs stairs of boxes straight on, again and again from another distance: which rays fall beside an edge, which
 * through it, depends on where one stands.
 *
 * @returns where it stood for a second, if it did: its foot
 */
export default function stairs({
  rise,
  tread,
  climbs,
}: {
  rise: number;
  tread: number;
  climbs: number;
}): number[][] {
  const renderer = new WebGLRenderer();
  const scene = new Scene();
  const box = (deep: number, y: number, z: number) => {
    const mesh = new Mesh(new BoxGeometry(3, rise, deep), new MeshBasicMaterial());
    mesh.position.set(0, y, z - deep / 2);
    scene.add(mesh);
  };
  box(40, -rise / 2, 20);
  for (let i = 0; i < COUNT; i++) {
    box(tread * (COUNT - i) + 2, rise * (i + 0.5), -FIRST - tread * i);
  }
  const collider = new CubeCollider({ readback: 'sync' });
  const character = new CharacterController(collider);
  const stuck: number[][] = [];
  const last = new Vector3();
  for (let climb = 0; climb < climbs; climb++) {
    character.walk(new Vector3());
    character.teleport(new Vector3(0, 0.05, 0.3 - 0.8 * ((0.618 * climb) % 1)));
    for (let i = 0; i < 10; i++) character.update(renderer, scene, FRAME);
    character.walk(new Vector3(0, 0, -3));
    let still = 0;
    while (still < 60 && character.body.position.z > -FIRST - tread * COUNT) {
      last.copy(character.body.position);
      character.update(renderer, scene, FRAME);
      still = character.body.position.distanceTo(last) < 1e-3 ? still + 1 : 0;
    }
    if (still > 0) stuck.push(character.body.position.toArray());
  }
  character.dispose();
  collider.dispose();
  renderer.dispose();
  return stuck;
}
