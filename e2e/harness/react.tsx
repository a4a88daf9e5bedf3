import { KeyboardControls, useKeyboardControls } from '@react-three/drei/web/KeyboardControls';
import { Canvas, useFrame, useLoader, useThree } from '@react-three/fiber';
import { StrictMode, Suspense, useEffect, useRef, useState } from 'react';
import { createRoot } from 'react-dom/client';
import { Group, Vector3, type WebGLRenderer } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { CharacterController, CubeCollider } from 'three-cube-collider';
import {
  Character,
  CubeColliderProvider,
  useCharacter,
  useCubeCollider,
} from 'three-cube-collider/react';

/** What the test reads and does. */
export interface ReactHarness {
  character: CharacterController | null;
  collider: CubeCollider | null;
  seen: CharacterController | null;
  avatar: Group | null;
  gl: WebGLRenderer | null;
  frames: number;
  renders: number;
  events: string[];
  show(what: Partial<Shown>): void;
}

interface Shown {
  level: string;
  character: boolean;
  height: number;
}

declare global {
  interface Window {
    harness: ReactHarness;
  }
}

const harness: ReactHarness = (window.harness = {
  character: null,
  collider: null,
  seen: null,
  avatar: null,
  gl: null,
  frames: 0,
  renders: 0,
  events: [],
  show: () => undefined,
});

function Level({ url }: { url: string }) {
  const { scene } = useLoader(GLTFLoader, url);
  return <primitive object={scene} />;
}

function Walking({ height }: { height: number }) {
  harness.renders++;
  const [, get] = useKeyboardControls();
  const character = useRef<CharacterController>(null);
  // In the first effect already: whoever holds the ref may use it there.
  useEffect(() => {
    character.current!.jumpBuffer = 0.2;
    harness.character = character.current;
  });
  return (
    <Character
      ref={character}
      position={[0, 0.5, 0]}
      height={height}
      stepHeight={0.3}
      keys={get}
      onLand={() => harness.events.push('land')}
      onJump={() => harness.events.push('jump')}
    >
      <Robot />
    </Character>
  );
}

/** Its avatar; it knows whose it is. */
function Robot() {
  harness.renders++;
  const group = useRef<Group>(null);
  const collider = useCubeCollider();
  useEffect(() => {
    harness.avatar = group.current;
    harness.collider = collider;
  });
  return (
    <group ref={group}>
      <mesh position-y={0.9}>
        <capsuleGeometry args={[0.3, 1.2]} />
        <meshNormalMaterial />
      </mesh>
    </group>
  );
}

/** Beside the character: looks over its shoulder. */
function Follow() {
  harness.renders++;
  const character = useCharacter();
  const gl = useThree((state) => state.gl);
  useEffect(() => {
    harness.seen = character;
    harness.gl = gl;
  });
  useFrame(({ camera }) => {
    harness.frames++;
    if (character) camera.position.copy(character.position).add(new Vector3(0, 2.2, 4));
  });
  return null;
}

function App() {
  const [shown, setShown] = useState<Shown>({ level: '/level.glb', character: true, height: 1.8 });
  harness.show = (what) => setShown((before) => ({ ...before, ...what }));
  return (
    <KeyboardControls
      map={[
        { name: 'forward', keys: ['KeyW'] },
        { name: 'backward', keys: ['KeyS'] },
        { name: 'left', keys: ['KeyA'] },
        { name: 'right', keys: ['KeyD'] },
        { name: 'jump', keys: ['Space'] },
      ]}
    >
      <Canvas frameloop="demand" style={{ width: 320, height: 180 }}>
        <hemisphereLight intensity={3} />
        <CubeColliderProvider options={{ resolution: 24 }}>
          <Suspense fallback={null}>
            <Level url={shown.level} />
            {shown.character && <Walking height={shown.height} />}
          </Suspense>
          <Follow />
        </CubeColliderProvider>
      </Canvas>
    </KeyboardControls>
  );
}

createRoot(document.getElementById('root')!).render(
  <StrictMode>
    <App />
  </StrictMode>,
);
