// The page's half of sheet.mjs.

import {
  ACESFilmicToneMapping,
  AnimationMixer,
  Color,
  DirectionalLight,
  GridHelper,
  HemisphereLight,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const MOMENTS = 8;
/** Where the camera stands: to the right, in front. */
const VIEWS = [
  [-5.2, 1.1, 0.9],
  [0.9, 1.1, 5.2],
];

export async function openSheet(url) {
  const renderer = new WebGLRenderer({ antialias: true });
  const [width, height] = [innerWidth, innerHeight];
  renderer.setSize(width, height);
  renderer.toneMapping = ACESFilmicToneMapping;
  renderer.autoClear = false;
  document.body.append(renderer.domElement);
  const scene = new Scene();
  scene.background = new Color('#b9c4c6');
  const sun = new DirectionalLight('#ffe6c4', 3.2);
  sun.position.set(-3, 5, 4);
  const grid = new GridHelper(4, 16, '#77808a', '#8f9aa2');
  scene.add(sun, new HemisphereLight('#a9c9dc', '#b89f7c', 2.3), grid);
  const { scene: figure, animations } = await new GLTFLoader().loadAsync(url);
  scene.add(figure);
  const mixer = new AnimationMixer(figure);
  const cell = { width: width / MOMENTS, height: height / VIEWS.length };
  const camera = new PerspectiveCamera(22, cell.width / cell.height, 0.1, 50);
  return {
    names: animations.map(({ name }) => name),
    draw(name) {
      mixer.stopAllAction();
      const clip = animations.find((clip) => clip.name === name);
      const action = mixer.clipAction(clip).play();
      renderer.setScissorTest(true);
      for (let i = 0; i < MOMENTS; i++) {
        action.time = (clip.duration * i) / MOMENTS;
        mixer.update(0);
        VIEWS.forEach((place, row) => {
          camera.position.set(...place);
          camera.lookAt(0, 0.88, 0);
          const area = [
            i * cell.width,
            (VIEWS.length - 1 - row) * cell.height,
            cell.width,
            cell.height,
          ];
          renderer.setViewport(...area);
          renderer.setScissor(...area);
          renderer.clear();
          renderer.render(scene, camera);
        });
      }
    },
  };
}
