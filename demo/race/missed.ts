import type { Mesh, Object3D, SkinnedMesh } from 'three';
import type { Hall } from '../hall/createHall.js';

/** In words what somebody does who is in the middle of a mesh that moves, and why they may. */
export function missed(mesh: Mesh, hall: Hall | null, movers: Object3D | null): string {
  if (mesh === hall?.waves.object) return 'falls through: the waves, moved by a shader, are';
  if (mesh === hall?.wall.sheet) return 'walks through: the bulge, pushed out by a shader, is';
  if ((mesh as Partial<SkinnedMesh>).isSkinnedMesh) {
    return 'passes through: the creature, posed by its skeleton, is';
  }
  if (mesh.geometry.morphAttributes.position !== undefined) {
    return 'falls through: the hill, raised by morph targets, is';
  }
  for (let at: Object3D | null = mesh; at !== null; at = at.parent) {
    if (at === movers) return 'passes through: what rides up and down, or turns, is';
  }
  return 'passes through: this is';
}
