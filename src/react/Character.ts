import { useFrame, useThree } from '@react-three/fiber';
import {
  createElement,
  type ReactElement,
  Suspense,
  useContext,
  useEffect,
  useImperativeHandle,
  useLayoutEffect,
  useRef,
  useState,
} from 'react';
import { type Group, Vector3 } from 'three';
import { applyProps, bodyOf, type CharacterProps, fieldsOf } from './characterProps.js';
import { useControls } from './useControls.js';
import { useCharacterEvents } from './useCharacterEvents.js';
import { useShallow } from './useShallow.js';
import { Walker } from './Walker.js';
import { WalkerContext, World, WorldContext } from './World.js';

/** Before every `useFrame` without a priority: those see where character and camera are now. */
const PRIORITY = -1;

const _position = /* @__PURE__ */ new Vector3();

/**
 * A character that walks among whatever is drawn: a `CharacterController` with its collider, for React Three Fiber.
 *
 * ```jsx
 * <Canvas>
 *   <Suspense>
 *     <Level />
 *     <Character position={[0, 1, 0]} controls={{ view: 'third' }} onLand={({ speed }) => thud(speed)}>
 *       <Robot />
 *     </Character>
 *   </Suspense>
 * </Canvas>
 * ```
 *
 * The children are its avatar. It moves before other `useFrame` callbacks, and nothing renders anew because it moves.
 * With `frameloop="demand"` it asks for frames as long as it moves or waits for a cubemap. While the `Suspense` around it
 * is suspended it is held, and goes on where it was. Place it, and what it is inside of, without a transform: it lives in
 * world space.
 */
export function Character(props: CharacterProps): ReactElement {
  const { children, ref, paused = false } = props;
  const [ownWorld] = useState(() => new World());
  const world = useContext(WorldContext) ?? ownWorld;
  const invalidate = useThree((state) => state.invalidate);
  const avatar = useRef<Group>(null);
  const current = useRef<Made | null>(null);
  const [walker, setWalker] = useState<Walker | null>(null);
  const body = useShallow(bodyOf(props));
  const collider = useShallow(props.collider);
  const place = useShallow(coordinates(props.position));

  // In a layout effect, so that `ref` is set before the effects of those around it.
  useLayoutEffect(() => {
    const last = current.current;
    const parts = [body, collider, world];
    if (last === null || parts.some((part, i) => part !== last.parts[i])) {
      const walker = new Walker(
        world.createCollider(collider),
        { ...body, ...fieldsOf(props) },
        avatar.current!,
        invalidate,
      );
      walker.character.teleport(last?.walker.character.position ?? _position.fromArray(place));
      current.current = { walker, world, parts, place: last?.place ?? place, props };
      if (last !== null) discard(last);
    } else {
      // Shown again, maybe with another level around it.
      last.walker.collider.invalidate();
    }
    const { walker } = current.current!;
    setWalker(walker);
    world.add(walker);
    return () => world.remove(walker);
    // Of `place` and the other props it has what they are now; the next effect follows them.
  }, [body, collider, world, invalidate]);

  useLayoutEffect(() => {
    const made = current.current!;
    if (made.place !== place) made.walker.character.teleport(_position.fromArray(place));
    made.place = place;
    applyProps(made.walker, props, made.props);
    made.props = props;
    invalidate();
  });

  // Not with the layout effect, which `Suspense` undoes while it hides the character.
  useEffect(
    () => () => {
      if (current.current !== null) discard(current.current);
      current.current = null;
    },
    [],
  );

  useImperativeHandle(ref, () => current.current!.walker.character, [
    walker,
    body,
    collider,
    world,
  ]);
  useCharacterEvents(walker, props);
  useControls(walker, props.controls ?? false, props.keys !== undefined);

  useFrame(({ gl, scene, camera }, delta) => {
    if (paused || world.paused || current.current === null) return;
    if (current.current.walker.frame(gl, scene, camera, delta)) invalidate();
  }, PRIORITY);

  const inside = walker && createElement(WalkerContext.Provider, { value: walker }, children);
  return createElement('group', { ref: avatar }, createElement(Suspense, null, inside));
}

/** A walker, and what it was made of. */
interface Made {
  readonly walker: Walker;
  readonly world: World;
  readonly parts: readonly unknown[];
  /** Where it was put last. */
  place: readonly number[];
  /** Those it was given last. */
  props: CharacterProps;
}

function discard({ walker, world }: Made): void {
  world.release(walker.collider);
  walker.dispose();
}

type Place = [x: number, y: number, z: number];

function coordinates(position: CharacterProps['position']): Place {
  if (position === undefined) return [0, 0, 0];
  return 'isVector3' in position ? position.toArray() : [...position];
}
