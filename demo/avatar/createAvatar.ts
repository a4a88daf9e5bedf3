import { Group, Mesh, type Object3D, SkinnedMesh, Sphere, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { onReducedMotion } from '../page.js';
import { Moves } from './Moves.js';

/** Made by `npm run build:avatar`. */
const FILE = `${import.meta.env.BASE_URL}avatar.glb`;
/** Around all that it ever does: three would look at its vertices in one pose. */
const REACH = new Sphere(new Vector3(0, 0.9, 0), 1.4);

/** A figure that walks: put it where the character is and tell it how fast it goes. */
export interface Avatar {
  /** Origin at the foot, looking along +Z, 1.76 m tall; empty until it is loaded. */
  readonly object: Group;
  /** Resolved once it is loaded, or could not be, which the console tells. */
  readonly ready: Promise<void>;
  /** What it does; null until it is loaded. */
  readonly moves: Moves | null;
  /**
   * @param speed m/s over the ground
   * @param rise m/s, upward: told apart are leaps, falls, and how hard it lands
   */
  animate(delta: number, speed: number, grounded: boolean, crouched: boolean, rise: number): void;
}

/** A small robot with a scarf and a backpack, on a skeleton with clips. Without its file one walks unseen. */
export function createAvatar(file = FILE): Avatar {
  const object = new Group();
  object.name = 'Avatar';
  let moves: Moves | null = null;

  async function load(): Promise<void> {
    try {
      const { scene, animations } = await new GLTFLoader().loadAsync(file);
      scene.traverse(prepare);
      moves = new Moves(scene, animations);
      object.add(scene);
      onReducedMotion((reduced) => (moves!.squash.enabled = !reduced));
    } catch (error) {
      console.warn(
        `Avatar: "${file}" could not be loaded, so there is none; make it with “npm run build:avatar”.`,
        error,
      );
    }
  }

  return {
    object,
    ready: load(),
    get moves() {
      return moves;
    },
    animate(delta, speed, grounded, crouched, rise) {
      moves?.update(delta, speed, grounded, crouched, rise);
      if (object.visible) moves?.pose();
    },
  };
}

function prepare(object: Object3D): void {
  if (object instanceof Mesh) object.castShadow = object.receiveShadow = true;
  if (object instanceof SkinnedMesh) object.boundingSphere = REACH.clone();
}
