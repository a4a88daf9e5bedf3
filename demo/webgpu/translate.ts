import type { Material, Mesh, Object3D } from 'three';
import type { NodeMaterial } from 'three/webgpu';
import { bulgingWallNodes } from './bulgingWallNodes.js';
import { skyNodes } from './skyNodes.js';
import { wavesNodes } from './wavesNodes.js';

/** By the name of a material: its like in nodes, which follows the original's uniforms. */
const LIKES: Record<string, (source: Material) => NodeMaterial> = {
  sky: skyNodes,
  waves: wavesNodes,
  'bulging wall': bulgingWallNodes,
};

/** Puts node materials in the place of the demo's shaders in GLSL, which `WebGPURenderer` does not run. */
export function translate(root: Object3D): void {
  root.traverse((object) => {
    const mesh = object as Mesh;
    if (!mesh.isMesh || Array.isArray(mesh.material)) return;
    // Translated before: scenery may come in later.
    if ((mesh.material as { isNodeMaterial?: boolean }).isNodeMaterial === true) return;
    const like = LIKES[mesh.material.name];
    if (like !== undefined) mesh.material = like(mesh.material);
  });
}
