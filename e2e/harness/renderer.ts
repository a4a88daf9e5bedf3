import {
  ArrayCamera,
  BackSide,
  BoxGeometry,
  DataTexture,
  DirectionalLight,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  Vector4,
  WebGLRenderer,
} from 'three';
import { Reflector } from 'three/addons/objects/Reflector.js';
import { Water } from 'three/addons/objects/Water.js';
import { EffectComposer } from 'three/addons/postprocessing/EffectComposer.js';
import { OutputPass } from 'three/addons/postprocessing/OutputPass.js';
import { RenderPass } from 'three/addons/postprocessing/RenderPass.js';
import { CubeCollider } from 'three-cube-collider';

const SIZE = 96;

/** A lit room with shadows, a mirror 1 m toward -X and water 1 m below the origin; walls 2 m away. */
function makeScene(): Scene {
  const room = new Mesh(new BoxGeometry(4, 4, 4), new MeshStandardMaterial({ side: BackSide }));
  room.receiveShadow = true;
  const crate = new Mesh(new BoxGeometry(0.5, 0.5, 0.5), new MeshStandardMaterial());
  crate.position.set(0.6, -0.3, -1);
  crate.castShadow = true;
  const sun = new DirectionalLight(0xffffff, 3);
  sun.position.set(0.5, 1.5, 1);
  sun.castShadow = true;
  const mirror = new Reflector(new PlaneGeometry(1, 1), { textureWidth: 64, textureHeight: 64 });
  mirror.position.x = -1;
  mirror.rotation.y = Math.PI / 2;
  const waves = new DataTexture(new Uint8Array([128, 140, 255, 255]), 1, 1);
  waves.needsUpdate = true;
  const water = new Water(new PlaneGeometry(4, 4), {
    textureWidth: 64,
    textureHeight: 64,
    waterNormals: waves,
  });
  water.position.y = -1;
  water.rotation.x = -Math.PI / 2;
  return new Scene().add(room, crate, sun, mirror, water);
}

function makeCamera(): PerspectiveCamera {
  const camera = new PerspectiveCamera(70, 1, 0.1, 20);
  camera.position.set(1, 0.6, 1.6);
  camera.lookAt(-0.2, -0.5, -0.6);
  camera.updateMatrixWorld();
  return camera;
}

/** Ways to draw a frame onto the canvas. */
const ways = {
  plainly(renderer: WebGLRenderer, scene: Scene) {
    const camera = makeCamera();
    return () => renderer.render(scene, camera);
  },
  'through an EffectComposer'(renderer: WebGLRenderer, scene: Scene) {
    const composer = new EffectComposer(renderer);
    composer.addPass(new RenderPass(scene, makeCamera()));
    composer.addPass(new OutputPass());
    return () => composer.render(0.016);
  },
  'without clearing by itself'(renderer: WebGLRenderer, scene: Scene) {
    renderer.autoClear = false;
    const camera = makeCamera();
    return () => {
      renderer.clear();
      renderer.render(scene, camera);
    };
  },
  'with an ArrayCamera'(renderer: WebGLRenderer, scene: Scene) {
    const eyes = [0, 1].map((eye) => {
      const camera = makeCamera();
      camera.position.x += 0.06 * eye;
      camera.updateMatrixWorld();
      // The type of the eyes wants a viewport.
      return Object.assign(camera, {
        viewport: new Vector4((eye * SIZE) / 2, 0, SIZE / 2, SIZE),
      });
    });
    const camera = new ArrayCamera(eyes);
    camera.position.copy(eyes[0]!.position);
    camera.quaternion.copy(eyes[0]!.quaternion);
    camera.projectionMatrix.copy(eyes[0]!.projectionMatrix);
    return () => renderer.render(scene, camera);
  },
};

export type FrameWay = keyof typeof ways;

/** Frames drawn one way, with and without the collider before them, and what the collider saw. */
export default function renderers({ way, others }: { way: FrameWay; others: boolean }) {
  const renderer = new WebGLRenderer();
  renderer.setSize(SIZE, SIZE);
  renderer.shadowMap.enabled = true;
  const scene = makeScene();
  const frame = ways[way](renderer, scene);
  const gl = renderer.getContext();
  const picture = () => {
    frame();
    const pixels = new Uint8Array(4 * SIZE * SIZE);
    gl.readPixels(0, 0, SIZE, SIZE, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
  };
  const stateOf = () =>
    JSON.stringify([
      renderer.getRenderTarget() === null,
      renderer.autoClear,
      renderer.xr.enabled,
      renderer.shadowMap.autoUpdate,
      renderer.shadowMap.needsUpdate,
      renderer.info.render.calls,
      renderer.info.autoReset,
    ]);
  const collider = new CubeCollider({ far: 3, readback: 'sync' });
  // Another renderer that draws the same scene, with a collider of its own.
  const other = others ? new WebGLRenderer() : null;
  const otherCollider = new CubeCollider({ far: 3, readback: 'sync' });

  picture();
  const alone = picture();
  const state: string[] = [];
  let differing = 0;
  for (let i = 0; i < 2; i++) {
    const before = stateOf();
    collider.update(renderer, scene);
    state.push(before, stateOf());
    if (other !== null) {
      otherCollider.update(other, scene);
      other.render(scene, makeCamera());
    }
    const beside = picture();
    for (let byte = 0; byte < alone.length; byte++) if (alone[byte] !== beside[byte]) differing++;
  }
  const ahead = ({ field }: CubeCollider) => {
    const { resolution: n, distance } = field!;
    // +X, -X, +Y, -Y: the wall, the mirror, the ceiling, the water.
    return [0, 1, 2, 3].map(
      (face) => Math.round(1000 * distance[face * n * n + (n / 2) * n + n / 2]!) / 1000,
    );
  };
  const report = {
    colours: new Set(new Uint32Array(alone.buffer)).size,
    differing,
    stateKept: state[0] === state[1] && state[2] === state[3],
    seen: ahead(collider),
    otherSeen: other === null ? null : ahead(otherCollider),
  };
  for (const each of [collider, otherCollider]) each.dispose();
  for (const each of [renderer, other]) each?.dispose();
  return report;
}
