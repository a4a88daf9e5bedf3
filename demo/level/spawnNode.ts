import { Euler, type Object3D, Quaternion, Vector3 } from 'three';
import type { Start } from './findStart.js';

/** `spawn`, `Start`, `SpawnPoint_1`, `player start`, `info_player_start`; not `start_button` nor `staircase`. */
const NAME =
  /^(info[\s_.-]*)?(player[\s_.-]*)?(re)?(spawn|start|entry)([\s_.-]*(point|position|pos|location|place))?([\s_.-]*\d+)?$|^player([\s_.-]*\d+)?$/i;

/** Whether a node of that name tells where to begin. */
export const isSpawnName = (name: string) => NAME.test(name);

/**
 * The node that tells where to begin, if there is one, in the world: the foot, and where its -Z points.
 * World matrices must be fresh.
 */
export function spawnNode(root: Object3D): Start | null {
  let found: Object3D | null = null;
  root.traverse((object) => {
    if (found !== null) return;
    // three takes what paths may not hold out of names.
    const { name } = object.userData as { name?: unknown };
    if (isSpawnName(object.name) || (typeof name === 'string' && isSpawnName(name))) found = object;
  });
  return found && startAt(found);
}

function startAt(node: Object3D): Start {
  const position = new Vector3();
  const turn = new Quaternion();
  node.matrixWorld.decompose(position, turn, new Vector3());
  // Of a node of a Z-up file, too: the way it looks, laid on the ground.
  const ahead = new Vector3(0, 0, -1).applyQuaternion(turn);
  const steep = Math.hypot(ahead.x, ahead.z) < 0.3;
  const yaw = steep ? new Euler().setFromQuaternion(turn, 'YXZ').y : Math.atan2(-ahead.x, -ahead.z);
  return { position, yaw };
}
