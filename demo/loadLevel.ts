import {
  Euler,
  Mesh,
  MeshStandardMaterial,
  Quaternion,
  Vector3,
  type Group,
  type Object3D,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/** Where a walk begins. */
export interface Spawn {
  /** The foot, world, metres. */
  position: Vector3;
  /** The turn about +Y from looking along -Z, radians. */
  yaw: number;
}

export interface Level {
  root: Group;
  spawn: Spawn;
}

/**
 * Loads a GLB file whose node `spawn` marks the start (the origin, if it has none).
 *
 * @param onProgress called with 0 to 1 while the file comes in, where the server tells its size, and with 1 at the end.
 * @param anisotropy samples along the slant of a floor seen at a low angle, cut to what the GPU has; they double the
 *   time of a frame on a software GPU.
 * @throws Error that names the url, if the file cannot be fetched or read.
 */
export async function loadLevel(
  url: string,
  onProgress: (fraction: number) => void,
  anisotropy = 8,
): Promise<Level> {
  const gltf = await new GLTFLoader()
    .loadAsync(url, ({ loaded, total }) => {
      if (total > 0) onProgress(Math.min(1, loaded / total));
    })
    .catch((cause: unknown) => {
      const reason =
        cause instanceof SyntaxError
          ? 'it is no GLB or glTF file.'
          : cause instanceof Error
            ? cause.message
            : String(cause);
      throw new Error(`The level "${url}" could not be loaded: ${reason}`, { cause });
    });
  const root = gltf.scene;
  root.updateMatrixWorld(true);
  root.traverse((object) => prepare(object, anisotropy));
  onProgress(1);
  return { root, spawn: spawnOf(root) };
}

function prepare(object: Object3D, anisotropy: number): void {
  if (!(object instanceof Mesh)) return;
  object.castShadow = true;
  object.receiveShadow = true;
  const materials: unknown[] = Array.isArray(object.material) ? object.material : [object.material];
  for (const material of materials)
    if (material instanceof MeshStandardMaterial && material.map)
      material.map.anisotropy = anisotropy;
}

function spawnOf(root: Group): Spawn {
  const position = new Vector3();
  const turn = new Quaternion();
  root.getObjectByName('spawn')?.matrixWorld.decompose(position, turn, new Vector3());
  return { position, yaw: new Euler().setFromQuaternion(turn, 'YXZ').y };
}
