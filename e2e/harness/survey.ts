import {
  Bone,
  BoxGeometry,
  Float32BufferAttribute,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Scene,
  Skeleton,
  SkinnedMesh,
  Uint16BufferAttribute,
  WebGLRenderer,
} from 'three';
import { CubeCollider, type CubeColliderOptions } from 'three-cube-collider';

const material = new MeshBasicMaterial();

function skinned(): { mesh: SkinnedMesh; bone: Bone } {
  const geometry = new BoxGeometry();
  const { count } = geometry.attributes.position!;
  const weights = Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0));
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(new Uint16Array(4 * count), 4));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
  const bone = new Bone();
  const mesh = new SkinnedMesh(geometry, material);
  mesh.add(bone);
  mesh.bind(new Skeleton([bone]));
  return { mesh, bone };
}

/**
 * What the survey says before and after each change, and after the next draw, between frames of the user's own; and
 * whether the field then tells of the change.
 */
export default async function survey(options: CubeColliderOptions) {
  const renderer = new WebGLRenderer();
  const camera = new PerspectiveCamera();
  camera.position.z = 6;
  const lift = new Mesh(new BoxGeometry(2, 0.1, 2), material);
  lift.position.y = -1;
  const door = new Mesh(new BoxGeometry(0.1, 2, 1), material);
  door.position.x = 1;
  const posts = new InstancedMesh(new BoxGeometry(0.2, 2, 0.2), material, 2);
  posts.setMatrixAt(0, new Matrix4().makeTranslation(-1, 0, 0));
  posts.setMatrixAt(1, new Matrix4().makeTranslation(-1, 0, 0.5));
  const coin = new Mesh(new BoxGeometry(0.2, 0.2, 0.2), material);
  coin.position.z = 0.5;
  coin.userData.sensor = true;
  const scene = new Scene().add(lift, door, posts, coin);
  const collider = new CubeCollider(options);

  const said: string[] = [];
  const look = () => {
    const { moved, changed, deforms, sensors } = collider.survey(scene);
    return (
      [moved && 'moved', changed && 'changed', deforms && 'deforms'].filter(Boolean).join('+') +
      `/${sensors.length}`
    );
  };
  const texels = (mesh: unknown) => {
    const { objects, object } = collider.field!;
    const number = objects.indexOf(mesh as Mesh) + 1;
    return number === 0 ? 0 : object.filter((each) => each === number).length;
  };
  const step = async (name: string, act: () => void) => {
    act();
    const before = look();
    renderer.render(scene, camera);
    const { draws } = collider.stats;
    const again = look();
    const drewNothing = collider.stats.draws === draws;
    await collider.updateAsync(renderer, scene);
    renderer.render(scene, camera);
    said.push(`${name}: ${before} ${again} -> ${look()}${drewNothing ? '' : ' drew'}`);
  };
  await step('no draw yet', () => {});
  await step('nothing', () => {});
  await step('a lift rose', () => (lift.position.y = -0.9));
  const doorBefore = texels(door);
  await step('a door hid', () => (door.visible = false));
  const doorAfter = texels(door);
  await step('an instance moved', () => {
    posts.setMatrixAt(1, new Matrix4().makeTranslation(-0.8, 0, 0.5));
    posts.instanceMatrix.needsUpdate = true;
  });
  const { mesh, bone } = skinned();
  mesh.position.set(0, 0, -1.95);
  await step('a skin came', () => scene.add(mesh));
  await step('a bone moved', () => (bone.position.x = 0.1));
  await step('the reach shrank', () => (collider.far = 0.4));
  await step('invalidated', () => collider.invalidate());
  const report = {
    said,
    doorBefore,
    doorAfter,
    coin: texels(coin),
    rigid: collider.field!.rigid.slice(),
    deforming: collider.stats.deforming,
  };
  collider.dispose();
  renderer.dispose();
  return report;
}
