import type { Mesh, Vector3 } from 'three';
import type { Hall } from './createHall.js';

/**
 * Where the GPU draws a vertex just now, in its mesh's own frame: posed by skin and morph targets, and, of the hall's two
 * meshes that only a shader moves, by what their shaders work out.
 */
export function drawnVertex(hall: Hall | null) {
  return (mesh: Mesh, vertex: number, target: Vector3): Vector3 => {
    mesh.getVertexPosition(vertex, target);
    if (hall === null) return target;
    const { waves, wall, time } = hall;
    if (mesh === waves.object) {
      target.y = waves.height(target.x, target.z, time) - mesh.position.y;
    } else if (mesh === wall.sheet) {
      target.z = wall.bulge(target.x, target.y, time);
    }
    return target;
  };
}
