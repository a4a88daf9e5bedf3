import { BufferAttribute, Mesh, MeshBasicMaterial, Scene, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { terrain } from '../../../test/support/terrain.js';
import type { MovingCase, MovingRival } from './MovingCase.js';
import { pushOut, SUB_STEPS } from './pushOut.js';

const SIZE = 100;

/** A terrain that heaves as a whole, by one morph target. */
export function morph(triangles: number): MovingCase {
  const geometry = terrain(Math.round(Math.sqrt(triangles / 2)), SIZE);
  const base = geometry.attributes.position!.array as Float32Array;
  const swell = new Float32Array(base.length);
  for (let i = 0; i < base.length; i += 3) {
    swell[i + 1] = 0.3 * Math.sin(0.2 * base[i]! + 0.3 * base[i + 2]!);
  }
  geometry.morphAttributes.position = [new BufferAttribute(swell, 3)];
  geometry.morphTargetsRelative = true;
  geometry.computeBoundingSphere();
  const mesh = new Mesh(geometry, new MeshBasicMaterial());
  const influences = mesh.morphTargetInfluences!;
  const scene = new Scene().add(mesh);
  return {
    name: `morphing terrain, ${triangles / 1000}k triangles`,
    scene,
    foot: new Vector3(0.571, 0.6, 0),
    move(frame) {
      influences[0] = Math.sin(0.05 * frame);
    },
    rivals: () => [refitted(mesh, base, swell, new Vector3(0.571, 0.31, 0))],
    cannot: { Octree: 'cannot but be rebuilt', Rapier: 'cannot but be rebuilt' },
  };
}

/** Its positions made by the processor, as the GPU makes its own, and its tree refitted. */
function refitted(mesh: Mesh, base: Float32Array, swell: Float32Array, foot: Vector3): MovingRival {
  const own = mesh.geometry.clone();
  own.morphAttributes = {};
  const position = own.attributes.position!.array as Float32Array;
  const bvh = new MeshBVH(own);
  return {
    name: 'three-mesh-bvh',
    frame() {
      const influence = mesh.morphTargetInfluences![0]!;
      for (let i = 0; i < position.length; i++) position[i] = base[i]! + influence * swell[i]!;
      bvh.refit();
      for (let i = 0; i < SUB_STEPS; i++) pushOut(bvh, mesh, foot);
    },
    dispose() {
      // nothing but memory
    },
  };
}
