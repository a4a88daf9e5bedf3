// A tiny app that walks without keys, and says in the page's title how far it came.
import {
  BoxGeometry,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Scene,
  Timer,
  Vector3,
} from 'three';
import { WebGLRenderer } from 'three';
import { CharacterController, CubeCollider } from 'three-cube-collider';

const renderer = new WebGLRenderer();
renderer.setSize(160, 90);
document.body.append(renderer.domElement);
const camera = new PerspectiveCamera(70, 16 / 9, 0.05, 50);
camera.position.set(0, 2, 6);
const scene = new Scene();
const floor = new Mesh(new BoxGeometry(20, 1, 20), new MeshBasicMaterial({ color: 0x557755 }));
floor.position.y = -0.5;
const wall = new Mesh(new BoxGeometry(20, 3, 1), new MeshBasicMaterial({ color: 0x775555 }));
wall.position.set(0, 1.5, -2);
scene.add(floor, wall);

const character = new CharacterController(new CubeCollider());
character.teleport(new Vector3(0, 0.5, 0));
character.walk(new Vector3(0, 0, -3));
const timer = new Timer();
renderer.setAnimationLoop((time) => {
  character.update(renderer, scene, timer.update(time).getDelta());
  renderer.render(scene, camera);
  const { y, z } = character.position;
  if (character.ready) document.title = `at ${y.toFixed(2)} ${z.toFixed(2)}`;
});
