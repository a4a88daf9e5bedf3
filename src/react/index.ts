/** The package for React Three Fiber: components and hooks around what the root entry has. */
export { Character } from './Character.js';
export type { CharacterEventProps, CharacterProps } from './characterProps.js';
export { CubeColliderProvider, type CubeColliderProviderProps } from './CubeColliderProvider.js';
export { useCharacter, useCubeCollider } from './hooks.js';
export type { PressedKeys } from './KeyWalk.js';
export type { OwnedCollider } from './Walker.js';
export type { ColliderClass } from './World.js';
