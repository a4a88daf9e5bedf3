import { useContext, useSyncExternalStore } from 'react';
import type { CharacterController } from '../character/CharacterController.js';
import type { CubeCollider } from '../collider/CubeCollider.js';
import type { Walker } from './Walker.js';
import { WalkerContext, WorldContext } from './World.js';

const never = () => () => undefined;
const nobody = () => null;

/**
 * The character that a component is inside of; elsewhere below a `<CubeColliderProvider>`, the one mounted first, or null
 * while there is none. Read it in `useFrame`: nothing renders anew because it moves.
 *
 * ```jsx
 * function Footsteps() {
 *   const character = useCharacter();
 *   useFrame(() => (sound.current.volume = character.grounded ? character.velocity.length() / 6 : 0));
 * }
 * ```
 *
 * @throws Error outside both
 */
export function useCharacter(): CharacterController | null {
  return useWalker('useCharacter')?.character ?? null;
}

/**
 * The collider of the character that `useCharacter` returns: for its `field`, `stats`, or a `CubeColliderHelper`.
 *
 * @throws Error outside a `<Character>` and a `<CubeColliderProvider>`
 */
export function useCubeCollider<Collider = CubeCollider>(): Collider | null {
  return (useWalker('useCubeCollider')?.collider ?? null) as Collider | null;
}

function useWalker(hook: string): Walker | null {
  const own = useContext(WalkerContext);
  const world = useContext(WorldContext);
  const first = useSyncExternalStore(world?.subscribe ?? never, world?.first ?? nobody, nobody);
  if (own === null && world === null) {
    throw new Error(`${hook}: call it inside <Character> or <CubeColliderProvider>.`);
  }
  return own ?? first;
}
