import {
  BackSide,
  BatchedMesh,
  BoxGeometry,
  type BufferAttribute,
  BufferGeometry,
  DataTexture,
  Float32BufferAttribute,
  InstancedMesh,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Scene,
  SkinnedMesh,
  WebGLRenderer,
} from 'three';
import { CubeCollider } from 'three-cube-collider';

const plain = new MeshBasicMaterial();

function named<T extends Mesh>(name: string, mesh: T, change: (mesh: T) => void = () => {}): T {
  mesh.name = name;
  // Above the centre: in the way of nothing that is measured, and within reach.
  mesh.position.set(0, 1, 0);
  change(mesh);
  return mesh;
}

function targets(): BufferGeometry {
  const geometry = new BoxGeometry();
  geometry.morphAttributes.position = [geometry.attributes.position!.clone()];
  return geometry;
}

/** What three cannot draw, or cannot draw anywhere. */
function faulty(): Mesh[] {
  const box = () => new BoxGeometry(0.5, 0.5, 0.5);
  const nowhere = new BufferGeometry();
  nowhere.setAttribute('position', new Float32BufferAttribute([], 3));
  const morphing = new Mesh(targets(), plain);
  morphing.morphTargetInfluences = undefined;
  const batch = new BatchedMesh(1, 24, 36, plain);
  batch.addInstance(batch.addGeometry(box()));
  return [
    named('place NaN', new Mesh(box(), plain), (mesh) => mesh.position.setX(NaN)),
    named('place infinite', new Mesh(box(), plain), (mesh) => mesh.position.setX(Infinity)),
    named('scale NaN', new Mesh(box(), plain), (mesh) => mesh.scale.setScalar(NaN)),
    named('scale 0', new Mesh(box(), plain), (mesh) => mesh.scale.setScalar(0)),
    named('flat', new Mesh(box(), plain), (mesh) => mesh.scale.setY(0)),
    named('never culled', new Mesh(box(), plain), (mesh) => {
      mesh.scale.setX(NaN);
      mesh.frustumCulled = false;
    }),
    named('empty', new Mesh(nowhere, plain)),
    named('no position', new Mesh(new BufferGeometry(), plain)),
    named('no triangles', new Mesh(box().setIndex([]), plain)),
    named('material null', new Mesh(box(), null as unknown as Material)),
    named('material undefined', new Mesh(box(), plain), (mesh) => {
      mesh.material = undefined as unknown as MeshBasicMaterial;
    }),
    named('never bound', new SkinnedMesh(box(), plain), (mesh) => {
      mesh.skeleton = undefined as never;
    }),
    named('no influences', morphing),
    named('disposed batch', batch, (mesh) => mesh.dispose()),
  ];
}

/** What looks wrong and is drawn all the same, each with what it shows of a box a metre toward +X. */
const drawnAnyway: Record<string, (renderer: WebGLRenderer) => Mesh> = {
  'disposed geometry'(renderer) {
    const mesh = new Mesh(new BoxGeometry(), plain);
    renderer.render(new Scene().add(mesh), new PerspectiveCamera());
    mesh.geometry.dispose();
    return mesh;
  },
  'disposed texture and material'() {
    const map = new DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1);
    const mesh = new Mesh(new BoxGeometry(), new MeshBasicMaterial({ map }));
    map.dispose();
    mesh.material.dispose();
    return mesh;
  },
  'a material of several missing'() {
    const geometry = new BoxGeometry();
    const worn = [plain, plain, plain, plain, plain, null as never];
    return new Mesh<BoxGeometry, MeshBasicMaterial[]>(geometry, worn);
  },
  'an instance that is nowhere'() {
    const mesh = new InstancedMesh(new BoxGeometry(), plain, 2);
    mesh.setMatrixAt(0, new Matrix4().makeScale(NaN, 1, 1));
    return mesh;
  },
  'positions thrown away once uploaded'() {
    const mesh = new Mesh(new BoxGeometry(), plain);
    const position = mesh.geometry.attributes.position as BufferAttribute;
    position.onUploadCallback = () => Object.assign(position, { array: null });
    return mesh;
  },
};

/** Fields of a room with and without what is faulty, all warnings, and what is seen of what only looks so. */
export default function faults() {
  const renderer = new WebGLRenderer();
  const warnings: string[] = [];
  const { warn } = console;
  console.warn = (...message: unknown[]) => warnings.push(message.join(' '));
  const room = () => new Mesh(new BoxGeometry(4, 4, 4), new MeshBasicMaterial({ side: BackSide }));
  const scene = new Scene().add(room());
  const collider = new CubeCollider({ far: 3, readback: 'sync' });
  collider.update(renderer, scene);
  const alone = [...collider.field!.distance];
  const broken = faulty();
  scene.add(...broken);
  for (let i = 0; i < 3; i++) {
    collider.update(renderer, scene);
    collider.survey(scene);
  }
  const beside = [...collider.field!.distance];
  const objects = collider.field!.objects.length;

  const seen: Record<string, number> = {};
  for (const [name, make] of Object.entries(drawnAnyway)) {
    const mesh = make(renderer);
    mesh.position.x = 1.5;
    const around = new Scene().add(room(), mesh);
    // The second time all is uploaded, and what was thrown away is gone.
    for (let i = 0; i < 2; i++) {
      mesh.geometry.boundingSphere = null;
      collider.update(renderer, around);
    }
    const { resolution: n, distance } = collider.field!;
    seen[name] = Math.round(100 * distance[(n / 2) * n + n / 2]!) / 100;
  }
  console.warn = warn;
  collider.dispose();
  renderer.dispose();
  return {
    same: alone.every((distance, i) => distance === beside[i]),
    objects,
    names: broken.map(({ name }) => name),
    warnings: warnings.filter((warning) => warning.startsWith('CubeCollider')),
    seen,
  };
}
