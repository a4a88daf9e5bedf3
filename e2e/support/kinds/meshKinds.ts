import {
  BackSide,
  BufferAttribute,
  type BufferGeometry,
  Group,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  LOD,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  PerspectiveCamera,
  Scene,
  SphereGeometry,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { type Kind, lump, type MakeKind, plain, reshape } from './Kind.js';

function meshKind(geometry: BufferGeometry, change: (geometry: BufferGeometry) => void): Kind {
  const mesh = new Mesh(geometry, plain);
  return { object: mesh, shown: () => [{ mesh }], change: () => change(geometry) };
}

/** Taller, in place. */
function stretch(geometry: BufferGeometry): void {
  reshape(geometry, (x, y, z) => [x, 1.2 * y + 0.1 * x, z]);
  geometry.attributes.position!.needsUpdate = true;
  geometry.computeBoundingSphere();
}

/** Positions as whole numbers that stand for -1 to 1. */
function quantised(Type: typeof Int16Array | typeof Int8Array): Kind {
  const geometry = lump();
  const { array, count } = geometry.attributes.position!;
  const most = Type === Int16Array ? 32767 : 127;
  const stored = new Type(array.length);
  for (let i = 0; i < stored.length; i++) stored[i] = Math.round(2 * most * array[i]!);
  geometry.setAttribute('position', new BufferAttribute(stored, 3, true));
  geometry.computeBoundingSphere();
  const kind = meshKind(geometry, (geometry) => {
    for (let i = 0; i < count; i++) stored[3 * i + 1] = Math.round(0.8 * stored[3 * i + 1]!);
    geometry.attributes.position!.needsUpdate = true;
  });
  // Stored at twice its size.
  const holder = new Group().add(kind.object);
  kind.object.scale.setScalar(0.5);
  return { ...kind, object: holder };
}

function lod(settle: (lod: LOD) => void): Kind {
  const levels = [0.3, 0.22, 0.15].map(
    (radius, i) => new Mesh(new SphereGeometry(radius, 12 - 3 * i, 9 - 2 * i), plain),
  );
  const object = new LOD();
  levels.forEach((mesh, i) => object.addLevel(mesh, [0, 5, 20][i]));
  // It has other things to show than its levels, at any distance.
  const sign = new Mesh(new SphereGeometry(0.1, 8, 6), plain);
  sign.position.y = 0.4;
  object.add(sign);
  settle(object);
  let level = object.getCurrentLevel();
  return {
    object,
    shown: () => [{ mesh: levels[level]! }, { mesh: sign }],
    change: () => {
      // As a render from 8 m away does.
      const camera = new PerspectiveCamera();
      camera.position.setFromMatrixPosition(object.matrixWorld).x += 8;
      camera.updateMatrixWorld();
      object.update(camera);
      level = 1;
    },
  };
}

/** `Mesh` in all its storages, and what holds meshes. */
export const meshKinds: Record<string, MakeKind> = {
  'Mesh, 16-bit indices': () => meshKind(lump(), stretch),

  'Mesh, 32-bit indices': () => {
    const geometry = lump();
    const wide = new Uint32Array(geometry.index!.array);
    geometry.setIndex(new BufferAttribute(wide, 1));
    return meshKind(geometry, () => {
      wide.copyWithin(0, wide.length / 2);
      geometry.index!.needsUpdate = true;
    });
  },

  'Mesh, not indexed': () =>
    meshKind(lump().toNonIndexed(), (geometry) => {
      // Another attribute, of another length.
      const { array } = geometry.attributes.position!;
      geometry.setAttribute('position', new BufferAttribute(array.slice(0, 9 * 300), 3));
    }),

  'Mesh, drawRange': () => {
    const geometry = lump();
    geometry.setDrawRange(90, 600);
    return meshKind(geometry, () => geometry.setDrawRange(600, Infinity));
  },

  'Mesh, several materials and groups': () => {
    const geometry = lump();
    geometry.addGroup(0, 480, 0);
    geometry.addGroup(480, 480, 1);
    geometry.addGroup(960, 480, 2);
    const glass = new MeshBasicMaterial({ transparent: true, opacity: 0.3 });
    const inside = new MeshBasicMaterial({ side: BackSide });
    const mesh = new Mesh(geometry, [plain, glass, inside]);
    let solid = [0, 2];
    return {
      object: mesh,
      shown: () => [{ mesh, solid }],
      change: () => {
        mesh.material = [glass, plain, inside];
        geometry.setDrawRange(600, 600);
        solid = [1, 2];
      },
    };
  },

  'Mesh, interleaved': () => {
    const geometry = lump();
    const { array, count } = geometry.attributes.position!;
    const mixed = new Float32Array(8 * count).fill(0.5);
    for (let i = 0; i < count; i++) mixed.set(array.subarray(3 * i, 3 * i + 3), 8 * i + 2);
    const buffer = new InterleavedBuffer(mixed, 8);
    geometry.setAttribute('position', new InterleavedBufferAttribute(buffer, 3, 2));
    return meshKind(geometry, stretch);
  },

  'Mesh, normalized Int16': () => quantised(Int16Array),
  'Mesh, normalized Int8': () => quantised(Int8Array),

  'Mesh, KHR_mesh_quantization from a GLB': async (_renderer, glb) => {
    const { scene } = await new GLTFLoader().parseAsync(glb!.buffer, '');
    const meshes: Mesh[] = [];
    scene.traverse((object) => {
      if ((object as Mesh).isMesh) meshes.push(object as Mesh);
    });
    const { array } = meshes[0]!.geometry.attributes.position!;
    if (meshes.length !== 1 || array instanceof Float32Array) throw new Error('not quantised');
    return {
      object: new Group().add(scene),
      shown: () => meshes.map((mesh) => ({ mesh })),
      change: () => void (meshes[0]!.rotation.y += 0.7),
    };
  },

  'Mesh, sheared by its parents': () => {
    const kind = meshKind(lump(), () => void (kind.object.rotation.x += 0.5));
    const middle = new Group().add(kind.object);
    middle.scale.set(1.4, 0.7, 1);
    middle.rotation.z = 0.5;
    kind.object.rotation.z = 0.6;
    const object: Object3D = new Group().add(middle);
    return { ...kind, object };
  },

  'LOD, never rendered': () => lod(() => {}),

  'LOD, rendered': (renderer) =>
    lod((object) => {
      const camera = new PerspectiveCamera();
      camera.position.z = 30;
      renderer.render(new Scene().add(object), camera);
    }),
};
