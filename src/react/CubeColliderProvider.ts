import { useFrame } from '@react-three/fiber';
import { createElement, type ReactElement, type ReactNode, useState } from 'react';
import type { CubeColliderGroupOptions } from '../collider/CubeColliderGroup.js';
import type { CubeColliderOptions } from '../collider/CubeColliderOptions.js';
import { CubeCollider } from '../collider/CubeCollider.js';
import { type ColliderClass, World, WorldContext } from './World.js';

/** After the characters, which move before every `useFrame` without a priority. */
const GROUP_PRIORITY = -0.5;

/** Props of `<CubeColliderProvider>`. */
export interface CubeColliderProviderProps {
  /** Options of each character's collider; its own `collider` goes before them. Characters that are there keep theirs. */
  options?: CubeColliderOptions;
  /**
   * Class of the colliders: with a `WebGPURenderer` the `CubeCollider` of `three-cube-collider/webgpu`. Default that of
   * the root entry.
   */
  type?: ColliderClass;
  /** Draws the characters' cubemaps together, by a `CubeColliderGroup`: for crowds. Default false. */
  group?: boolean | CubeColliderGroupOptions;
  /** Holds all characters still. Default false. */
  paused?: boolean;
  /** Characters, and what asks for them. */
  children?: ReactNode;
}

/**
 * What the characters inside share: options of their colliders, whether their cubemaps are drawn together, a pause.
 * Inside `<Canvas>`; a single `<Character>` does without.
 *
 * ```jsx
 * <CubeColliderProvider options={{ resolution: 24 }} group>
 *   {places.map((place) => <Character key={place.name} position={place.position} />)}
 * </CubeColliderProvider>
 * ```
 */
export function CubeColliderProvider(props: CubeColliderProviderProps): ReactElement {
  const { options = {}, type = CubeCollider, group = false, paused = false, children } = props;
  const [world] = useState(() => new World());
  world.options = options;
  world.type = type;
  world.groupOptions = group === false ? null : group === true ? {} : group;
  world.paused = paused;
  useFrame(({ gl, scene }) => {
    if (!world.paused) world.draw(gl, scene);
  }, GROUP_PRIORITY);
  return createElement(WorldContext.Provider, { value: world }, children);
}
