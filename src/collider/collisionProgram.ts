import { GLSL3, type GLSLVersion, type IUniform } from 'three';
import {
  axisFragmentShader,
  collisionVertexShader,
  surfaceFragmentShader,
} from './collisionShader.js';
import type { CollisionMaterialSettings } from './CollisionMaterials.js';

/** The shaders of one collider, and the uniforms that all its materials share. */
export interface CollisionProgram {
  /** Tells it from the programs of colliders that draw otherwise. */
  readonly key: string;
  readonly vertexShader: string;
  readonly fragmentShader: string;
  /** Null where it puts out a colour as three's own do. */
  readonly glslVersion: GLSLVersion | null;
  readonly uniforms: Readonly<Record<string, IUniform>>;
}

/** @param far shared by all, so that there is one value to set */
export function collisionProgram(
  { output, format, resolution, near, rMin, rMax }: CollisionMaterialSettings,
  far: IUniform<number>,
): CollisionProgram {
  const axis = output === 'axis';
  return {
    key: `CubeCollider ${output} ${axis ? '' : format}`,
    vertexShader: collisionVertexShader,
    fragmentShader: axis ? axisFragmentShader : surfaceFragmentShader(format),
    glslVersion: axis ? null : GLSL3,
    uniforms: {
      resolution: { value: resolution },
      near: { value: near },
      far,
      ...(axis ? { rMin: { value: rMin }, rMax: { value: rMax } } : {}),
    },
  };
}
