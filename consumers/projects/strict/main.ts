// A fresh app in strict TypeScript that uses every entry; it is compiled, not run.
import { createElement } from 'react';
import { PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import {
  CharacterController,
  type CharacterEventMap,
  CharacterControls,
  type CharacterOptions,
  type Contact,
  CubeCollider,
  CubeColliderGroup,
  type CubeColliderOptions,
  DEFAULTS,
  type SurfaceField,
} from 'three-cube-collider';
import { CubeColliderHelper } from 'three-cube-collider/helpers';
import {
  Character,
  type CharacterProps,
  CubeColliderProvider,
  useCharacter,
} from 'three-cube-collider/react';
import { CubeCollider as NodeCubeCollider } from 'three-cube-collider/webgpu';
import { WebGPURenderer } from 'three/webgpu';

const renderer = new WebGLRenderer();
const scene = new Scene();
const camera = new PerspectiveCamera();

const seen: CubeColliderOptions = {
  resolution: 32,
  supersample: 4,
  filter: (each) => each.visible,
};
const built: CharacterOptions = { radius: DEFAULTS.character.radius, up: new Vector3(0, 1, 0) };
const collider = new CubeCollider(seen);
const character = new CharacterController(collider, built);
const controls = new CharacterControls(character, camera, renderer.domElement, { view: 'third' });
const helper = new CubeColliderHelper(collider);
const group = new CubeColliderGroup();
group.add(new CubeCollider());

const landed = ({ speed }: CharacterEventMap['land']): string => speed.toFixed(1);
character.addEventListener('land', landed);
character.addEventListener('contact', ({ object, sensor }) => console.log(object.name, sensor));

renderer.setAnimationLoop((time: number) => {
  controls.update(time / 1000);
  character.update(renderer, scene, time / 1000);
  const touched: readonly Readonly<Contact>[] = character.contacts;
  const field: SurfaceField | null = collider.field;
  console.log(touched.length, field?.distance[0]);
  renderer.render(scene, camera);
  helper.render(renderer);
});

const nodes = new WebGPURenderer();
const other = new CharacterController(new NodeCubeCollider());
other.update(nodes, scene, 1 / 60);

const props: CharacterProps = {
  position: [0, 1, 0],
  controls: { view: 'third' },
  onLand: ({ speed }) => console.log(speed, useCharacter()?.grounded),
};
createElement(CubeColliderProvider, { type: NodeCubeCollider }, createElement(Character, props));

// @ts-expect-error there is no such option
new CubeCollider({ resolutoin: 32 });
// @ts-expect-error an event that is not sent
character.addEventListener('landed', () => undefined);
